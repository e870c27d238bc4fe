// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a bank offers besides its registers (coils, files, functions of its own), passed on by a bank in front of it.
// Each part is there only where the bank has it, so that a server finds the same functions.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/pdu_buffer.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Passes everything but `check_write` and `write` on to a bank elsewhere.
template <typename Bank> class bank_parts {
public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return bank_->check_read(start, count);
    }
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        return bank_->read(start, count, out);
    }

    constexpr decltype(auto) coils() noexcept requires requires(Bank& at) { at.coils(); }
    {
        return bank_->coils();
    }
    constexpr decltype(auto) discrete_inputs() noexcept requires requires(Bank& at) { at.discrete_inputs(); }
    {
        return bank_->discrete_inputs();
    }
    constexpr decltype(auto) input_registers() noexcept requires requires(Bank& at) { at.input_registers(); }
    {
        return bank_->input_registers();
    }
    constexpr auto exception_status() noexcept requires requires(Bank& at) { at.exception_status(); }
    {
        return bank_->exception_status();
    }
    constexpr decltype(auto) server_id() noexcept requires requires(Bank& at) { at.server_id(); }
    {
        return bank_->server_id();
    }
    constexpr errc read_fifo(std::uint16_t address, byte_writer& out) noexcept requires requires(Bank& at)
    {
        at.read_fifo(address, out);
    }
    {
        return bank_->read_fifo(address, out);
    }
    constexpr errc check_read_file(file_run run) noexcept requires requires(Bank& at) { at.check_read_file(run); }
    {
        return bank_->check_read_file(run);
    }
    constexpr errc read_file(file_run run, byte_writer& out) noexcept requires requires(Bank& at)
    {
        at.read_file(run, out);
    }
    {
        return bank_->read_file(run, out);
    }
    constexpr errc check_write_file(file_run run, register_view values) noexcept requires requires(Bank& at)
    {
        at.check_write_file(run, values);
    }
    {
        return bank_->check_write_file(run, values);
    }
    constexpr errc write_file(file_run run, register_view values) noexcept requires requires(Bank& at)
    {
        at.write_file(run, values);
    }
    {
        return bank_->write_file(run, values);
    }
    constexpr auto respond(function_code function, pdu_buffer& pdu) noexcept requires requires(Bank& at)
    {
        at.respond(function, pdu);
    }
    {
        return bank_->respond(function, pdu);
    }

protected:
    explicit constexpr bank_parts(Bank& bank) noexcept : bank_{&bank} {}
    [[nodiscard]] constexpr Bank& bank() const noexcept { return *bank_; }

private:
    Bank* bank_;
};

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 24, read FIFO queue (AP 6.18). Reading takes nothing out of the queue.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The response to function 24: the registers that the queue holds, up to 31.
struct read_fifo_queue_response {
    static constexpr function_code code = function_code::read_fifo_queue;
    static constexpr std::size_t most = detail::fifo_queue_row::most;
    static constexpr std::size_t max_size = 5 + 2 * most;

    /// In wire order; after decoding, a view of the received bytes.
    register_view registers;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return registers.size() > most ? errc::invalid_quantity : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 5 + registers.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, code, static_cast<std::uint32_t>(2 + registers.bytes().size()),
                           static_cast<std::uint32_t>(registers.size()));
        out.bytes(registers.bytes());
    }

    /// Reads a PDU; byte count, queue count and size must agree. Errors: `wrong_function`, `wrong_length`,
    /// `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_fifo_queue_response> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 5;
        if (not detail::is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != 3U + detail::u16_at(pdu, 1) or
            pdu.size() != head + std::size_t{2} * detail::u16_at(pdu, 3)) {
            return errc::wrong_length;
        }
        return detail::checked_pdu(read_fifo_queue_response{register_view{pdu.subspan(head)}});
    }
};

/// Reads a queue of one unit.
struct read_fifo_queue {
    using response = read_fifo_queue_response;
    static constexpr function_code code = detail::function_row<read_fifo_queue>::code;
    static constexpr detail::frame_rules rules = detail::function_row<read_fifo_queue>::rules;
    static constexpr std::size_t max_size = 3;

    std::uint16_t address; ///< of the queue's pointer

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u16(address);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<read_fifo_queue> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return read_fifo_queue{detail::u16_at(pdu, 1)};
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank, byte_writer& out)
    {
        bank.read_fifo(std::uint16_t{}, out);
    };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>,
                      "a server of function 24 needs a bank with read_fifo(address, out)");
        constexpr std::size_t head = 5;
        byte_writer out{pdu.bytes.subspan(head)};
        if (errc const wrong = at.bank.read_fifo(detail::u16_at(pdu.bytes, 1), out); wrong != errc::none) {
            return wrong;
        }
        if (out.size() > 2 * response::most) {
            return errc::illegal_data_value; // more than a response carries (AP 6.18)
        }
        if (out.size() % 2 != 0) {
            return errc::server_device_failure;
        }
        detail::put_u16(&pdu.bytes[1], static_cast<std::uint16_t>(2 + out.size()));
        detail::put_u16(&pdu.bytes[3], static_cast<std::uint16_t>(out.size() / 2));
        pdu.size = head + out.size();
        return errc::none;
    }

    friend constexpr bool operator==(read_fifo_queue const&, read_fifo_queue const&) = default;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's responses to the functions that read and write registers: 03, 04, 06, 16 and 23. They share one way, since
// one piece of code for all is the smallest.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/pdu_buffer.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Function and byte count, in front of what a response carries.
inline constexpr std::size_t counted_head = 2;

/// How many functions of a list access the registers of the bank itself: 03, 06, 16 and 23.
template <typename... Functions>
[[nodiscard]] consteval int count_register_functions(function_list<Functions...>) noexcept
{
    constexpr function_set together{function_code::read_holding_registers, function_code::write_single_register,
                                    function_code::write_multiple_registers,
                                    function_code::read_write_multiple_registers};
    return (int{together.contains(Functions::code)} + ... + 0);
}

/// Which functions `respond_to_access` answers on a server of these: those four, and 04.
template <typename Functions> struct register_accesses {
    static constexpr bool has_inputs = Functions::template contains<read_input_registers>;
    static constexpr int holding = count_register_functions(Functions{});
    static constexpr bool any = has_inputs or holding > 0;

    [[nodiscard]] static constexpr bool contain(function_code function) noexcept
    {
        return contain(Functions{}, function);
    }

private:
    template <typename Function>
    static constexpr bool answers = Function::code == read_input_registers::code or
                                    count_register_functions(function_list<Function>{}) > 0;

    template <typename... All>
    [[nodiscard]] static constexpr bool contain(function_list<All...>, function_code function) noexcept
    {
        return ((All::code == function and answers<All>) or ...);
    }
};

/// Calls `use` with the registers that a function of these reads.
template <typename Functions, typename Bank, typename Use>
constexpr errc with_registers(function_code function, Bank& bank, Use use) noexcept
{
    using accesses = register_accesses<Functions>;
    if constexpr (accesses::has_inputs) {
        static_assert(read_input_registers::is_served_by<Bank&>,
                      "a server of function 04 needs a bank with input_registers()");
        if (accesses::holding == 0 or function == function_code::read_input_registers) {
            return use(bank.input_registers());
        }
    }
    if constexpr (accesses::holding > 0) {
        return use(bank);
    }
}

/// Executes functions 03, 04, 06, 16 and 23: both halves are checked before the write, and the write comes before the
/// read. The words read are appended to `out`.
template <typename Functions, typename Bank>
[[nodiscard]] constexpr errc access_registers(function_code function, register_access const& asked, Bank& bank,
                                              byte_writer& out) noexcept
{
    bool const reads = asked.read_count > 0;
    bool const writes = not asked.values.empty();
    errc wrong = errc::none;
    if (reads) {
        wrong = with_registers<Functions>(
            function, bank, [&](auto& space) { return space.check_read(asked.read_start, asked.read_count); });
    }
    if constexpr (register_accesses<Functions>::holding > 0) {
        static_assert(register_bank<Bank>, "a server of functions 03, 06, 16 or 23 needs a register_bank");
        if (wrong == errc::none and writes) {
            wrong = bank.check_write(asked.write_start, asked.values);
        }
        if (wrong == errc::none and writes) {
            wrong = bank.write(asked.write_start, asked.values);
        }
    }
    if (wrong == errc::none and reads) {
        wrong = with_registers<Functions>(
            function, bank, [&](auto& space) { return space.read(asked.read_start, asked.read_count, out); });
    }
    return wrong;
}

/// Writes the byte count in front of what was appended.
constexpr void write_count(pdu_buffer& pdu, byte_writer const& out) noexcept
{
    pdu.bytes[1] = static_cast<std::byte>(out.size());
    pdu.size = counted_head + out.size();
}

/// Where the words of a response go: behind its byte count, or where a writer already is. A small server makes the
/// writer after the request was decoded, which is 80 bytes smaller.
[[nodiscard]] constexpr byte_writer writer_into(pdu_buffer& pdu) noexcept
{
    return byte_writer{pdu.bytes.subspan(counted_head)};
}
[[nodiscard]] constexpr byte_writer& writer_into(pdu_buffer&, byte_writer& out) noexcept { return out; }

/// Answers a request of functions 03, 04, 06, 16 and 23; any other is `illegal_function`.
template <typename Functions, typename Bank, typename... Writer>
[[nodiscard]] constexpr errc respond_to_access(function_code function, pdu_buffer& pdu, Bank& bank,
                                               server_profile const& profile, Writer&... writer) noexcept
{
    constexpr std::size_t echo_size = 5;
    register_access asked;
    if (errc const wrong = decode_access<Functions>(function, pdu.view().subspan(1), profile.limits, asked);
        wrong != errc::none) {
        return wrong;
    }
    auto&& out = writer_into(pdu, writer...);
    if (errc const wrong = access_registers<Functions>(function, asked, bank, out); wrong != errc::none) {
        return wrong;
    }
    if (out.size() != 2U * asked.read_count) {
        return errc::server_device_failure;
    }
    // The bytes that a write repeats are in place.
    pdu.size = echo_size;
    if (sizeof...(Writer) == 0 and asked.read_count > 0) {
        write_count(pdu, out);
    }
    return errc::none;
}

} // namespace rtuwire

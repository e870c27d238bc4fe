// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server as a pure function: a request and a bank in, a response out. Checks in the specification's order (AP 7):
// function, value, address, then the access itself; everything is checked before anything is written. Handles no unit
// address, no CRC and no time.
#pragma once

#include <cstddef>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/bank.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/pdu_buffer.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/server/serial_diagnostics.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Executes functions 03, 06, 16 and 23: both halves are checked before the write, and the write comes before the
/// read. The words read are appended to `out`.
/// Internal.
template <register_bank Bank>
[[nodiscard]] constexpr errc access_registers(register_access const& asked, Bank& bank, byte_writer& out) noexcept
{
    bool const reads = asked.read_count > 0;
    bool const writes = not asked.values.empty();
    errc wrong = errc::none;
    if (reads) {
        wrong = bank.check_read(asked.read_start, asked.read_count);
    }
    if (wrong == errc::none and writes) {
        wrong = bank.check_write(asked.write_start, asked.values);
    }
    if (wrong == errc::none and writes) {
        wrong = bank.write(asked.write_start, asked.values);
    }
    if (wrong == errc::none and reads) {
        wrong = bank.read(asked.read_start, asked.read_count, out);
    }
    return wrong;
}

/// Answers a request of functions 03, 06, 16 and 23.
/// Internal.
template <register_bank Bank>
[[nodiscard]] constexpr errc respond_to_access(function_code function, pdu_buffer& pdu, Bank& bank,
                                               server_profile const& profile) noexcept
{
    constexpr std::size_t echo_size = 5;
    constexpr std::size_t head_size = 2;
    register_access asked;
    if (errc const wrong = decode_access(function, pdu.view().subspan(1), profile.limits, asked); wrong != errc::none) {
        return wrong;
    }
    byte_writer out{pdu.bytes.subspan(head_size)};
    if (errc const wrong = access_registers(asked, bank, out); wrong != errc::none) {
        return wrong;
    }
    if (out.size() != 2U * asked.read_count) {
        return errc::server_device_failure;
    }
    bool const reads = asked.read_count > 0;
    if (reads) {
        pdu.bytes[1] = static_cast<std::byte>(out.size());
    }
    // The bytes that a write repeats are in place.
    pdu.size = reads ? head_size + out.size() : echo_size;
    return errc::none;
}

/// How many functions of a list `respond_to_access` answers: four at most, in one piece, which is the smallest.
/// Internal.
template <typename... Functions>
[[nodiscard]] consteval int count_register_functions(function_list<Functions...>) noexcept
{
    constexpr function_set together{function_code::read_holding_registers, function_code::write_single_register,
                                    function_code::write_multiple_registers,
                                    function_code::read_write_multiple_registers};
    return (int{together.contains(Functions::code)} + ... + 0);
}

/// What the server gives the function that answers a request.
/// Internal.
template <typename Bank, typename Diagnostics> struct server_context {
    Bank& bank;
    Diagnostics& line;
    server_profile const& profile;
};

/// Lets the function of a list answer that has a server's half in its own file; false where none of them has this code.
/// Internal.
template <typename... Functions, typename Context>
[[nodiscard]] constexpr bool respond_by_own(function_list<Functions...>, function_code function, pdu_buffer& pdu,
                                            Context const& at, errc& wrong) noexcept
{
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (requires { &Function::template respond<pdu_buffer, Context>; }) {
            if (function == Function::code) {
                wrong = Function::respond(pdu, at);
                return true;
            }
        }
        return false;
    };
    return (ask(std::type_identity<Functions>{}) or ...);
}

/// Whether a bank answers functions of its own.
/// Internal.
template <typename Bank>
concept answers_own_functions = requires(Bank& bank, function_code function, pdu_buffer& pdu)
{
    bank.respond(function, pdu);
};

/// Whether all functions of a list are public.
/// Internal.
template <typename... Functions> [[nodiscard]] consteval bool are_public(function_list<Functions...>) noexcept
{
    return (all_functions.contains(Functions::code) and ...);
}

/// Answers a request of a function below 80; an error is the exception to send.
/// Internal.
template <typename Functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr errc respond_to(function_code function, pdu_buffer& pdu, Bank& bank,
                                        server_profile const& profile, Diagnostics& line) noexcept
{
    // No profile names a function that is not public.
    constexpr bool only_public = not answers_own_functions<Bank> and are_public(Functions{});
    bool const needs_entry = only_public or all_functions.contains(function);
    if (needs_entry and not profile.functions.contains(function)) {
        return errc::illegal_function;
    }
    if constexpr (answers_own_functions<Bank>) {
        if (not Functions::codes.contains(function)) {
            return bank.respond(function, pdu).value_or(errc::illegal_function);
        }
    }
    if constexpr (Functions::template contains<diagnostics<>>) {
        if (function == function_code::diagnostics) {
            return line.response(pdu);
        }
    }
    if constexpr (Functions::template contains<read_device_identification>) {
        if (function == function_code::encapsulated_interface) {
            return write_identification(pdu, profile.identity);
        }
    }
    using context = server_context<Bank, Diagnostics>;
    errc wrong = errc::illegal_function;
    if (respond_by_own(Functions{}, function, pdu, context{bank, line, profile}, wrong)) {
        return wrong;
    }
    constexpr int count = count_register_functions(Functions{});
    if constexpr (count > 0) {
        static_assert(register_bank<Bank>, "a server of functions 03, 06, 16 or 23 needs a register_bank");
        if (count == 4 or Functions::codes.contains(function)) {
            return respond_to_access(function, pdu, bank, profile);
        }
    }
    return wrong;
}

/// Replaces a request PDU of a function below 80 by its response or an exception; returns the exception, or none.
/// Internal.
template <typename Functions, typename Bank, typename Diagnostics>
constexpr errc execute(function_code function, pdu_buffer& pdu, Bank& bank, server_profile const& profile,
                       Diagnostics& line) noexcept
{
    errc const wrong = respond_to<Functions>(function, pdu, bank, profile, line);
    if (wrong != errc::none) {
        pdu.bytes[0] |= std::byte{exception_bit};
        // An error that has no code on the wire (a local cause, `unlisted_exception`) is sent as 04.
        bool const has_code = static_cast<std::uint8_t>(wrong) < static_cast<std::uint8_t>(errc::unlisted_exception);
        pdu.bytes[1] = static_cast<std::byte>(has_code ? wrong : errc::server_device_failure);
        pdu.size = 2;
    }
    return wrong;
}

/// Replaces a request PDU sent to one unit by its response or an exception (function + 80, code). In this order:
/// - no PDU, or a function of 80 or above: no response (size 0), and nothing is done;
/// - 01: a public function that is not in `profile.functions`;
/// - a function that is not in `Functions`: what `respond(function, pdu)` of the bank returns, where it has that; 01
///   otherwise;
/// - 01: its limit in `profile.limits` is 0 (for 23: either of its two);
/// - 08: what `Diagnostics` returns; 43: what `write_identification` returns;
/// - 03: the PDU's size, its byte count (which is twice the quantity) and its quantity (1 to the limit) do not agree.
///   Sizes: functions 03 and 06: 5; 16: 6 + byte count; 23: 10 + byte count;
/// - what `check_read` of the bank returns for functions 03 and 23, then `check_write` for 06, 16 and 23: both are
///   called before anything is written;
/// - what `write` returns, then `read`: function 23 writes before it reads. Where `read` did not append the requested
///   words, 04.
/// An error of a bank that is no exception code below 7F is sent as 04. A normal response holds the words read (03,
/// 23), or the first five bytes of the request (06, 16).
/// Internal.
template <typename Functions = register_functions, typename Bank, typename Diagnostics>
constexpr void respond_in_place(pdu_buffer& pdu, Bank& bank, server_profile const& profile, Diagnostics& line) noexcept
{
    if (pdu.size == 0 or to_u8(pdu.bytes[0]) >= exception_bit) {
        pdu.size = 0;
        return;
    }
    static_cast<void>(execute<Functions>(static_cast<function_code>(to_u8(pdu.bytes[0])), pdu, bank, profile, line));
}

/// The same for a request in other memory. Writes the response into `out`, of at least 253 bytes, and returns the
/// part written; empty also where `out` is smaller or the PDU larger.
template <typename Functions = register_functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_view respond(byte_view request_pdu, Bank& bank, server_profile const& profile,
                                          byte_span out, Diagnostics& line) noexcept
{
    if (out.size() < max_pdu_size or request_pdu.size() > max_pdu_size) {
        return {};
    }
    for (std::size_t i = 0; i < request_pdu.size(); ++i) {
        out[i] = request_pdu[i];
    }
    pdu_buffer pdu{out.template first<max_pdu_size>(), request_pdu.size()};
    respond_in_place<Functions>(pdu, bank, profile, line);
    return pdu.view();
}

/// The same with function 08 as the loopback only.
template <typename Functions = register_functions, typename Bank>
[[nodiscard]] constexpr byte_view respond(byte_view request_pdu, Bank& bank, server_profile const& profile,
                                          byte_span out) noexcept
{
    loopback_only line;
    return respond<Functions>(request_pdu, bank, profile, out, line);
}

} // namespace rtuwire

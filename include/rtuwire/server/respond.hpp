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
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/pdu_buffer.hpp>
#include <rtuwire/server/register_responses.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/server/serial_diagnostics.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What the server gives the function that answers a request.
/// Internal.
template <typename Bank, typename Diagnostics> struct server_context {
    Bank& bank;
    Diagnostics& line;
    server_profile const& profile;
    byte_writer& out; ///< behind the byte count, which is written for it
};

/// Whether a function of a list has a server's half in its own file.
/// Internal.
template <typename Function, typename Context>
concept has_server_half = requires
{
    &Function::template respond<pdu_buffer, Context>;
};

/// Whether one of a list has.
/// Internal.
template <typename Context, typename... Functions>
[[nodiscard]] consteval bool have_server_half(function_list<Functions...>) noexcept
{
    return (has_server_half<Functions, Context> or ...);
}

/// Lets the function of a list answer that has this code and a server's half in its own file.
/// Internal.
template <typename... Functions, typename Context>
[[nodiscard]] constexpr errc respond_by_own(function_list<Functions...>, function_code function, pdu_buffer& pdu,
                                            Context const& at) noexcept
{
    errc wrong = errc::illegal_function;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (has_server_half<Function, Context>) {
            if (function == Function::code) {
                wrong = Function::respond(pdu, at);
                return true;
            }
        }
        return false;
    };
    static_cast<void>((ask(std::type_identity<Functions>{}) or ...));
    return wrong;
}

/// Answers a request on a server that has functions with a server's half in their own files, beside 03, 04, 06, 16 and
/// 23. What such a half appends to `out` becomes a response with a byte count; where it appends nothing, the response is
/// in place. The size by the function's length rule is checked for it.
/// Internal.
template <typename Functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr errc respond_beside(function_code function, pdu_buffer& pdu, Bank& bank,
                                            server_profile const& profile, Diagnostics& line) noexcept
{
    using accesses = register_accesses<Functions>;
    constexpr bool has_all = Functions::codes == all_functions;
    byte_writer out{pdu.bytes.subspan(counted_head)};
    errc wrong = errc::illegal_function;
    if (accesses::contain(function)) {
        if constexpr (accesses::any) {
            wrong = respond_to_access<Functions>(function, pdu, bank, profile, out);
        }
    } else if (has_size_of_rule(pdu.view())) {
        wrong = respond_by_own(Functions{}, function, pdu, server_context<Bank, Diagnostics>{bank, line, profile, out});
    } else if (has_all or Functions::codes.contains(function)) {
        wrong = errc::illegal_data_value;
    }
    if (out.size() > 0) {
        write_count(pdu, out);
    }
    return wrong;
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
            errc const wrong = bank.respond(function, pdu).value_or(errc::illegal_function);
            return pdu.size > pdu.bytes.size() ? errc::server_device_failure : wrong;
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
    using accesses = register_accesses<Functions>;
    if constexpr (have_server_half<server_context<Bank, Diagnostics>>(Functions{})) {
        return respond_beside<Functions>(function, pdu, bank, profile, line);
    } else if constexpr (accesses::any) {
        // All four in one piece, which refuses others, is the smallest.
        if (accesses::holding == 4 or accesses::contain(function)) {
            return respond_to_access<Functions>(function, pdu, bank, profile);
        }
    }
    return errc::illegal_function;
}

/// The same out of line, for a server of many functions: in line, compilers join each of its ends with what follows
/// (70 bytes). A small server is faster in line.
/// Internal.
template <typename Functions, typename Bank, typename Diagnostics>
[[nodiscard, gnu::noinline]] constexpr errc respond_apart(function_code function, pdu_buffer& pdu, Bank& bank,
                                                          server_profile const& profile, Diagnostics& line) noexcept
{
    return respond_to<Functions>(function, pdu, bank, profile, line);
}

/// Replaces a request PDU of a function below 80 by its response or an exception; returns the exception, or none.
/// Internal.
template <typename Functions, typename Bank, typename Diagnostics>
constexpr errc execute(function_code function, pdu_buffer& pdu, Bank& bank, server_profile const& profile,
                       Diagnostics& line) noexcept
{
    errc wrong = errc::none;
    if constexpr (have_server_half<server_context<Bank, Diagnostics>>(Functions{})) {
        wrong = respond_apart<Functions>(function, pdu, bank, profile, line);
    } else {
        wrong = respond_to<Functions>(function, pdu, bank, profile, line);
    }
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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server as a pure function: a request and a bank in, a response out. Checks in the specification's order (AP 7):
// function, value, address, then the access itself; everything is checked before anything is written. Handles no unit
// address, no CRC and no time.
//
// From `execute` a request goes to `respond_to`, which knows whose it is: the bank's own functions, 08, 43, the five that
// access registers (`respond_to_access`, one way for all, since one piece of code is the smallest), or one that has its
// server's half in its own file (`respond_by_own`). `response_frame` is the smallest server, of whole frames.
#pragma once

#include <cstddef>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/serial_diagnostics.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>
#include <rtuwire/wire/serial_line/fifo_queue.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>
#include <rtuwire/wire/serial_line/unit_report.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What a server can do. The defaults are the specification's limits and every function that the server has in its
/// type; a device's manual may allow less.
struct server_profile {
    function_set functions{all_functions};
    device_limits limits{};
    device_objects identity{}; ///< without objects, function 43 is not supported
};

namespace detail {

/// The functions of a server that has registers only: 03, 06, 08, 16, 23 and 43.
using register_functions =
    function_list<read_holding_registers, write_single_register, diagnostics<>, write_multiple_registers<>,
                  read_write_multiple_registers<>, read_device_identification>;

/// Whether a bank has what a function serves.
template <typename Function, typename Bank> inline constexpr bool serves_function = true;
template <typename Function, typename Bank>
    requires requires { Function::template is_served_by<Bank&>; }
inline constexpr bool serves_function<Function, Bank> = Function::template is_served_by<Bank&>;

/// Moves those of a list that a bank serves behind those that are chosen.
template <typename Bank, typename Chosen, typename Others> struct choose_functions {
    using type = Chosen;
};
template <typename Bank, typename... Chosen, typename First, typename... Others>
struct choose_functions<Bank, function_list<Chosen...>, function_list<First, Others...>>
    : choose_functions<
          Bank,
          std::conditional_t<serves_function<First, Bank>, function_list<Chosen..., First>, function_list<Chosen...>>,
          function_list<Others...>> {};

/// The public functions that a bank of registers serves.
template <typename Bank>
using served_functions = typename choose_functions<Bank, function_list<>, public_functions>::type;

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

/// What the server gives the function that answers a request.
template <typename Bank, typename Diagnostics> struct server_context {
    Bank& bank;
    Diagnostics& line;
    server_profile const& profile;
    byte_writer& out; ///< behind the byte count, which is written for it
};

/// Whether a function of a list has a server's half in its own file.
template <typename Function, typename Context>
concept has_server_half = requires
{
    &Function::template respond<pdu_buffer, Context>;
};

/// Whether one of a list has.
template <typename Context, typename... Functions>
[[nodiscard]] consteval bool have_server_half(function_list<Functions...>) noexcept
{
    return (has_server_half<Functions, Context> or ...);
}

/// Lets the function of a list answer that has this code and a server's half in its own file.
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
template <typename Bank>
concept answers_own_functions = requires(Bank& bank, function_code function, pdu_buffer& pdu)
{
    bank.respond(function, pdu);
};

/// Whether all functions of a list are public.
template <typename... Functions> [[nodiscard]] consteval bool are_public(function_list<Functions...>) noexcept
{
    return (all_functions.contains(Functions::code) and ...);
}

/// Answers a request of a function below 80; an error is the exception to send.
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
template <typename Functions, typename Bank, typename Diagnostics>
[[nodiscard, gnu::noinline]] constexpr errc respond_apart(function_code function, pdu_buffer& pdu, Bank& bank,
                                                          server_profile const& profile, Diagnostics& line) noexcept
{
    return respond_to<Functions>(function, pdu, bank, profile, line);
}

/// Replaces a request PDU of a function below 80 by its response or an exception, by the rules that stand at
/// `respond_in_place`; returns the exception, or none.
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
template <typename Functions = register_functions, typename Bank, typename Diagnostics>
constexpr void respond_in_place(pdu_buffer& pdu, Bank& bank, server_profile const& profile, Diagnostics& line) noexcept
{
    if (pdu.size == 0 or to_u8(pdu.bytes[0]) >= exception_bit) {
        pdu.size = 0;
        return;
    }
    static_cast<void>(execute<Functions>(static_cast<function_code>(to_u8(pdu.bytes[0])), pdu, bank, profile, line));
}

} // namespace detail

/// The same for a request in other memory. Writes the response into `out`, of at least 253 bytes, and returns the
/// part written; empty also where `out` is smaller or the PDU larger.
template <typename Functions = detail::register_functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_view respond(byte_view request_pdu, Bank& bank, server_profile const& profile,
                                          byte_span out, Diagnostics& line) noexcept
{
    if (out.size() < max_pdu_size or request_pdu.size() > max_pdu_size) {
        return {};
    }
    for (std::size_t i = 0; i < request_pdu.size(); ++i) {
        out[i] = request_pdu[i];
    }
    detail::pdu_buffer pdu{out.template first<max_pdu_size>(), request_pdu.size()};
    detail::respond_in_place<Functions>(pdu, bank, profile, line);
    return pdu.view();
}

/// The same with function 08 as the loopback only.
template <typename Functions = detail::register_functions, typename Bank>
[[nodiscard]] constexpr byte_view respond(byte_view request_pdu, Bank& bank, server_profile const& profile,
                                          byte_span out) noexcept
{
    loopback_only line;
    return respond<Functions>(request_pdu, bank, profile, out, line);
}

/// Answers the request in the first `size` bytes of `place`, which has at least 256. The response is written over it;
/// empty where none is due: another unit, a broadcast, a damaged frame. For firmware that has whole frames already, from a
/// receiver that detects the line's silence and a DMA channel. A request to this unit cannot be told here from another
/// unit's response that looks like it, and late responses are not dropped: `server` does both.
template <typename Functions = detail::register_functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_span response_frame(byte_span place, std::size_t size, unit_id unit, Bank& bank,
                                                 server_profile const& profile, Diagnostics& line) noexcept
{
    bool const is_broadcast = detail::to_u8(place[0]) == 0;
    bool const is_meant = is_broadcast or detail::to_u8(place[0]) == unit.byte();
    if (not is_meant or check_frame(place.first(size)) != errc::none) {
        return {};
    }
    detail::request_head const asked{static_cast<function_code>(detail::to_u8(place[1])), is_broadcast};
    if (not asked.has_effect<Functions>() or detail::to_u8(asked.function) >= detail::exception_bit) {
        return {};
    }
    detail::pdu_buffer pdu{place.subspan(1).first<max_pdu_size>(), size - detail::adu_overhead};
    static_cast<void>(detail::execute<Functions>(asked.function, pdu, bank, profile, line));
    return is_broadcast or pdu.size == 0 ? byte_span{} : detail::append_crc(place, pdu.size);
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

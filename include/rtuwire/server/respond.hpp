// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server as a pure function: a request and a bank in, an answer out. Checks in the specification's
// order (AP 7): function, value, address, then the work itself; everything is checked before anything
// is written. Knows no unit, no CRC and no time.
#pragma once

#include <cstddef>

#include <rtuwire/server/bank.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/server/serial_diagnostics.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire {

/// Does what functions 03, 06, 16 and 23 ask: both halves are checked before the write is done, and
/// the write is done before the read.
template <register_bank Bank>
[[nodiscard]] constexpr errc access_registers(register_access const& asked, Bank& bank,
                                              byte_writer& out) noexcept
{
    errc wrong = errc::none;
    if (asked.read_count > 0) {
        wrong = bank.check_read(asked.read_start, asked.read_count);
    }
    if (wrong == errc::none and not asked.values.empty()) {
        wrong = bank.check_write(asked.write_start, asked.values);
    }
    if (wrong == errc::none and not asked.values.empty()) {
        wrong = bank.write(asked.write_start, asked.values);
    }
    if (wrong == errc::none and asked.read_count > 0) {
        out.u8(2U * asked.read_count);
        wrong = bank.read(asked.read_start, asked.read_count, out);
        if (wrong == errc::none and not out.ok()) {
            wrong = errc::server_device_failure;
        }
    }
    return wrong;
}

/// Answers a request of functions 03, 06, 16 and 23; the size of the answer, or the exception.
template <register_bank Bank>
[[nodiscard]] constexpr result<std::size_t> answer_access(byte_view request_pdu, Bank& bank,
                                                          server_profile const& profile,
                                                          byte_span out) noexcept
{
    constexpr std::size_t echo_size = 5;
    register_access asked;
    if (errc const wrong = decode_access(request_pdu, profile.limits, asked); wrong != errc::none) {
        return wrong;
    }
    bool const only_writes = asked.read_count == 0;
    // An answer in the request's own place: what it repeats is already there.
    byte_writer writer{out};
    writer.bytes(request_pdu.first(only_writes ? echo_size : 1));
    errc const wrong = access_registers(asked, bank, writer);
    if (wrong != errc::none) {
        return wrong;
    }
    return writer.size();
}

/// Answers function 43: only type 14, device identification.
[[nodiscard]] constexpr result<std::size_t>
answer_identification(byte_view request_pdu, server_profile const& profile, byte_span out) noexcept
{
    if (profile.identity.empty()) {
        return errc::illegal_function;
    }
    auto const asked = read_device_identification::decode(request_pdu);
    if (asked) {
        return write_identification(out, profile.identity, *asked);
    }
    return asked.error() == errc::wrong_function ? errc::illegal_function
                                                 : errc::illegal_data_value;
}

/// Answers any request; the size of the answer, or the exception.
template <register_bank Bank, typename Diagnostics>
[[nodiscard]] constexpr result<std::size_t>
answer_request(byte_view request_pdu, Bank& bank, server_profile const& profile, byte_span out,
               Diagnostics& line) noexcept
{
    auto const function = static_cast<function_code>(to_u8(request_pdu[0]));
    if (not profile.functions.contains(function)) {
        return errc::illegal_function;
    }
    if (function == function_code::diagnostics) {
        return line.answer(request_pdu, out);
    }
    if (function == function_code::encapsulated_interface) {
        return answer_identification(request_pdu, profile, out);
    }
    return answer_access(request_pdu, bank, profile, out);
}

/// Answers a request PDU that was sent to one unit. Writes the answer, normal or exception, into `out`
/// and returns its part written; empty, with nothing done, for a PDU without a function below 80, and
/// where function 08 wants no answer. `out` holds at least 253 octets and may be the request's own
/// place.
template <register_bank Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_span respond(byte_view request_pdu, Bank& bank,
                                          server_profile const& profile, byte_span out,
                                          Diagnostics& line) noexcept
{
    if (request_pdu.empty() or out.size() < max_pdu_size) {
        return {};
    }
    auto const function = static_cast<function_code>(to_u8(request_pdu[0]));
    if (to_u8(function) >= exception_bit) {
        return {};
    }
    auto const answered = answer_request(request_pdu, bank, profile, out.first(max_pdu_size), line);
    if (answered) {
        return out.first(*answered);
    }
    errc const code =
        is_exception(answered.error()) ? answered.error() : errc::server_device_failure;
    out[0] = to_byte(to_u8(function) | exception_bit);
    out[1] = static_cast<std::byte>(code);
    return out.first(2);
}

/// The same with function 08 as a loop-back.
template <register_bank Bank>
[[nodiscard]] constexpr byte_span respond(byte_view request_pdu, Bank& bank,
                                          server_profile const& profile, byte_span out) noexcept
{
    loop_back line;
    return respond(request_pdu, bank, profile, out, line);
}

/// Whether a request has an effect when it is sent to everyone: functions 06 and 16. Its answer is not
/// sent then.
[[nodiscard]] constexpr bool may_be_broadcast(byte_view request_pdu) noexcept
{
    return is_pdu_of(request_pdu, function_code::write_single_register) or
           is_pdu_of(request_pdu, function_code::write_multiple_registers);
}

} // namespace rtuwire

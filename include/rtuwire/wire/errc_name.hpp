// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Error names for display, kept apart so that firmware which shows none does not contain them.
#pragma once

#include <string_view>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The error in words; "exception" for an exception code that has no name.
[[nodiscard]] constexpr std::string_view name(errc error) noexcept
{
    switch (error) {
    case errc::none: return "no error";
    case errc::illegal_function: return "illegal function";
    case errc::illegal_data_address: return "illegal data address";
    case errc::illegal_data_value: return "illegal data value";
    case errc::server_device_failure: return "server device failure";
    case errc::acknowledge: return "acknowledge";
    case errc::server_device_busy: return "server device busy";
    case errc::negative_acknowledge: return "negative acknowledge";
    case errc::memory_parity_error: return "memory parity error";
    case errc::gateway_path_unavailable: return "gateway path unavailable";
    case errc::gateway_target_failed_to_respond: return "gateway target failed to respond";
    case errc::unlisted_exception: return "exception with an unlisted code";
    case errc::buffer_too_small: return "buffer too small";
    case errc::invalid_unit: return "unit address outside 1..247";
    case errc::invalid_quantity: return "quantity outside the function's limits";
    case errc::invalid_address_range: return "registers behind the last one";
    case errc::invalid_function: return "function code outside 1..127";
    case errc::not_for_broadcast: return "not possible as a broadcast";
    case errc::busy: return "a transaction is under way";
    case errc::used_already: return "used already: begin it anew with again()";
    case errc::overruled: return "a stop, a fault or a set-up came after the order, or a stop is under way";
    case errc::unit_lost: return "the unit did not answer, and its order is gone";
    case errc::too_many_ordered: return "the client keeps no more orders at once";
    case errc::value_too_high: return "value above the register's maximum";
    case errc::value_too_low: return "value below the register's minimum";
    case errc::value_between_steps: return "value between two steps of the register";
    case errc::value_never_written: return "value that is never written to the register";
    case errc::value_without_meaning: return "value without a meaning in the register";
    case errc::frame_too_short: return "frame too short";
    case errc::frame_too_long: return "frame too long";
    case errc::wrong_length: return "right CRC, wrong length";
    case errc::crc_mismatch: return "CRC mismatch";
    case errc::uart_error: return "parity, framing or overrun error";
    case errc::wrong_unit: return "response of another unit";
    case errc::wrong_function: return "response to another function";
    case errc::response_mismatch: return "response to another request";
    case errc::malformed: return "malformed field";
    case errc::line_echo: return "the request itself came back: the line echoes";
    case errc::collision: return "what was sent came back as something else";
    case errc::timed_out: return "no response in time";
    case errc::bus_jam: return "the line never fell silent";
    case errc::transmit_stalled: return "the transmitter never finished";
    case errc::never_advanced: return "nothing was sent: advance was never called";
    case errc::cancelled: return "cancelled";
    case errc::device_not_found: return "no such device";
    case errc::device_access_denied: return "no permission for the device";
    case errc::device_in_use: return "the device is in use";
    case errc::device_not_serial: return "not a serial device";
    case errc::device_setting_refused: return "the device refuses the line settings";
    case errc::device_vanished: return "the device vanished";
    case errc::device_not_open: return "the device is not open";
    case errc::device_failed: return "the device failed";
    }
    return is_exception(error) ? "exception" : "unknown error";
}

/// The same, for what shows any value.
[[nodiscard]] constexpr std::string_view text_of(errc error) noexcept { return name(error); }

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

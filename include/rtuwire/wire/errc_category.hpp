// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What kind of error a code is: whose fault it is, and whether a request left. By name: a code that is not listed here
// does not compile, and none of this rests on the order or the numbers of the local causes.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The kinds of errors.
enum class error_category : std::uint8_t {
    none,          ///< no error
    exception,     ///< the server answered with an exception response
    request,       ///< what the caller requested is not possible; nothing was written or sent
    reception,     ///< what was received is not what it should be; nothing of it was passed on
    no_response,   ///< the transaction ended without a response
    serial_device, ///< the serial device of a host
    unknown,       ///< a number from 0x80 on that is no error
};

/// The kind of an error; any exception code is an `exception`, listed or not.
[[nodiscard]] constexpr error_category category_of(errc error) noexcept
{
    switch (error) {
    case errc::none: return error_category::none;

    case errc::illegal_function:
    case errc::illegal_data_address:
    case errc::illegal_data_value:
    case errc::server_device_failure:
    case errc::acknowledge:
    case errc::server_device_busy:
    case errc::negative_acknowledge:
    case errc::memory_parity_error:
    case errc::gateway_path_unavailable:
    case errc::gateway_target_failed_to_respond:
    case errc::unlisted_exception: return error_category::exception;

    case errc::buffer_too_small:
    case errc::invalid_unit:
    case errc::invalid_quantity:
    case errc::invalid_address_range:
    case errc::invalid_function:
    case errc::not_for_broadcast:
    case errc::busy:
    case errc::used_already:
    case errc::overruled:
    case errc::unit_lost:
    case errc::too_many_ordered:
    case errc::value_too_high:
    case errc::value_too_low:
    case errc::value_between_steps:
    case errc::value_never_written:
    case errc::value_without_meaning: return error_category::request;

    case errc::frame_too_short:
    case errc::frame_too_long:
    case errc::wrong_length:
    case errc::crc_mismatch:
    case errc::uart_error:
    case errc::wrong_unit:
    case errc::wrong_function:
    case errc::response_mismatch:
    case errc::malformed:
    case errc::line_echo:
    case errc::collision: return error_category::reception;

    case errc::timed_out:
    case errc::bus_jam:
    case errc::transmit_stalled:
    case errc::cancelled: return error_category::no_response;

    case errc::device_not_found:
    case errc::device_access_denied:
    case errc::device_in_use:
    case errc::device_not_serial:
    case errc::device_setting_refused:
    case errc::device_vanished:
    case errc::device_not_open:
    case errc::device_failed: return error_category::serial_device;
    }
    return is_exception(error) ? error_category::exception : error_category::unknown;
}

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Every error, as one byte. Below 0x80 it is an exception code as a server sent it (Modbus Application
// Protocol V1.1b3, 7), listed here or not; from 0x80 it is a local cause, whose number stays the same in all
// versions, for programs that log it. wire/errc_category.hpp sorts the errors, by name and not by number.
#pragma once

#include <cstdint>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Why there is no value. Exceptions keep the number they have on the wire.
enum class errc : std::uint8_t {
    none = 0x00, ///< no error; never the error of a result without a value

    illegal_function = 0x01,
    illegal_data_address = 0x02,
    illegal_data_value = 0x03,
    server_device_failure = 0x04,
    acknowledge = 0x05,
    server_device_busy = 0x06,
    negative_acknowledge = 0x07, ///< only in old documents
    memory_parity_error = 0x08,
    gateway_path_unavailable = 0x0A,
    gateway_target_failed_to_respond = 0x0B,
    unlisted_exception = 0x7F, ///< stands for the codes 0 and above 0x7F, too

    // What the caller requested is not possible; nothing was written or sent.
    buffer_too_small = 0x80,      ///< the caller's span cannot hold the result
    invalid_unit = 0x81,          ///< a unit address outside 1..247
    invalid_quantity = 0x82,      ///< a quantity of 0 or above the function's limit
    invalid_address_range = 0x83, ///< start + quantity runs past register 65535; or an index past a view's end
    invalid_function = 0x84,      ///< a function code outside 1..127
    not_for_broadcast = 0x85,     ///< a request that needs a response, which a broadcast never gets
    busy = 0x86,                  ///< a transaction or a conversation is under way, its outcome not there yet
    finished = 0x88,              ///< a conversation has ended already, and cannot begin anew
    overruled = 0x89,             ///< a stop, a fault or a set-up came later than the order, or a stop is under way
    unit_lost = 0x8A,             ///< the unit, ordered to run, did not answer a caller; its order is gone
    too_many_ordered = 0x8B,      ///< the client keeps the orders of no more units at once

    // A value that was to be written does not fit its register; nothing was sent.
    value_too_high = 0xA3,        ///< above the register's maximum
    value_too_low = 0xA4,         ///< below the register's minimum
    value_between_steps = 0xA5,   ///< not a whole number of the register's steps
    value_never_written = 0xA6,   ///< inside the limits, but never to be written
    value_without_meaning = 0xA7, ///< an enumerator that the register does not have

    // What was received is not what it should be; nothing of it was passed on.
    frame_too_short = 0x8C,   ///< fewer than 4 bytes
    frame_too_long = 0x8D,    ///< more than 256 bytes
    wrong_length = 0x8E,      ///< the size contradicts the frame's own header
    crc_mismatch = 0x8F,      ///< the CRC is wrong
    uart_error = 0x90,        ///< parity, framing or overrun error reported by the receiver
    wrong_unit = 0x91,        ///< another unit answered
    wrong_function = 0x92,    ///< the response is to another function
    response_mismatch = 0x93, ///< address, quantity or value of the response are not those of the request
    malformed = 0x94,         ///< a field holds a value that the function does not allow
    line_echo = 0x95,         ///< the request itself came back: the line echoes what is sent
    collision = 0x96,         ///< what was sent came back as something else

    // The transaction ended without a response.
    timed_out = 0x97,        ///< no response within the response time-out
    bus_jam = 0x98,          ///< bytes kept arriving and the line never became silent
    transmit_stalled = 0x99, ///< the transmitter never reported the end of the request
    cancelled = 0x9A,        ///< the caller cancelled the transaction

    // The serial device of a host.
    device_not_found = 0x9B,       ///< no such device
    device_access_denied = 0x9C,   ///< no permission for the device
    device_in_use = 0x9D,          ///< the device is in use already
    device_not_serial = 0x9E,      ///< not a serial device
    device_setting_refused = 0x9F, ///< the device does not support the bit rate or character format
    device_vanished = 0xA0,        ///< the device was unplugged
    device_not_open = 0xA1,        ///< the port is not open
    device_failed = 0xA2,          ///< any other failure of the operating system's call
};

/// Whether a server sent this error as an exception response.
[[nodiscard]] constexpr bool is_exception(errc error) noexcept
{
    return error != errc::none and static_cast<std::uint8_t>(error) < 0x80;
}

/// The error for an exception code from the wire.
/// Internal.
[[nodiscard]] constexpr errc exception_error(std::uint8_t code) noexcept
{
    return code == 0 or code >= 0x80 ? errc::unlisted_exception : static_cast<errc>(code);
}

} // namespace rtuwire

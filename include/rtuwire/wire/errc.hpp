// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Every error, as one byte. Below 0x80 it is an exception code as a server sent it (Modbus Application
// Protocol V1.1b3, 7), listed here or not; from 0x80 it is a local cause. Causes of a kind are adjacent:
// statistics count by their order.
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
    buffer_too_small = 0x80, ///< the caller's span cannot hold the result
    invalid_unit,            ///< a unit address outside 1..247
    invalid_quantity,        ///< a quantity of 0 or above the function's limit
    invalid_address_range,   ///< start + quantity runs past register 65535; or an index past a view's end
    invalid_function,        ///< a function code outside 1..127
    not_for_broadcast,       ///< a request that needs a response, which a broadcast never gets
    busy,                    ///< a transaction is under way
    pending,                 ///< a conversation has not ended yet
    finished,                ///< a conversation has ended already, and cannot begin anew
    overruled,               ///< a stop, a fault or a set-up came later than the order, or a stop is under way
    unit_lost,               ///< the unit, ordered to run, did not answer a caller; its order is gone
    too_many_ordered,        ///< the client keeps the orders of no more units at once

    // What was received is not what it should be; nothing of it was passed on.
    frame_too_short,   ///< fewer than 4 bytes
    frame_too_long,    ///< more than 256 bytes
    wrong_length,      ///< the size contradicts the frame's own header
    crc_mismatch,      ///< the CRC is wrong
    uart_error,        ///< parity, framing or overrun error reported by the receiver
    wrong_unit,        ///< another unit answered
    wrong_function,    ///< the response is to another function
    response_mismatch, ///< address, quantity or value of the response are not those of the request
    malformed,         ///< a field holds a value that the function does not allow
    line_echo,         ///< the request itself came back: the line echoes what is sent
    collision,         ///< what was sent came back as something else

    // What did not happen in time.
    timed_out,        ///< no response within the response time-out
    bus_jam,          ///< bytes kept arriving and the line never became silent
    transmit_stalled, ///< the transmitter never reported the end of the request
    cancelled,        ///< the caller cancelled the transaction

    // The serial device of a host.
    device_not_found,       ///< no such device
    device_access_denied,   ///< no permission for the device
    device_in_use,          ///< the device is in use already
    device_not_serial,      ///< not a serial device
    device_setting_refused, ///< the device does not support the bit rate or character format
    device_vanished,        ///< the device was unplugged
    device_not_open,        ///< the port is not open
    device_failed,          ///< any other failure of the operating system's call
};

/// Whether a server sent this error as an exception response.
[[nodiscard]] constexpr bool is_exception(errc error) noexcept
{
    return error != errc::none and static_cast<std::uint8_t>(error) < 0x80;
}

/// The error for an exception code from the wire.
[[nodiscard]] constexpr errc exception_error(std::uint8_t code) noexcept
{
    return code == 0 or code >= 0x80 ? errc::unlisted_exception : static_cast<errc>(code);
}

} // namespace rtuwire

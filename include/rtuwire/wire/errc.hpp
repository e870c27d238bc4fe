// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Every error, as one byte. Below 0x80 it is an exception code as a server sent it (Modbus Application
// Protocol V1.1b3, 7), listed here or not; from 0x80 it is a local cause, whose number stays the same in all
// versions, for programs that log it. `category_of` sorts the errors, by name and not by number.
// The gallery of errors on the site is made of the causes and remedies here.
#pragma once

#include <cstdint>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Why there is no value. Exceptions keep the number they have on the wire.
enum class errc : std::uint8_t {
    /// No error; never the error of a result without a value.
    none = 0x00,

    // What a server sent as an exception response.
    /// The unit does not have this function.
    /// Remedy: Use a function that its manual lists; a drive's `device` knows them at compile time.
    illegal_function = 0x01,
    /// The unit has no register at one of these addresses, or refuses the block as a whole.
    /// Remedy: Check the address against the manual's (Altivars count from 0, without an offset of 1), and ask for
    /// less at once.
    illegal_data_address = 0x02,
    /// The unit does not take this value or this quantity.
    /// Remedy: Check limits and steps; limits may depend on other registers, as HSP does on TFR.
    illegal_data_value = 0x03,
    /// The unit began, and could not finish. A drive may send it for a setting while its motor runs.
    /// Remedy: Stop the motor first, or look at the unit's own fault.
    server_device_failure = 0x04,
    /// The unit took the request and needs long for it.
    /// Remedy: Ask for the result later; the client repeats the request after a pause, as its `retry_policy` says.
    acknowledge = 0x05,
    /// The unit is busy with something else.
    /// Remedy: Ask again later; the client has repeated the request already, as its `retry_policy` says.
    server_device_busy = 0x06,
    /// The unit can't do what function 13 or 14 asked; only in old documents.
    /// Remedy: See the unit's manual.
    negative_acknowledge = 0x07,
    /// The unit found its record or its memory damaged.
    /// Remedy: Ask again; if it stays, the unit needs service.
    memory_parity_error = 0x08,
    /// A gateway has no way to the line of this unit.
    /// Remedy: Check the gateway's configuration.
    gateway_path_unavailable = 0x0A,
    /// A gateway asked, and the unit did not respond.
    /// Remedy: Treat it as `timed_out` behind the gateway: power, address, bit rate and wiring there.
    gateway_target_failed_to_respond = 0x0B,
    /// An exception code that no specification lists; also stands for the codes 0 and above 0x7F.
    /// Remedy: See the unit's manual for codes of its own.
    unlisted_exception = 0x7F,

    // What the caller requested is not possible; nothing was written or sent.
    /// The caller's span, or the client's frame, can't hold the request or its longest response.
    /// Remedy: Ask for less, or take a `host_client`, whose frame holds all.
    buffer_too_small = 0x80,
    /// A unit address outside 1..247, or outside of what this drive can be set to.
    /// Remedy: Give an address that the unit can have; everybody at once is `broadcast`. A unit that answers to 248 to 255
    /// is asked by `unit_id::reserved(248)`, or `unit_id::checked_reserved(n)`; one that answers at 0, by `only_unit`.
    invalid_unit = 0x81,
    /// A quantity of 0, or above the limit of the function.
    /// Remedy: Ask for less: 125 registers of one read, 123 of one write, 2000 bits; a drive takes fewer.
    invalid_quantity = 0x82,
    /// Start and quantity run past register 65535, or an index is past the end of a view.
    /// Remedy: Check start and quantity, or the size of the view.
    invalid_address_range = 0x83,
    /// A function code outside 1..127, or one that is not in the client's list of functions.
    /// Remedy: Codes of one's own are 65 to 72 and 100 to 110; a client asks what its `client_needs` list.
    invalid_function = 0x84,
    /// A request that needs a response, which a broadcast never gets.
    /// Remedy: Ask each unit by its address.
    not_for_broadcast = 0x85,
    /// A transaction or a conversation is under way, and its outcome is not there yet.
    /// Remedy: Look at `settled()` before the outcome, and call `advance` and `converse` in each pass.
    busy = 0x86,
    /// A conversation had ended before, and what it told then is old.
    /// Remedy: Begin it anew with `again()`, or `run` it; read an outcome in the pass in which its conversation settles.
    used_already = 0x88,
    /// A stop, a fault or a set-up came later than the order, or a stop is under way.
    /// Remedy: Find out why it was stopped; then give a new order, once the stop has ended.
    overruled = 0x89,
    /// The unit, ordered to run, did not answer a caller; its order is gone.
    /// Remedy: Mend the line, look at the drive, reset its fault; then give a new order.
    unit_lost = 0x8A,
    /// The client keeps the orders of no more units at once.
    /// Remedy: Give `drive_client<Units>` or the bus one place for each motor of the line.
    too_many_ordered = 0x8B,

    // A value does not fit its register: one to be written was not sent, one that was read is not given.
    /// Above the register's maximum; on reading, more than the value's type can count.
    /// Remedy: To write, take less, or find its source. Reading: compare type and word order with the unit's manual.
    value_too_high = 0xA3,
    /// Below the register's minimum; on reading, less than the value's type can count.
    /// Remedy: To write, take more, or find its source. Reading: compare type and word order with the unit's manual.
    value_too_low = 0xA4,
    /// Not a whole number of the register's steps.
    /// Remedy: Round it to a step where it is made; the register table lists the steps.
    value_between_steps = 0xA5,
    /// Inside the limits, but never to be written.
    /// Remedy: Leave this value out: the unit's manual reserves it.
    value_never_written = 0xA6,
    /// No value of the register: an enumerator that it does not have, not a number; on reading, the unit has none now.
    /// Remedy: To write, take one that its table lists. Reading: compare type and word order with the unit's manual.
    value_without_meaning = 0xA7,

    // What was received is not what it should be; nothing of it was passed on.
    /// Fewer than 4 bytes.
    /// Remedy: Noise or a cut: check ground, termination and bias of the line.
    frame_too_short = 0x8C,
    /// More than 256 bytes without an end.
    /// Remedy: Another protocol, another bit rate, or a unit that babbles: listen to the line.
    frame_too_long = 0x8D,
    /// The CRC is right, but the size is not the one that the function, the request or the frame's own header gives.
    /// Remedy: The unit departs from the function's format, so the line is not to blame: look at the frame that came
    /// (`refused()` of a client), and see its manual; a request type of one's own can read another format.
    wrong_length = 0x8E,
    /// The CRC is wrong: bytes were damaged.
    /// Remedy: Check termination, bias, ground and the routing beside motor cables; the same frame damaged each
    /// time means a wrong character format.
    crc_mismatch = 0x8F,
    /// The receiver reported a parity, framing or overrun error.
    /// Remedy: Check bit rate and character format at both ends; an overrun means that bytes are taken too late.
    uart_error = 0x90,
    /// Another unit answered.
    /// Remedy: Two units may have one address, or a second client sends on this line.
    wrong_unit = 0x91,
    /// The response is to another function.
    /// Remedy: A late response or a second client: lengthen the response time-out, and listen who sends.
    wrong_function = 0x92,
    /// Address, quantity or value of the response are not those of the request.
    /// Remedy: A late response, a second client, or a unit that does not repeat what it took: listen to the line.
    response_mismatch = 0x93,
    /// A field holds a value that the function does not allow.
    /// Remedy: The unit departs from the specification: capture the frame, and see its manual.
    malformed = 0x94,
    /// The request itself came back: the line echoes what is sent.
    /// Remedy: Set `.has_line_echo`, or disable the receiver while sending.
    line_echo = 0x95,
    /// What was sent came back as something else.
    /// Remedy: Somebody else sends at the same time: there must be one client on the line.
    collision = 0x96,

    // The transaction ended without a response.
    /// No response within the response time-out.
    /// Remedy: Check power, address, bit rate, format and the wires A and B; a slow unit needs a longer
    /// `.response_timeout`.
    timed_out = 0x97,
    /// Bytes kept arriving and the line never became silent.
    /// Remedy: A unit babbles, or the line floats: check bias, and take units off one by one.
    bus_jam = 0x98,
    /// The transmitter never reported the end of the request.
    /// Remedy: Call `sent` when the last stop bit has left; on a host the driver or its flow control holds the
    /// bytes.
    transmit_stalled = 0x99,
    /// The client's `advance` was never called, and without it no line counts as silent: nothing was sent. Found out where
    /// RTUWIRE_CHECKED is 1, at a visit a response time-out behind the first one, of each request in its turn; but not of those of
    /// a conversation that makes them at the last moment, as what commands a motor does, nor while a stop waits.
    /// Remedy: Call `advance` in each pass, before `converse`.
    never_advanced = 0xA8,
    /// The caller cancelled the transaction, or its conversation stayed away.
    /// Remedy: Nothing to mend, if it was meant; `converse` has to be called in each pass.
    cancelled = 0x9A,

    // The serial device of a host.
    /// There is no such device.
    /// Remedy: Check the path, and that the adapter is plugged in: `ls /dev/ttyUSB* /dev/ttyACM*`.
    device_not_found = 0x9B,
    /// The user may not open the device.
    /// Remedy: Join the group that owns it, as a rule `dialout`, and log in again.
    device_access_denied = 0x9C,
    /// Another program has the device.
    /// Remedy: End that program: one client is enough for a line.
    device_in_use = 0x9D,
    /// The path is not a serial device.
    /// Remedy: Give the path of a terminal device.
    device_not_serial = 0x9E,
    /// The device does not support the bit rate or the character format.
    /// Remedy: Take a rate and a format that the adapter has; check what its driver says.
    device_setting_refused = 0x9F,
    /// The device was unplugged.
    /// Remedy: Plug it in and open it again; a motor has to be ordered anew.
    device_vanished = 0xA0,
    /// The port is not open.
    /// Remedy: Look at the result of `open` before the first use.
    device_not_open = 0xA1,
    /// Any other failure of the operating system's call.
    /// Remedy: See what the system says (`dmesg`), and open the port again.
    device_failed = 0xA2,
};

/// Whether a server sent this error as an exception response.
[[nodiscard]] constexpr bool is_exception(errc error) noexcept
{
    return error != errc::none and static_cast<std::uint8_t>(error) < 0x80;
}

namespace detail {

/// The error for an exception code from the wire.
[[nodiscard]] constexpr errc exception_error(std::uint8_t code) noexcept
{
    return code == 0 or code >= 0x80 ? errc::unlisted_exception : static_cast<errc>(code);
}

} // namespace detail

/// What kind of error a code is: whose fault it is, and whether a request left.
enum class error_category : std::uint8_t {
    none,          ///< no error
    exception,     ///< the server answered with an exception response
    request,       ///< what the caller requested is not possible; nothing was written or sent
    reception,     ///< what was received is not what it should be; nothing of it was passed on
    no_response,   ///< the transaction ended without a response
    serial_device, ///< the serial device of a host
    unknown,       ///< a number from 0x80 on that is no error
};

/// The kind of an error; any exception code is an `exception`, listed or not. By name: a code that is not listed here
/// does not compile, and nothing rests on the order or the numbers of the local causes.
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
    case errc::never_advanced:
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

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

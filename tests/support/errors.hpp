// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All errors that have a name, each with its number and its kind: the one list for tests that walk them.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/wire/errc.hpp>

namespace rtuwire::test {

using namespace detail;

struct known_error {
    errc error;
    std::uint8_t number;
    error_category category;
};

inline constexpr auto all_errors = [] {
    using enum errc;
    using kind = error_category;
    return std::array{
        known_error{none, 0x00, kind::none},
        known_error{illegal_function, 0x01, kind::exception},
        known_error{illegal_data_address, 0x02, kind::exception},
        known_error{illegal_data_value, 0x03, kind::exception},
        known_error{server_device_failure, 0x04, kind::exception},
        known_error{acknowledge, 0x05, kind::exception},
        known_error{server_device_busy, 0x06, kind::exception},
        known_error{negative_acknowledge, 0x07, kind::exception},
        known_error{memory_parity_error, 0x08, kind::exception},
        known_error{gateway_path_unavailable, 0x0A, kind::exception},
        known_error{gateway_target_failed_to_respond, 0x0B, kind::exception},
        known_error{unlisted_exception, 0x7F, kind::exception},
        known_error{buffer_too_small, 0x80, kind::request},
        known_error{invalid_unit, 0x81, kind::request},
        known_error{invalid_quantity, 0x82, kind::request},
        known_error{invalid_address_range, 0x83, kind::request},
        known_error{invalid_function, 0x84, kind::request},
        known_error{not_for_broadcast, 0x85, kind::request},
        known_error{busy, 0x86, kind::request},
        known_error{used_already, 0x88, kind::request},
        known_error{overruled, 0x89, kind::request},
        known_error{unit_lost, 0x8A, kind::request},
        known_error{too_many_ordered, 0x8B, kind::request},
        known_error{frame_too_short, 0x8C, kind::reception},
        known_error{frame_too_long, 0x8D, kind::reception},
        known_error{wrong_length, 0x8E, kind::reception},
        known_error{crc_mismatch, 0x8F, kind::reception},
        known_error{uart_error, 0x90, kind::reception},
        known_error{wrong_unit, 0x91, kind::reception},
        known_error{wrong_function, 0x92, kind::reception},
        known_error{response_mismatch, 0x93, kind::reception},
        known_error{malformed, 0x94, kind::reception},
        known_error{line_echo, 0x95, kind::reception},
        known_error{collision, 0x96, kind::reception},
        known_error{timed_out, 0x97, kind::no_response},
        known_error{bus_jam, 0x98, kind::no_response},
        known_error{transmit_stalled, 0x99, kind::no_response},
        known_error{cancelled, 0x9A, kind::no_response},
        known_error{device_not_found, 0x9B, kind::serial_device},
        known_error{device_access_denied, 0x9C, kind::serial_device},
        known_error{device_in_use, 0x9D, kind::serial_device},
        known_error{device_not_serial, 0x9E, kind::serial_device},
        known_error{device_setting_refused, 0x9F, kind::serial_device},
        known_error{device_vanished, 0xA0, kind::serial_device},
        known_error{device_not_open, 0xA1, kind::serial_device},
        known_error{device_failed, 0xA2, kind::serial_device},
        known_error{value_too_high, 0xA3, kind::request},
        known_error{value_too_low, 0xA4, kind::request},
        known_error{value_between_steps, 0xA5, kind::request},
        known_error{value_never_written, 0xA6, kind::request},
        known_error{value_without_meaning, 0xA7, kind::request},
        known_error{never_advanced, 0xA8, kind::no_response},
    };
}();

} // namespace rtuwire::test

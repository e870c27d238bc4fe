// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device with registers of each kind and form, for the refused acts.
#pragma once

#include <rtuwire/client.hpp>

using namespace rtuwire;

namespace meter {
enum class tariff : std::uint16_t { day = 1, night = 2 };
inline constexpr reg<float32<kilowatt_hours>> energy{.code = "E", .address = 10, .max = 1000};
inline constexpr reg<unsigned32<watt_hours>> budget{.code = "B", .address = 12, .max = 5'000};
inline constexpr reg<ascii<4>> place{.code = "N", .address = 14};
inline constexpr reg<count16> gain{.code = "G", .address = 40};
inline constexpr input_reg<signed_count16> scale{.code = "SF", .address = 3};
inline constexpr input_reg<decivolts> voltage{.code = "U", .address = 1};
inline constexpr input_reg<scaled_by<volts, scale>> phase{.code = "P", .address = 2};
inline constexpr coil relay{.code = "K1", .address = 1};
inline constexpr coil lamp{.code = "H1", .address = 2};
inline constexpr discrete_input door{.code = "S1", .address = 1};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions{function_code::read_holding_registers,
                                            function_code::read_input_registers,
                                            function_code::read_coils,
                                            function_code::write_single_coil,
                                            function_code::write_single_register,
                                            function_code::write_multiple_registers};
    static constexpr device_limits limits{.read = 4, .write = 4};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<energy, budget, place, gain, scale, voltage, phase, relay, lamp, door>;
};
} // namespace meter

inline constexpr station<meter::device> unit{unit_id{3}};

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of its configurations, its display and its function blocks.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// Where the configuration is saved.
enum class configuration_save : std::uint16_t {
    no = 0, configuration_0 = 1, configuration_1 = 2, configuration_2 = 3,
};

/// Which configuration is recalled.
enum class configuration_recall : std::uint16_t {
    no = 0, configuration_1 = 2, configuration_2 = 3, factory = 64, factory_1 = 71,
};

/// What a function key does.
enum class key_function : std::uint16_t {
    no = 0, jog = 180, preset_1 = 181, preset_2 = 182, pi_preset_1 = 183, pi_preset_2 = 184, faster
    = 185, slower = 186, local = 187,
};

/// What happens when the keypad takes over.
enum class keypad_takeover : std::uint16_t {
    stop = 0, bumpless = 1,
};

/// What the drive is prepared for.
enum class macro_configuration : std::uint16_t {
    start_stop = 0, handling = 1, hoisting = 2, general = 3, pi = 4, network = 5,
};

/// What starts and stops the function blocks.
enum class block_command : std::uint16_t {
    stop = 0, start = 1,
};

/// What stopped function blocks do to the drive.
enum class block_on_fault : std::uint16_t {
    stop = 0, ignore = 1,
};

/// What is wrong with the function blocks.
enum class block_fault : std::uint16_t {
    no = 0, internal = 1, binary = 2, internal_parameters = 3, access = 4, calculation = 5,
    auxiliary_overrun = 6, synchronous_overrun = 7, container = 8, inputs = 9,
};

/// What the function blocks are doing.
enum class block_state : std::uint16_t {
    idle = 0, checking = 1, stopped = 2, initialising = 3, running = 4, error = 5,
};

/// As which drive it shows itself on a network.
enum class network_identity : std::uint16_t {
    atv320 = 0, atv32 = 1,
};

/// S001, pulses of the function blocks.
enum class clock_word_bit : std::uint8_t {
    clock_100ms = 5, clock_1s = 6, clock_1min = 7, first_cycle = 13,
};
using clock_word = flags<clock_word_bit>;

/// S002, which lines are in order.
enum class communication_word_bit : std::uint8_t {
    option_ok = 11, canopen_ok = 12, modbus_ok = 13,
};
using communication_word = flags<communication_word_bit>;

/// S006.
enum class save_word_bit : std::uint8_t {
    save_variables = 15,
};
using save_word = flags<save_word_bit>;
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::configuration_save> = detail::name_list<altivar::atv320_values::configuration_save>({
    {0, "nO"}, {1, "Str0"}, {2, "Str1"}, {3, "Str2"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::configuration_save> = detail::name_list<altivar::atv320_values::configuration_save>({
    {0, "none"}, {1, "save as configuration 0"}, {2, "save as configuration 1"}, {3, "save as configuration 2"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::configuration_recall> = detail::name_list<altivar::atv320_values::configuration_recall>({
    {0, "nO"}, {2, "rEC1"}, {3, "rEC2"}, {64, "InI"}, {71, "InI1"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::configuration_recall> = detail::name_list<altivar::atv320_values::configuration_recall>({
    {0, "none"}, {2, "load configuration 1"}, {3, "load configuration 2"}, {64, "factory settings"},
    {71, "factory settings, variant InI1"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::key_function> = detail::name_list<altivar::atv320_values::key_function>({
    {0, "nO"}, {180, "FnJOG"}, {181, "FnPS1"}, {182, "FnPS2"}, {183, "FnPr1"}, {184, "FnPr2"}, {185, "FnUSP"},
    {186, "FndSP"}, {187, "FntK"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::key_function> = detail::name_list<altivar::atv320_values::key_function>({
    {0, "not assigned"}, {180, "jog"}, {181, "preset speed 1"}, {182, "preset speed 2"},
    {183, "PI preset reference 1"}, {184, "PI preset reference 2"}, {185, "faster"}, {186, "slower"},
    {187, "control by the keypad"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::keypad_takeover> = detail::name_list<altivar::atv320_values::keypad_takeover>({
    {0, "StOP"}, {1, "bUMP"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::keypad_takeover> = detail::name_list<altivar::atv320_values::keypad_takeover>({
    {0, "cleared: the motor stops"}, {1, "command and reference taken over"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::macro_configuration> = detail::name_list<altivar::atv320_values::macro_configuration>({
    {0, "StS"}, {1, "HdG"}, {2, "HSt"}, {3, "GEn"}, {4, "PId"}, {5, "nEt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::macro_configuration> = detail::name_list<altivar::atv320_values::macro_configuration>({
    {0, "start and stop"}, {1, "material handling"}, {2, "hoisting"}, {3, "general use"}, {4, "PI regulator"},
    {5, "network"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::block_command> = detail::name_list<altivar::atv320_values::block_command>({
    {0, "StOP"}, {1, "Strt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::block_command> = detail::name_list<altivar::atv320_values::block_command>({
    {0, "stop"}, {1, "start"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::block_on_fault> = detail::name_list<altivar::atv320_values::block_on_fault>({
    {0, "StOP"}, {1, "IGn"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::block_on_fault> = detail::name_list<altivar::atv320_values::block_on_fault>({
    {0, "stop"}, {1, "go on"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::block_fault> = detail::name_list<altivar::atv320_values::block_fault>({
    {0, "nO"}, {1, "Int"}, {2, "bIn"}, {3, "InP"}, {4, "PAr"}, {5, "CAL"}, {6, "tOAU"}, {7, "tOPP"}, {8, "AdL"},
    {9, "In"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::block_fault> = detail::name_list<altivar::atv320_values::block_fault>({
    {0, "no fault"}, {1, "internal error"}, {2, "wrong binary file"}, {3, "wrong internal parameters"},
    {4, "parameter access refused"}, {5, "calculation error"}, {6, "auxiliary task too slow"},
    {7, "synchronous task too slow"}, {8, "wrong address container (ADLC)"}, {9, "wrong input assignment"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::block_state> = detail::name_list<altivar::atv320_values::block_state>({
    {0, "IdLE"}, {1, "CHEC"}, {2, "StOP"}, {3, "InIt"}, {4, "rUn"}, {5, "Err"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::block_state> = detail::name_list<altivar::atv320_values::block_state>({
    {0, "no program"}, {1, "checking the program"}, {2, "stopped"}, {3, "initialising"}, {4, "running"},
    {5, "in error"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::network_identity> = detail::name_list<altivar::atv320_values::network_identity>({
    {0, "AtV320"}, {1, "AtV32"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::network_identity> = detail::name_list<altivar::atv320_values::network_identity>({
    {0, "ATV320"}, {1, "ATV32"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::clock_word_bit> = detail::name_list<altivar::atv320_values::clock_word_bit>({
    {5, "100 ms clock, half on"}, {6, "1 s clock, half on"}, {7, "1 min clock, half on"},
    {13, "first cycle since start"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::communication_word_bit> = detail::name_list<altivar::atv320_values::communication_word_bit>({
    {11, "option works"}, {12, "CANopen works"}, {13, "Modbus works"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::save_word_bit> = detail::name_list<altivar::atv320_values::save_word_bit>({
    {15, "save the user's variables"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

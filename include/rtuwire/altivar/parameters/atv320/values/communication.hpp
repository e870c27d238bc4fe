// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of its lines and networks, and of its identity.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// The state of an EtherCAT slave.
enum class ethercat_state : std::uint16_t {
    init = 1, pre_operational = 2, bootstrap = 3, safe_operational = 4, operational = 8,
};

/// Bit rate of CANopen.
enum class can_rate : std::uint16_t {
    baud_50k = 38, baud_125k = 52, baud_250k = 60, baud_500k = 68, baud_1m = 76,
};

/// Profile of Profibus.
enum class profibus_profile : std::uint16_t {
    unconfigured = 0, ppo_1 = 1, ppo_2 = 2, ppo_7 = 7, ppo_9 = 9, ppo_100 = 100, ppo_101 = 101,
    ppo_102 = 102,
};

/// Which Profibus master commands.
enum class profibus_master : std::uint16_t {
    class_1 = 1, class_2 = 2,
};

/// The assembly of inputs or outputs on DeviceNet and EtherNet/IP.
enum class io_assembly : std::uint16_t {
    assembly_20_70 = 0, assembly_21_71 = 1, assembly_100_101 = 2, unconfigured = 3,
};

/// A switch.
enum class off_on : std::uint16_t {
    off = 0, on = 1,
};

/// The supply of an encoder card.
enum class encoder_card : std::uint16_t {
    no = 0, rs422_5v = 1, push_pull_24v = 2, collector_15v = 3, collector_12v = 4, rs422_15v = 5,
    push_pull_15v = 6, push_pull_12v = 7,
};
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::ethercat_state> = detail::name_list<altivar::atv320_values::ethercat_state>({
    {1, "InIt"}, {2, "PrOP"}, {3, "bOOt"}, {4, "SFOP"}, {8, "OP"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ethercat_state> = detail::name_list<altivar::atv320_values::ethercat_state>({
    {1, "Init"}, {2, "Pre-Operational"}, {3, "Bootstrap"}, {4, "Safe-Operational"}, {8, "Operational"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::can_rate> = detail::name_list<altivar::atv320_values::can_rate>({
    {38, "50"}, {52, "125"}, {60, "250"}, {68, "500"}, {76, "1M"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::can_rate> = detail::name_list<altivar::atv320_values::can_rate>({
    {38, "50 kbit/s"}, {52, "125 kbit/s"}, {60, "250 kbit/s"}, {68, "500 kbit/s"}, {76, "1 Mbit/s"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::profibus_profile> = detail::name_list<altivar::atv320_values::profibus_profile>({
    {0, "UnCG"}, {1, "1"}, {2, "2"}, {7, "7"}, {9, "9"}, {100, "100"}, {101, "101"}, {102, "102"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::profibus_profile> = detail::name_list<altivar::atv320_values::profibus_profile>({
    {0, "not configured"}, {1, "profile 1"}, {2, "profile 2"}, {7, "profile 7"}, {9, "profile 9"},
    {100, "profile 100"}, {101, "profile 101"}, {102, "profile 102"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::profibus_master> = detail::name_list<altivar::atv320_values::profibus_master>({
    {1, "1"}, {2, "2"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::profibus_master> = detail::name_list<altivar::atv320_values::profibus_master>({
    {1, "class 1"}, {2, "class 2"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::io_assembly> = detail::name_list<altivar::atv320_values::io_assembly>({
    {0, "20"}, {1, "21"}, {2, "100"}, {3, "UnCG"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::io_assembly> = detail::name_list<altivar::atv320_values::io_assembly>({
    {0, "20/70"}, {1, "21/71"}, {2, "100/101"}, {3, "not configured"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::off_on> = detail::name_list<altivar::atv320_values::off_on>({
    {0, "OFF"}, {1, "On"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::off_on> = detail::name_list<altivar::atv320_values::off_on>({
    {0, "off"}, {1, "on"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::encoder_card> = detail::name_list<altivar::atv320_values::encoder_card>({
    {0, "nO"}, {1, "rS05"}, {2, "PP24"}, {3, "OC15"}, {4, "OC12"}, {5, "rS15"}, {6, "PP15"}, {7, "PP12"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::encoder_card> = detail::name_list<altivar::atv320_values::encoder_card>({
    {0, "none"}, {1, "RS-422, 5 V"}, {2, "push-pull, 24 V"}, {3, "open collector, 15 V"},
    {4, "open collector, 12 V"}, {5, "RS-422, 15 V"}, {6, "push-pull, 15 V"}, {7, "push-pull, 12 V"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

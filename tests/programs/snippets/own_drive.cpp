// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/driving.md
// BEGINS: namespace pump_drive
// FOR: struct device { => struct device : facts {
// FOR: eta.address, /* ... */ => eta.address, .lft = lft.address, .cmi = cmi.address, .eti = eti.address,
// FOR: .longest_silence => .rfr = rfr.address, .longest_silence
// FOR: lfr, /* ... */ sll => lfr, lfrd, cmi, rfrd, eta, eti, rfr, lft, tto, sll
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace pump_drive {
inline constexpr reg<signed_rpm> lfrd{.code = "LFRD", .address = 52'010};
inline constexpr reg<extended_command_word> cmi{.code = "CMI", .address = 52'020};
inline constexpr reg<signed_rpm> rfrd{.code = "RFRD", .address = 2'310, .mode = access::read_only};
inline constexpr reg<status_word> eta{.code = "ETA", .address = 2'311, .mode = access::read_only};
inline constexpr reg<extended_status_word> eti{.code = "ETI", .address = 2'330, .mode = access::read_only};
inline constexpr reg<signed_decihertz> rfr{.code = "RFR", .address = 2'340, .mode = access::read_only};
inline constexpr reg<count16> lft{.code = "LFT", .address = 2'350, .mode = access::read_only};
inline constexpr reg<deciseconds> tto{.code = "TTO", .address = 1'021, .mode = access::configuration, .factory = 20};
inline constexpr reg<count16> sll{.code = "SLL", .address = 1'022, .mode = access::configuration};

struct facts {
    static constexpr literal name{"pump_drive"};
    static constexpr literal reference{"PD1"};
    static constexpr function_set functions{function_code::read_holding_registers, function_code::write_single_register,
                                            function_code::write_multiple_registers};
    static constexpr device_limits limits{11, 9, 0, 0};
    static constexpr unit_range units{40, 59};
    static constexpr std::array<address_range, 0> readable{};
};
} // namespace pump_drive

// BLOCK

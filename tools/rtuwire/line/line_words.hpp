// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Words of the command line that say how the line is set and who is asked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/client.hpp>

#include "choices.hpp"
#include "line/unit_address.hpp"
#include "words/named_places.hpp"

namespace tool {

/// The formats of a character, as they are typed. Parity and two stop bits, of 12 bits, are met in the field and are not the
/// standard's.
struct named_format {
    std::string_view name;
    rtuwire::character_format format;
};
inline constexpr named_format all_formats[]{
    {"8E1", rtuwire::character_format::even_8_1}, {"8N1", rtuwire::character_format::none_8_1},
    {"8O1", rtuwire::character_format::odd_8_1},  {"8N2", rtuwire::character_format::none_8_2},
    {"8E2", rtuwire::character_format::even_8_2}, {"8O2", rtuwire::character_format::odd_8_2}};

/// "8E1"; refuses others.
rtuwire::character_format format_in(std::string const& word);

/// "8E1".
std::string name_of_format(rtuwire::character_format format);

/// A bit rate that this system has; refuses others.
std::uint32_t baud_in(unsigned number);

/// "1-247", "1,3,7-9": each once, in rising order. Refuses what is no address of a unit.
std::vector<std::uint8_t> units_in(std::string const& word);

/// A unit, and what is known of it by --name and --drive.
struct named_unit {
    unit_address unit;
    std::string name{};                 ///< empty where it has none
    std::string drive{};                ///< empty where nobody said; of --name also a register file
    named_places const* names{nullptr}; ///< of --device, or of that file
};

/// The unit that --unit means: an address, or one of the names. Refuses others, with the nearest name.
named_unit unit_in(line_choices const& line);

/// The same for what writes to a unit, or runs its motor: refuses where nobody said which.
named_unit unit_to_change(choices const& chosen);

/// Whether the type that --name says is a register file, or the name of one: "meter=61:meter.toml", "meter=61:sdm630". The name
/// of a drive is that drive.
bool is_register_file(std::string_view type);

/// All that --name names. Refuses a name for two units, and two types for one unit.
std::vector<named_unit> names_in(line_choices const& line);

/// A command that does what it says where it is pasted: this program on the line of this one, then `words`. It asks the unit
/// that this command asks.
std::string shown_command(line_choices const& line, std::string_view words);

/// The same for another unit of the line.
std::string shown_command(line_choices const& line, unit_address unit, std::string_view words);

/// "`rtuwire ... stop` stops it, and says so, where the drive hears that": what is left to do about a motor whose port failed.
std::string way_to_stop(line_choices const& line);

/// Seconds as the library counts them.
rtuwire::duration seconds_in(double seconds);

} // namespace tool

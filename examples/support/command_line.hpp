// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the examples understand of their command lines beside plain flags: drives, units, serial settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <rtuwire/port.hpp>

#include "../../tools/rtuwire/port/named_drives.hpp"
#include "arguments.hpp"

namespace examples {

using namespace tool;

using tool::drive_names;
using tool::station_at;
using tool::with_drive;

/// The format of that name.
inline std::optional<rtuwire::character_format> format_named(std::string const& name)
{
    using rtuwire::character_format;
    constexpr std::pair<std::string_view, character_format> known[]{
        {"8E1", character_format::even_8_1}, {"8O1", character_format::odd_8_1},  {"8N1", character_format::none_8_1},
        {"8N2", character_format::none_8_2}, {"8E2", character_format::even_8_2}, {"8O2", character_format::odd_8_2}};
    for (auto const& [word, format] : known) {
        if (name == word) {
            return format;
        }
    }
    return std::nullopt;
}

/// Where a line is and how it is set.
struct line_choice {
    std::string port{};
    rtuwire::serial_settings settings{};

    /// Takes --port, --baud or --format; false for another flag. Refuses a wrong value.
    bool take(arguments& words)
    {
        if (words.flag() == "--port") {
            port = words.value();
        } else if (words.flag() == "--baud") {
            settings.bits_per_second = rate(words.number());
        } else if (words.flag() == "--format") {
            settings.format = format(words.value());
        } else {
            return false;
        }
        return true;
    }

private:
    static std::uint32_t rate(std::uint32_t number)
    {
        if (not rtuwire::is_bit_rate(number)) {
            throw usage_error{"--baud " + std::to_string(number) + ": this system has no such bit rate"};
        }
        return number;
    }

    static rtuwire::character_format format(std::string const& name)
    {
        auto const found = format_named(name);
        if (not found) {
            throw usage_error{"--format " + name + ": there are only 8E1, 8O1, 8N1, 8N2, 8E2 and 8O2"};
        }
        return *found;
    }
};

} // namespace examples

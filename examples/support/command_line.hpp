// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the examples understand of their command lines: names of drives, numbers, serial settings.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <type_traits>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/port/serial_settings.hpp>

namespace examples {

inline constexpr char drive_names[] = "atv12|atv28|atv310|atv310_2026|atv320";

/// Calls `use` with the device of that name, as a `std::type_identity`; false for a name of none.
template <typename Use> bool with_drive(std::string const& name, Use use)
{
    using namespace rtuwire::altivar;
    if (name == "atv12") {
        use(std::type_identity<atv12::device>{});
    } else if (name == "atv28") {
        use(std::type_identity<atv28::device>{});
    } else if (name == "atv310") {
        use(std::type_identity<atv310::device>{});
    } else if (name == "atv310_2026") {
        use(std::type_identity<atv310::device_2026>{});
    } else if (name == "atv320") {
        use(std::type_identity<atv320::device>{});
    } else {
        return false;
    }
    return true;
}

/// A whole decimal number of at most nine digits, or nothing.
inline std::optional<std::uint32_t> number_in(std::string const& word)
{
    bool const is_number = not word.empty() and word.size() < 10 and
                           word.find_first_not_of("0123456789") == std::string::npos;
    if (not is_number) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(std::strtoul(word.c_str(), nullptr, 10));
}

/// The format of that name.
inline std::optional<rtuwire::character_format> format_named(std::string const& name)
{
    using rtuwire::character_format;
    if (name == "8E1") {
        return character_format::even_8_1;
    }
    if (name == "8O1") {
        return character_format::odd_8_1;
    }
    if (name == "8N1") {
        return character_format::none_8_1;
    }
    if (name == "8N2") {
        return character_format::none_8_2;
    }
    return std::nullopt;
}

/// Where a line is and how it is set.
struct line_choice {
    std::string port{};
    rtuwire::serial_settings settings{};

    /// Takes --port, --baud or --format; false for another flag or a wrong value.
    bool take(std::string const& flag, std::string const& value)
    {
        auto const rate = number_in(value);
        auto const format = format_named(value);
        if (flag == "--port") {
            port = value;
            return not value.empty();
        }
        if (flag == "--baud" and rate and rtuwire::speed_code(*rate)) {
            settings.bits_per_second = *rate;
            return true;
        }
        if (flag == "--format" and format) {
            settings.format = *format;
            return true;
        }
        return false;
    }
};

} // namespace examples

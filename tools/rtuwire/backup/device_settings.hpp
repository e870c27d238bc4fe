// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The settings of what is no drive: the registers of its register file that say setting = true, as a file has them or as
// they were read.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "backup/saved_text.hpp"
#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/who_is_it.hpp"
#include "words/named_places.hpp"

namespace tool {

/// One setting. It has words or an error.
struct device_value {
    named_place const* named;
    std::vector<std::uint16_t> words{};
    std::string error{}; ///< why there are none
    text_place place{};  ///< of its value in a file
};

struct device_settings {
    std::vector<std::pair<std::string, std::string>> head{}; ///< "device", "time" and so on
    std::vector<device_value> values{};                      ///< in the order of the register file

    /// What its head says; empty where it says nothing.
    [[nodiscard]] std::string said(std::string_view name) const;
    /// Null where there is none.
    [[nodiscard]] device_value const* find(named_place const* named) const noexcept;
};

/// Reads every setting of a unit. Ends the command where it does not answer, says by function 43 that it is another device than
/// the register file's, has told none of them, or the port fails.
device_settings device_settings_of(open_line& line, named_unit const& unit, std::string const& port);

/// The same of some settings of a unit that was asked who it is.
std::vector<device_value> read_settings(open_line& line, named_unit const& unit,
                                        std::vector<named_place const*> const& wanted);

/// A file's settings. Ends the command where the file cannot be read, or something is wrong in it, with the place: a name that
/// the register file does not have, or that is no setting, a value that is none or contradicts its raw count.
device_settings device_settings_of_file(std::string const& path, named_places const& names);

/// Ends the command where a unit says by function 43 that it is another device than these words say, which may be empty. What it
/// says.
identity_words refuse_another_device(open_line& line, rtuwire::unit_id unit, std::string const& vendor,
                                     std::string const& product);

/// A value as people read it: "21.5 degC"; why there is none.
[[nodiscard]] std::string text_of(device_value const& value);

[[nodiscard]] std::string json_text_of(device_settings const& settings);
[[nodiscard]] std::string csv_text_of(device_settings const& settings);

} // namespace tool

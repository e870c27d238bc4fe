// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a person can have done on the line: scan it, find out who a unit is, read and watch values, read all settings of a drive.
// Each only asks, and tells what came as events.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "asked_line.hpp"
#include "catalog/catalog.hpp"
#include "points.hpp"

namespace line_page {

/// Who a unit is, as far as it tells. It must outlive those who ask.
struct identity {
    bool is_there{false};
    bool is_known{false}; ///< it was asked
    std::string vendor{};
    std::string product{};
    std::string revision{};
    tool::drive_catalog const* drive{nullptr};
    bool may_be_drive{false};
    std::string note{};
};

using identities = std::vector<identity>; ///< by unit, of 256

/// Asks addresses one after the other; an echo, or another client, ends it.
steps scan(asked_line& line, identities& all, std::uint8_t first, std::uint8_t last);

/// By function 43, else by registers; what it finds is told, and is what consent is judged by.
steps identify(asked_line& line, identities& all, std::uint8_t unit);

/// Reads values once, or with a period from the beginning of one round to that of the next (0: once). `most` registers a request, and
/// no more than a drive takes.
steps watch(asked_line& line, identities& all, std::uint8_t unit, std::vector<point> points, microseconds period,
            std::uint16_t most);

/// Reads all settings of a drive; `file` is a backup as the command line tool writes it then, else empty.
steps back_up(asked_line& line, identities& all, std::uint8_t unit, std::string time_text, std::string& file);

} // namespace line_page

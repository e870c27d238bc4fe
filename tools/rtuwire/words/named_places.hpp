// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Places of a device that its register file has names for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "words/place.hpp"

namespace tool {

struct named_place {
    place where; ///< with the name
    bool is_writable{false};
    std::optional<double> lowest{}; ///< in the unit
    std::optional<double> highest{};
    unsigned line{0}; ///< of the file
};

/// What a register file says of a device.
struct named_places {
    std::string file{};
    std::vector<named_place> places{};

    /// In upper or lower case; null where there is none.
    [[nodiscard]] named_place const* by_name(std::string_view name) const noexcept;
    /// The first that shares a register or a bit with a place; null where none does.
    [[nodiscard]] named_place const* overlapping(place const& where) const noexcept;
};

/// What words mean: of a drive, of a register file, of both or of neither.
struct vocabulary {
    vocabulary(drive_catalog const* of, named_places const* said = nullptr) noexcept : drive{of}, names{said} {}

    drive_catalog const* drive;
    named_places const* names;
};

/// Whether two places share a register or a bit.
[[nodiscard]] bool overlap(place const& one, place const& other) noexcept;

/// What is wrong with a name; empty where nothing is. No shell, topic or spreadsheet takes a right one for an order, and no
/// place looks like it.
[[nodiscard]] std::string why_no_name(std::string_view name);

} // namespace tool

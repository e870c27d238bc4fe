// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What tells a drive, and one type from another: names by which they call themselves, and registers that only one has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"

namespace tool {

/// "ATV320U07M2B" -> "ATV320".
[[nodiscard]] std::string_view family_of(std::string_view product);

/// Whether a name has one of the families of drives and starters in it, also of those of which this program has no table:
/// "ATV71HU22", "Altivar 71".
[[nodiscard]] bool names_a_drive(std::string const& name);

/// The first register for driving that one drive has, and another has not at all.
[[nodiscard]] std::optional<std::uint16_t> only_in(drive_catalog const& one, drive_catalog const& other);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Types of the points of SunSpec models.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tool {

/// What a type of a point is here, its registers, and the bits that say that the device does not have it.
struct sunspec_type {
    std::string_view name;
    std::string_view type;
    std::int64_t registers;
    std::optional<std::uint64_t> missing;
};
constexpr sunspec_type sunspec_types[]{
    {"int16", "i16", 1, 0x8000},
    {"uint16", "", 1, 0xFFFF},
    {"enum16", "", 1, 0xFFFF},
    {"bitfield16", "hex", 1, 0xFFFF},
    {"raw16", "hex", 1, std::nullopt},
    {"count", "", 1, 0},
    {"acc16", "", 1, 0},
    {"sunssf", "i16", 1, 0x8000},
    {"int32", "i32", 2, 0x8000'0000},
    {"uint32", "u32", 2, 0xFFFF'FFFF},
    {"enum32", "u32", 2, 0xFFFF'FFFF},
    {"bitfield32", "u32", 2, 0xFFFF'FFFF},
    {"acc32", "u32", 2, 0},
    {"ipaddr", "u32", 2, 0},
    {"float32", "f32", 2, std::nullopt},
    {"int64", "i64", 4, 0x8000'0000'0000'0000},
    {"uint64", "u64", 4, 0xFFFF'FFFF'FFFF'FFFF},
    {"bitfield64", "u64", 4, 0xFFFF'FFFF'FFFF'FFFF},
    {"acc64", "u64", 4, 0},
    {"float64", "f64", 4, std::nullopt},
};

/// Null where a type is none of numbers.
[[nodiscard]] constexpr sunspec_type const* sunspec_type_named(std::string_view name) noexcept
{
    auto const* const found = std::ranges::find(sunspec_types, name, &sunspec_type::name);
    return found == std::end(sunspec_types) ? nullptr : found;
}

} // namespace tool

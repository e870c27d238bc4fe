// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The points of a model that a unit has: named by the model's file, read and scaled as it says.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "import/source_value.hpp"
#include "sunspec/model_list.hpp"
#include "words/place.hpp"

namespace tool {

/// One point. Its words are those of the registers of its model.
struct sunspec_point {
    std::string name{};     ///< "103.A", "160.module_2.DCA"
    std::string title{};    ///< for people
    std::uint16_t offset{}; ///< from the model's first register
    std::uint16_t registers{};
    source_value const* from{nullptr};
    std::string
        group{}; ///< of the group that it stands in, with a point behind it; what its scale is, is looked up there
};

/// The points in the order of the registers, as far as the model reaches. A group that stands there several times is counted
/// by the point of that name, or up to the end. What stops that early is added to `told`.
[[nodiscard]] std::vector<sunspec_point> points_of(source_value const& file, std::span<std::uint16_t const> words,
                                                   std::vector<std::string>& told);

/// A value as it is meant.
struct sunspec_value {
    cell raw{};   ///< the registers
    cell value{}; ///< nothing where the device does not have it
    std::string measure{};
    std::string text{};
};
[[nodiscard]] sunspec_value value_of(sunspec_point const& point, std::span<sunspec_point const> all,
                                     std::span<std::uint16_t const> words);

} // namespace tool

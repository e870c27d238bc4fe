// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Values of a unit by name, or by what a person typed: where they stand, and what their registers mean.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "frame/register_names.hpp"
#include "words/place.hpp"

namespace line_page {

struct point {
    std::string name{};
    tool::register_space space{tool::register_space::holding};
    std::uint16_t address{0};
    std::uint16_t count{1}; ///< registers, or 1 bit
    tool::value_type type{tool::value_type::u16};
    std::uint16_t letters{0}; ///< of a text
    std::string order{};      ///< of four letters, "cdab", of 64 bits by their words; empty: the high register first
    tool::step_size step{};   ///< of one count, in the unit
    std::string unit{};
    std::vector<std::pair<std::string, std::int64_t>> choices{};
    std::vector<std::uint64_t> invalid{}; ///< bits that mean no value
    tool::register_entry const* entry{nullptr};

    [[nodiscard]] std::uint8_t function() const noexcept;
};

struct points_read {
    std::vector<point> points{};
    std::string flaw{}; ///< the line that names nothing
};

/// A point a line: a drive's mnemonic, `3201`, `input:1000:f32:cdab`, `coil:0-7`; or the fields of a register file with tabs
/// between: name, place, scale, unit, choices, counts that mean no value. All of them or none.
[[nodiscard]] points_read points_in(std::string_view text, tool::drive_catalog const* drive);

struct point_value {
    std::string number{}; ///< a number of JSON; empty where it is none
    std::string text{};
    std::string wide{}; ///< of what only the page can write in decimal: "f64:" or "u64:", and its bits
};
[[nodiscard]] point_value value_of(point const& of, tool::drive_catalog const* drive,
                                   std::span<std::uint16_t const> words);

/// The names of a device's points, for its frames.
class point_names final : public tool::register_names {
public:
    explicit point_names(std::vector<point> its_points) : points_{std::move(its_points)} {}

    std::string name_at(tool::register_space space, unsigned address) const override;
    std::vector<tool::passed_value> values_at(tool::register_space space, unsigned address,
                                              std::span<std::uint16_t const> words) const override;

private:
    point const* at(tool::register_space space, unsigned address) const;

    std::vector<point> points_;
};

} // namespace line_page

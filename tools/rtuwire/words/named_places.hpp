// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Places of a device that its register file has names for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "words/place.hpp"

namespace tool {

/// What a number of a register stands for.
struct named_choice {
    std::string name;
    std::int64_t number;
};

/// Registers that are read together, and how often.
struct named_group {
    std::string name;
    double period; ///< seconds
};

struct named_place {
    place where; ///< with the name
    bool is_writable{false};
    bool is_setting{false};         ///< of those that are backed up and restored
    bool is_stored{false};          ///< a write of it wears the device's memory
    bool moves{false};              ///< something moves after a write of it
    std::optional<double> lowest{}; ///< in the unit
    std::optional<double> highest{};
    std::vector<named_choice> choices{};    ///< all that it may be; empty where it is a number
    std::vector<std::uint64_t> invalid{};   ///< the bits that mean no value
    std::string group{};                    ///< empty where it has none
    std::vector<std::uint16_t> simulated{}; ///< with what a simulated device begins; empty: with 0
    unsigned line{0};                       ///< of the file
};

/// What a register file says of a device.
struct named_places {
    std::string file{};
    std::vector<named_place> places{};
    std::vector<named_group> groups{};
    std::optional<std::uint16_t> max_registers{}; ///< of one request
    std::optional<unsigned> pause{};              ///< milliseconds of silence before a request
    std::string vendor{}; ///< what the unit says of itself by function 43; empty where nobody said
    std::string product{};

    /// In upper or lower case; null where there is none.
    [[nodiscard]] named_place const* by_name(std::string_view name) const noexcept;
    /// The first that shares a register or a bit with a place; null where none does.
    [[nodiscard]] named_place const* overlapping(place const& where) const noexcept;
    /// By its name, in upper or lower case; null where there is none.
    [[nodiscard]] named_group const* group_named(std::string_view name) const noexcept;
};

/// What words mean: of a drive, of a register file, of both or of neither.
struct vocabulary {
    vocabulary(drive_catalog const* of, named_places const* said = nullptr) noexcept : drive{of}, names{said} {}

    drive_catalog const* drive;
    named_places const* names;
};

/// Whether two places share a register or a bit.
[[nodiscard]] bool overlap(place const& one, place const& other) noexcept;

/// What is wrong with a word for a choice; empty where nothing is.
[[nodiscard]] std::string why_no_word(std::string_view word);

/// What is wrong with a name; empty where nothing is. No shell, topic or spreadsheet takes a right one for an order, and no
/// place looks like it.
[[nodiscard]] std::string why_no_name(std::string_view name);

} // namespace tool

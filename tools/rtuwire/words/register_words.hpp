// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a person types for registers: `RFR`, `'DP*'`, `@monitor` or `group:monitor`, `ETA.fault`, `3202`, `0x0C82`, `3201-3205`, `705.0` (a
// number of the drive's menu, where that is known), places of any device (`input:40:f32`), several of them in one word
// with commas between.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "words/named_places.hpp"
#include "words/place.hpp"
#include "words/words.hpp"

namespace tool {

/// A place that was asked for, and what a drive has there, or a register file says of it.
struct chosen_register {
    place where;
    register_entry const* entry;       ///< null where no table knows the address
    named_place const* named{nullptr}; ///< where it was asked for by its name, or its group's

    friend bool operator==(chosen_register const&, chosen_register const&) = default;
};

/// All that were asked for, in the order in which they were typed, each once; or the first word that is wrong.
struct register_selection {
    std::vector<chosen_register> registers;
    std::optional<refusal> refused;
};

/// Registers that one looks at together, from whatever menus: "@monitor".
struct register_group {
    std::string_view name; ///< without the @
    std::string_view what; ///< in words
    std::span<std::string_view const> codes;
};

/// The groups. A drive has those of their registers that it has.
[[nodiscard]] std::span<register_group const> register_groups() noexcept;

/// The groups of a drive's own parameters, each once, by name: "motor_control".
[[nodiscard]] std::vector<std::string_view> menu_groups_of(drive_catalog const& drive);

/// Both: what may stand behind @ for that drive.
[[nodiscard]] std::vector<std::string_view> all_groups_of(drive_catalog const& drive);

/// The registers that words name. Without a drive and names there are only numbers.
[[nodiscard]] register_selection select_registers(std::span<std::string_view const> words, vocabulary const& known);

/// Why one of the words that are places of any device is none: no drive's table would help.
[[nodiscard]] std::optional<refusal> wrong_place_in(std::span<std::string_view const> words);

/// The first word that is a number of some drive's menu: "611", "705.0". Elsewhere it is an address, or a bit.
[[nodiscard]] std::string_view first_menu_number(std::span<std::string_view const> words);

/// Why such a number is refused where nobody knows whose it is, and what to say instead.
[[nodiscard]] std::string ambiguity_of(std::string_view menu_number);

/// The registers whose mnemonic, name, or words of values or bits hold a word, or whose menu number begins with it: those
/// first whose own name does.
[[nodiscard]] std::vector<register_entry const*> search_registers(drive_catalog const& drive, std::string_view word);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Values that have names: enumerations (`SEP`), and words of bits (`switch_on+quick_stop`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"

namespace tool {

/// The word that a name or a number stands for, or why there is none.
struct named_reading {
    std::optional<std::uint16_t> word{};
    std::string kind{};     ///< of the refusal
    std::string sentence{}; ///< for people
    std::string nearest{};  ///< the right word that is most like it
};

/// Reads a value of an enumeration or a word of bits. A name comes before a number: TBR=19200 is 19200 bit/s.
[[nodiscard]] named_reading read_named(register_entry const& entry, std::string_view text);

/// Whether a word is one of the values that an enumeration lists; true for all else.
[[nodiscard]] bool has_meaning(register_entry const& entry, std::uint16_t word) noexcept;

/// The values of an enumeration for people: "SIM (1), SEP (2)".
[[nodiscard]] std::string list_of_values(register_entry const& entry);

} // namespace tool

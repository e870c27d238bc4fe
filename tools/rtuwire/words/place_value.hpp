// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the registers or the bit of a place are by its form, for programs and for people; and the registers of a value
// that is typed for it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/record.hpp"
#include "words/place.hpp"

namespace tool {

struct formed_value {
    cell value{}; ///< nothing where the registers are no such value
    std::string text{};
};

/// The value of words as they came, `where.form.registers()` of them; of a coil or a discrete input one, 0 or 1.
[[nodiscard]] formed_value value_of(place const& where, std::span<std::uint16_t const> words);

/// The words of a value that is typed: 230.1V, #2301, 0x08FD, on, off, a text. Or why it has none.
struct words_typed {
    std::vector<std::uint16_t> words{};
    std::string wrong{};
    std::optional<std::int64_t> count{}; ///< of one whole number, its high byte first
};
[[nodiscard]] words_typed words_for(place const& where, std::string_view text);

/// What a number with a point means in its unit, and back. With more digits than its type has, and by the whole numbers of a
/// scale: 0.3 in steps of 0.1 is 3, not what lies just below it.
[[nodiscard]] long double amount_of(value_form const& form, long double count);
[[nodiscard]] long double count_of(value_form const& form, long double amount);

/// All bits of a number of up to four registers, its highest byte first; of a bit or some bits of a register these.
[[nodiscard]] std::uint64_t bits_of(place const& where, std::span<std::uint16_t const> words);

/// The words as one number in hexadecimal, as they came: "0x42480000".
[[nodiscard]] std::string hex_words(std::span<std::uint16_t const> words);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A place of any device, and how its registers are a value: `input:40:f32:cdab`, `40-43:u32:0.1V`, `coil:3`, `40.4-7`,
// `list:40001`. Words of a drive (`RFR`, `3202`, `705.0`) are looked at before; see register_words.hpp.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "words/words.hpp"

namespace tool {

enum class register_space : std::uint8_t { holding, input, coil, discrete };

enum class value_type : std::uint8_t { none, u16, i16, u32, i32, u64, i64, f32, f64, bcd16, bcd32, text, bits, hex };

/// A decimal number of few digits: 0.25 is 25 and two places.
struct short_decimal {
    std::int32_t digits{0};
    std::uint8_t places{0}; ///< digits behind the point

    friend auto operator<=>(short_decimal const&, short_decimal const&) = default;
};

/// How registers are one value. As nobody said: an unsigned number of one register.
struct value_form {
    value_type type{value_type::none};
    std::uint16_t characters{0}; ///< of a text
    std::string order{};         ///< "cdab", as bytes come on the line, `a` the highest; empty where nobody said
    short_decimal factor{1, 0};  ///< of one count, in the unit
    short_decimal offset{0, 0};  ///< is added then
    std::string unit{};          ///< "V"
    std::string said{};          ///< all of it as it was typed, in small letters but for the scale: ":f32:cdab:0.1V"

    /// The registers of a value.
    [[nodiscard]] std::uint16_t registers() const noexcept;
    /// For each byte of a number as it comes, which of its bytes it is, `a` the highest.
    [[nodiscard]] std::string letters() const;

    friend auto operator<=>(value_form const&, value_form const&) = default;
};

/// Where a value stands in a unit, and its form.
struct place {
    std::uint16_t address;
    int bit{-1};      ///< 0..15, or -1 for whole registers
    int last_bit{-1}; ///< of several bits, one number together
    register_space space{register_space::holding};
    bool is_space_said{false};
    value_form form{};
    std::string name{}; ///< by a register file

    /// Coils and discrete inputs.
    [[nodiscard]] bool is_single_bit() const noexcept { return space >= register_space::coil; }
    /// Its registers; of a bit, or bits of a register, 1.
    [[nodiscard]] std::uint16_t size() const noexcept;
    /// The bits of its first register that are its own.
    [[nodiscard]] std::uint16_t mask() const noexcept;

    friend auto operator<=>(place const&, place const&) = default;
};

/// The group that a word names: "monitor" of `@monitor`, and of `group:monitor`, which no shell takes for its own. Empty where
/// it names none.
[[nodiscard]] std::string_view group_in(std::string_view word) noexcept;

/// Whether a word is a place and no word of a drive: it has a colon, or several bits of a number (40.4-7).
[[nodiscard]] bool is_place_word(std::string_view word) noexcept;

/// The places that a word means: several where it is a range. Or why it means none.
struct places_typed {
    std::vector<place> places{};
    std::optional<refusal> refused{};
};
[[nodiscard]] places_typed read_places(std::string_view word);

/// A place as it may be typed: its name, "input:40:f32:cdab", "40.4-7".
[[nodiscard]] std::string text_of(place const& where);

/// "holding", "input", "coil", "discrete".
[[nodiscard]] std::string_view name_of(register_space space) noexcept;

/// The place that a number of five digits means in the lists of manuals, 40001 the first holding register, where it is
/// one: "list:40001 is holding:0". Empty where it is none.
[[nodiscard]] std::string list_hint(std::uint16_t number);

} // namespace tool

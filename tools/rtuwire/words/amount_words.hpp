// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Amounts as people type them: "1.3s", "-50 Hz", "1.2kHz", "300mA". Read digit by digit and kept exact.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"

namespace tool {

/// A fraction with parts of more than 64 bits: a typed number times a unit over a step.
struct exact_amount {
    __extension__ typedef __int128 wide;

    wide numerator{0};
    wide denominator{1};

    /// The counts of a step at or below and at or above; the same where it is a whole number of them.
    [[nodiscard]] std::int64_t counts_below(step_size step) const noexcept;
    [[nodiscard]] std::int64_t counts_above(step_size step) const noexcept;
};

/// What is wrong with the text of an amount.
enum class amount_fault : std::uint8_t { none, not_a_number, decimal_comma, too_many_digits, wrong_unit };

/// An amount, or what is wrong.
struct typed_amount {
    exact_amount amount{};
    amount_fault fault{amount_fault::none};
    std::string_view unit{}; ///< as it was typed
};

/// What is said of a comma in a number.
inline constexpr char const decimal_comma_text[] = "a number is written with a point: 1.3, not 1,3";

/// Reads an amount of what `unit` measures ("Hz"). A number without a unit is taken in that unit.
[[nodiscard]] typed_amount read_amount(std::string_view text, std::string_view unit);

/// The units in which an amount may be typed: "Hz, kHz, mHz".
[[nodiscard]] std::string units_for(std::string_view unit);

} // namespace tool

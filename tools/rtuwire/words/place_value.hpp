// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the registers or the bit of a place are by its form, for programs and for people.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "output/record.hpp"
#include "words/place.hpp"

namespace tool {

struct formed_value {
    cell value{}; ///< nothing where the registers are no such value
    std::string text{};
};

/// The value of words as they came, `where.form.registers()` of them; of a coil or a discrete input one, 0 or 1.
[[nodiscard]] formed_value value_of(place const& where, std::span<std::uint16_t const> words);

/// The words as one number in hexadecimal, as they came: "0x42480000".
[[nodiscard]] std::string hex_words(std::span<std::uint16_t const> words);

} // namespace tool

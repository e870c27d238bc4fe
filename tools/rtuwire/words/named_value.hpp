// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value by what a register file says of it: its choices, its limits, what means no value.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "words/named_places.hpp"
#include "words/place_value.hpp"

namespace tool {

/// The value of words as they came: the name of a choice, nothing where they mean no value.
[[nodiscard]] formed_value value_of(named_place const& named, std::span<std::uint16_t const> words);

/// The words of a value that is typed, or of the name of a choice. Or why it is none that may be written.
[[nodiscard]] words_typed words_for(named_place const& named, std::string_view text);

/// Whether words mean no value.
[[nodiscard]] bool is_no_value(named_place const& named, std::span<std::uint16_t const> words);

/// Why words are never written there; empty where they are.
[[nodiscard]] std::string why_not_written(named_place const& named, std::span<std::uint16_t const> words);

/// The words of a value, whether or not it may be written; of some bits of a register these at their place.
[[nodiscard]] words_typed words_to_hold(named_place const& named, std::string_view text);

/// "off 0, heat 1".
[[nodiscard]] std::string list_of_choices(named_place const& named);

} // namespace tool

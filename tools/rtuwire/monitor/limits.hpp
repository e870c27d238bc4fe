// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Limits that somebody sets to a value: outside of them it is an alarm of `monitor`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tool {

struct value_limit {
    std::string word{}; ///< of the register
    std::optional<double> lowest{};
    std::optional<double> highest{};
    std::string unit{}; ///< as it was typed; empty: that of the value
};

/// "LCR=2..8.5A", "RFR@fan=..45", "power=10W..". Refuses what is none, with the reason.
value_limit limit_in(std::string const& word);

/// "above 8.5 A", "below 2"; what a limit cannot say anything of: "its limit is in A, and it is in Hz". Empty where a value is
/// within. `value` is not a number where it could not be read, or is none.
std::string outside_text(value_limit const& limit, double value, std::string_view unit);

} // namespace tool

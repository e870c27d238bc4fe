// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whole numbers of small steps as people write them: 487 tenths are 48.7, and -5 tenths are -0.5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace examples {

/// `count` steps of which ten to the power of `digits` make one.
inline std::string figures(std::int64_t count, std::size_t digits)
{
    std::string text = std::to_string(count < 0 ? -count : count);
    if (text.size() <= digits) {
        text.insert(0, digits + 1 - text.size(), '0');
    }
    if (digits > 0) {
        text.insert(text.size() - digits, 1, '.');
    }
    return count < 0 ? "-" + text : text;
}

/// A quantity in its unit.
template <typename Quantity> std::string figures(Quantity value)
{
    using scale = typename Quantity::scale;
    std::size_t digits = 0;
    std::intmax_t steps = 1;
    for (; steps % scale::den != 0 and digits < 9; steps *= 10) {
        ++digits;
    }
    return figures(std::int64_t{value.count()} * scale::num * (steps / scale::den), digits);
}

} // namespace examples

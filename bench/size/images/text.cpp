// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One amount of a register as text, with its digits and its unit.
#include "board.hpp"

#include <rtuwire/core/text.hpp>
#include <rtuwire/core/units.hpp>

int main()
{
    for (;;) {
        auto const upper = std::to_integer<std::uint32_t>(board::byte());
        auto const word = static_cast<std::uint16_t>(upper << 8U | std::to_integer<std::uint32_t>(board::byte()));
        for (char const each : rtuwire::text_of(rtuwire::signed_decihertz{static_cast<std::int16_t>(word)})) {
            board::put(static_cast<std::byte>(each));
        }
    }
}

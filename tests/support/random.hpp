// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Repeatable pseudo-random numbers and octets, also when compiling.
#pragma once

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/sim/dice.hpp>

namespace rtuwire::test {

/// The simulation's dice; the seed names the run.
class random : public sim::dice {
public:
    using dice::dice;

    constexpr void fill(byte_span out) noexcept
    {
        for (std::byte& octet : out) {
            octet = to_byte(next());
        }
    }
};

} // namespace rtuwire::test

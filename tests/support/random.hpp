// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Repeatable pseudo-random numbers and bytes, also when compiling.
#pragma once

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/sim/line/line_faults.hpp>

namespace rtuwire::test {

using namespace detail;

/// The simulation's random numbers; the seed names the run.
class random : public detail::random_source {
public:
    using random_source::random_source;

    constexpr void fill(byte_span out) noexcept
    {
        for (std::byte& byte : out) {
            byte = to_byte(next());
        }
    }
};

} // namespace rtuwire::test

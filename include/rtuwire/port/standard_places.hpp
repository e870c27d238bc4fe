// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps a serial line off the descriptor numbers 0, 1 and 2. A program may be started with these closed; the
// line would get one of them, and what the program prints would go to the drives.
#pragma once

#include <array>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/descriptor.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// While it lives, every file opened gets a number above those of standard input, output and error output,
/// even where these are closed: /dev/null fills them meanwhile. On a system without /dev/null, check with
/// `is_above`.
class standard_places {
public:
    standard_places() noexcept
    {
        for (descriptor& each : held_) {
            descriptor lowest{::open("/dev/null", O_RDWR | O_CLOEXEC)};
            if (is_above(lowest.number())) {
                return;
            }
            each = std::move(lowest);
        }
    }

    /// Whether a number is above the standard ones; false where nothing is open.
    [[nodiscard]] static constexpr bool is_above(int number) noexcept { return number > STDERR_FILENO; }

private:
    std::array<descriptor, 3> held_{};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client or a bus whose clock goes on as the test says, from shortly before the counter goes round.
#pragma once

#include <cstdint>

#include "defect/client_line.hpp"

namespace rtuwire::test {

template <typename Link> struct hand_clock {
    Link link;
    std::uint64_t time{0xFFFF'FFFFU - 5'000'000U};

    explicit hand_clock(client_options const& options, line_timing const& timing = office_line) : link{timing, options}
    {
        pass(0);
        pass(1'000'000);
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    void pass(std::uint64_t length)
    {
        time += length;
        link.advance(now());
    }
    /// To a time that was reckoned.
    void pass_until(std::uint64_t end) { pass(end - time); }
};

} // namespace rtuwire::test

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The states of a framer, what reaches it, and where each leads: the table that the test holds it to and that the site
// draws.
#pragma once

#include <array>
#include <cstddef>

namespace rtuwire::test::framer_table {

enum class state { synchronising, idle, receiving, open_end, done };
enum class input { byte, last_byte, open_last_byte, damaged_byte, t3_5, frame_end, poll_frame, restart, resynchronise };
inline constexpr std::size_t states = 5;
inline constexpr std::size_t inputs = 9;
inline constexpr std::array<char const*, states> state_names{"synchronising", "idle", "receiving", "open end", "done"};
inline constexpr std::array<char const*, inputs> input_names{"byte",         "last byte", "last byte, length open",
                                                             "damaged byte", "t3.5",      "frame_end",
                                                             "poll_frame",   "restart",   "resynchronise"};

/// The next state, by state and input, in the order of the enumerations.
inline constexpr auto next = [] {
    using enum state;
    return std::array<std::array<state, inputs>, states>{{
        {synchronising, synchronising, synchronising, synchronising, synchronising, idle, synchronising, idle,
         synchronising},
        {receiving, receiving, receiving, receiving, idle, idle, idle, idle, synchronising},
        {receiving, done, open_end, receiving, receiving, done, receiving, idle, synchronising},
        {done, done, done, receiving, done, done, open_end, idle, synchronising},
        {receiving, receiving, receiving, receiving, done, done, idle, idle, synchronising},
    }};
}();

} // namespace rtuwire::test::framer_table

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of one unit whose motor it commands. The client keeps it (client/order_places.hpp), and a
// conversation that ordered the motor to run asks it whether that still counts. Events are ordered by stamps, which
// count up.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// How the stop under way holds a unit.
enum class hold : std::uint8_t {
    by_its_stop,
    by_another_stop, ///< a stop whose unit had no place when this unit got one
    by_nobody,       ///< that stop was given up: it visits no more
    is_over,         ///< that stop has ended
};

/// Whether requests that stop a unit may still be sent while it is lost.
enum class stop_words : std::uint8_t {
    none,
    timed, ///< up to `words_end`
    due,   ///< a stop has begun, and has sent none yet: its time begins with the first one
};

/// What is known of one unit. All zero where nothing is known, so that a `constinit` client lives in .bss; the times
/// are written before they are read.
struct unit_order {
    // Small processors reach bytes with short instructions only where they are near.
    std::uint8_t unit{0}; ///< 0: a free place
    bool is_ordered{false};
    bool is_starting{false}; ///< the command to run was sent; neither seen with power nor told to stop since
    bool is_doubtful{false}; ///< it may have been without power since `confirmed` was read
    bool is_lost{false};
    bool was_lost{false};   ///< the last stop was a loss
    std::uint8_t misses{0}; ///< missing responses in a row
    std::uint8_t tolerated{0};
    std::uint8_t answers_left{
        0}; ///< not 0: its motor may run, and no order or stop is in force; lost after so many answers
    std::uint8_t passes_left{0}; ///< that the stop under way may miss before it counts as given up
    stop_words words{stop_words::none};
    hold held{hold::by_its_stop};
    std::uint16_t confirmed{0}; ///< the control word that was read to be that of the drive profile; 0: none
    std::uint16_t seen{0};      ///< when the stop under way visited last, in steps of 65.5 ms
    instant words_end{0};
    instant silence_end{0};
    instant heard{0};   ///< when the last request was made that it answered
    instant on_line{0}; ///< when a request to it may have been on the line
    duration silence{};
    std::uint32_t last_stop{0};  ///< the stamp of the last stop or loss
    std::uint32_t last_order{0}; ///< of the last order to run; 0: none
    std::uint32_t last_fault{0}; ///< of the last time that it was read in fault, or of the last stop of all units
    std::uint32_t rearranged{0}; ///< of the last request that rearranged it
    std::uint32_t holder{0};     ///< of the stop under way; 0: none
    std::uint32_t looks{0};      ///< all answers since it was left or told to stop, one to a commander being several
};
inline constexpr unit_order nothing_known{};

/// Whether an event came before another one.
[[nodiscard]] constexpr bool is_older(std::uint32_t stamp, std::uint32_t than) noexcept
{
    return static_cast<std::int32_t>(stamp - than) < 0;
}

[[nodiscard]] constexpr std::uint32_t newer_of(std::uint32_t one, std::uint32_t other) noexcept
{
    return is_older(one, other) ? other : one;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

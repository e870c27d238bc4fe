// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of one unit whose motor it commands. The client keeps it (client/order_places.hpp), and a
// conversation that ordered the motor to run asks it whether that still counts. Events are ordered by stamps, which
// count up.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How the stop under way holds a unit.
enum class hold : std::uint8_t {
    by_its_stop,
    by_another_stop, ///< a stop whose unit had no place when this unit got one
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
    instant words_end;
    instant silence_end;
    instant heard; ///< when the last request was made that it answered
    duration silence;
    std::uint32_t last_stop;  ///< the stamp of the last stop or loss
    std::uint32_t last_order; ///< of the last order to run; 0: none
    std::uint32_t last_fault; ///< of the last time that it was read in fault, or of the last stop of all units
    std::uint32_t rearranged; ///< of the last request that rearranged it
    std::uint32_t holder;     ///< of the stop under way; 0: none
    std::uint16_t confirmed;  ///< the control word that was read to be that of the drive profile; 0: none
    bool is_doubtful;         ///< it may have been without power since that was read
    std::uint8_t unit;        ///< 0: a free place
    std::uint8_t misses;      ///< missing responses in a row
    std::uint8_t tolerated;
    bool is_ordered;
    bool is_starting; ///< the command to run was sent; neither seen with power nor told to stop since
    bool is_lost;
    bool was_lost; ///< the last stop was a loss
    stop_words words;
    hold held;
};
inline constexpr unit_order nothing_known{
    instant{0}, instant{0}, instant{0},       duration{},       0, 0, 0, 0, 0, 0, false, 0, 0, 0, false, false,
    false,      false,      stop_words::none, hold::by_its_stop};

/// Whether an event came before another one.
[[nodiscard]] constexpr bool is_older(std::uint32_t stamp, std::uint32_t than) noexcept
{
    return static_cast<std::int32_t>(stamp - than) < 0;
}

[[nodiscard]] constexpr std::uint32_t newer_of(std::uint32_t one, std::uint32_t other) noexcept
{
    return is_older(one, other) ? other : one;
}

} // namespace rtuwire

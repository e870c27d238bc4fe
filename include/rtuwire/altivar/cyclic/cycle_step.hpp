// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The requests of a cycle, and when it reads back what it wrote.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The requests of a cycle.
enum class cycle_step : std::uint8_t {
    look,
    look_for_fault,
    prepare, ///< reads the drive's safeguards and its scanner's addresses
    exchange,
    read,              ///< the first half of an exchange by functions 03 and 16
    write,             ///< and the second
    say_stop,          ///< the stop command, by function 06
    observe,           ///< reads as an exchange does, and writes nothing
    check_control,     ///< the control word, before the command to run
    compare_meaning,   ///< CHCF, from time to time while it runs: in the I/O profile it runs by the same word
    compare_control,   ///< the control word, in the same way
    compare_reference, ///< and the reference
};

/// The control word is read back before each command to run; CHCF, it and the reference in turn every tenth exchange.
class cycle_comparison {
public:
    /// The drive accepted an exchange.
    constexpr void note_exchange() noexcept
    {
        exchanges_ = static_cast<std::uint8_t>(exchanges_ + (exchanges_ < exchanges_between ? 1 : 0));
    }
    /// One of the two was read back.
    constexpr void note_comparison(cycle_step which) noexcept
    {
        is_checked_ = which == cycle_step::check_control;
        next_ = which == cycle_step::compare_meaning   ? cycle_step::compare_control
                : which == cycle_step::compare_control ? cycle_step::compare_reference
                                                       : cycle_step::compare_meaning;
        exchanges_ = 0;
    }

    /// The motor stands that was turning: CHCF is read next.
    constexpr void note_standstill() noexcept
    {
        next_ = cycle_step::compare_meaning;
        exchanges_ = exchanges_between;
    }

    /// Whether the command to run may be sent: the control word was read back, and nothing happened since.
    [[nodiscard]] constexpr bool is_checked() const noexcept { return is_checked_; }
    constexpr void keep_if(bool is_still_so) noexcept { is_checked_ = is_checked_ and is_still_so; }

    /// Whether a comparison is due while the motor runs, and of which word.
    [[nodiscard]] constexpr bool is_due() const noexcept { return exchanges_ >= exchanges_between; }
    [[nodiscard]] constexpr cycle_step next() const noexcept { return next_; }

private:
    static constexpr std::uint8_t exchanges_between = 10;

    std::uint8_t exchanges_{0};
    bool is_checked_{false};
    cycle_step next_{cycle_step::compare_meaning};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

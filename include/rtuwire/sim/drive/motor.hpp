// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A motor on a ramp: its frequency in millihertz, its current and its thermal state. Plausible, not exact; integers
// only, and any step of time is one calculation.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The settings of the ramp and the load.
struct motor_settings {
    std::int32_t rated_frequency{50'000}; ///< mHz; ramps are times from 0 to it
    std::int64_t acceleration{3'000'000}; ///< us
    std::int64_t deceleration{3'000'000}; ///< us
    std::int32_t rated_current{20};       ///< 0.1 A
    std::int32_t protection{20};          ///< 0.1 A, the thermal protection's setting
};

/// A motor that follows a target.
class simulated_motor {
public:
    /// The output frequency, negative in reverse, in mHz.
    [[nodiscard]] constexpr std::int32_t frequency() const noexcept { return static_cast<std::int32_t>(position_); }

    /// In 0.1 A; nothing without power.
    [[nodiscard]] constexpr std::int32_t current() const noexcept { return current_; }

    /// The current in percent of the rated one.
    [[nodiscard]] constexpr std::int64_t load(motor_settings const& set) const noexcept
    {
        return set.rated_current == 0 ? 0 : std::int64_t{current_} * 100 / set.rated_current;
    }

    /// In percent of the rated state.
    [[nodiscard]] constexpr std::int32_t thermal_state() const noexcept
    {
        return static_cast<std::int32_t>(heat_ / heat_scale);
    }

    [[nodiscard]] constexpr bool is_at_rest() const noexcept { return position_ == 0; }
    [[nodiscard]] constexpr bool is_accelerating() const noexcept { return trend_ > 0; }
    [[nodiscard]] constexpr bool is_decelerating() const noexcept { return trend_ < 0; }

    /// Follows `target` (mHz) for a time, with power.
    constexpr void drive(std::int32_t target, duration time, motor_settings const& set) noexcept
    {
        std::int64_t left = time.microseconds;
        // Through zero the ramp changes from deceleration to acceleration: at most two pieces.
        for (unsigned piece = 0; piece < 2 and left > 0 and position_ != target; ++piece) {
            left = approach(target, left, set);
        }
        if (position_ == target) {
            trend_ = 0;
            remainder_ = 0;
        }
        draw_current(set);
        warm(time, set);
    }

    /// Without power: the output is off at once.
    constexpr void coast(duration time, motor_settings const& set) noexcept
    {
        position_ = 0;
        remainder_ = 0;
        trend_ = 0;
        current_ = 0;
        warm(time, set);
    }

    /// With power and a braking current: the output frequency is 0.
    constexpr void inject(duration time, motor_settings const& set) noexcept
    {
        position_ = 0;
        remainder_ = 0;
        trend_ = 0;
        current_ = set.rated_current;
        warm(time, set);
    }

private:
    static constexpr std::int64_t heat_scale = 1'000'000;

    static constexpr std::int64_t size_of(std::int64_t value) noexcept { return value < 0 ? -value : value; }

    /// Follows one ramp; returns the time left over.
    constexpr std::int64_t approach(std::int64_t target, std::int64_t time, motor_settings const& set) noexcept
    {
        bool const changes_side = (position_ > 0 and target < 0) or (position_ < 0 and target > 0);
        std::int64_t const goal = changes_side ? 0 : target;
        bool const slows = size_of(goal) < size_of(position_);
        std::int64_t const ramp = slows ? set.deceleration : set.acceleration;
        trend_ = slows ? -1 : 1;
        std::int64_t const distance = size_of(goal - position_);
        // The steps of a slow ramp are shorter than a millihertz: what is left of one is kept.
        std::int64_t const work = time * set.rated_frequency + remainder_;
        std::int64_t const reach = ramp == 0 ? distance : work / ramp;
        if (reach >= distance) {
            position_ = goal;
            remainder_ = 0;
            std::int64_t const used = ramp == 0 ? 0 : distance * ramp / set.rated_frequency;
            return time > used ? time - used : 0;
        }
        remainder_ = work % ramp;
        position_ += goal > position_ ? reach : -reach;
        return 0;
    }

    constexpr void draw_current(motor_settings const& set) noexcept
    {
        std::int64_t const speed = size_of(position_) * 100 / set.rated_frequency;
        std::int64_t const share = position_ == 0 ? 0 : 35 + speed / 2 + (trend_ > 0 ? 40 : 0);
        current_ = static_cast<std::int32_t>(set.rated_current * share / 100);
    }

    /// A first-order thermal model with a time constant of ten minutes.
    constexpr void warm(duration time, motor_settings const& set) noexcept
    {
        constexpr std::int64_t body = 600'000'000;
        constexpr std::int64_t most = 1'000; // far beyond what trips it; the square of more, times an hour, has no room
        std::int64_t const share = set.protection == 0 ? 0 : std::int64_t{current_} * 100 / set.protection;
        std::int64_t const target = (share < most ? share * share : most * most) / 100 * heat_scale;
        heat_ += (target - heat_) / 100 * time.microseconds / (body / 100 + time.microseconds / 100);
    }

    std::int64_t position_{0};
    std::int64_t remainder_{0};
    std::int64_t heat_{0};
    std::int32_t current_{0};
    std::int8_t trend_{0};
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

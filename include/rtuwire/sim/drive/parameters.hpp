// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the words of a drive's settings mean to its model: ramps, speed limits, the motor's nameplate, the supervision
// of the link.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The reactions to a lost link, by the values of SLL. With 1, and from 6 on, the drive trips; with 4 it continues at
/// a speed that no available table has, 0 as delivered.
enum class loss_reaction : std::uint16_t {
    ignore = 0,
    freewheel = 1,
    stop_without_fault = 2, ///< as STT says
    fall_back_to_a_speed = 4,
    keep_the_speed = 5,
    ramp = 6,
    fast = 7,
    injection = 8,
};

/// Whether a lost link is a fault.
[[nodiscard]] constexpr bool is_fault(loss_reaction how) noexcept
{
    return how == loss_reaction::freewheel or how >= loss_reaction::ramp;
}

/// A drive's line settings, as values of its registers.
struct line_setting {
    std::uint16_t rate{0};
    std::uint16_t format{0};

    friend constexpr bool operator==(line_setting const&, line_setting const&) noexcept = default;
};

/// A view of the settings in an image, which outlives it.
template <device_type Device> class parameters {
    static constexpr register_index<Device> at{};

public:
    explicit constexpr parameters(image<Device> const& its_registers) noexcept : registers_{its_registers} {}

    [[nodiscard]] constexpr motor_settings motor() const noexcept
    {
        std::int64_t const step = ramp_step();
        std::size_t const current = at.has(at.ncr) ? at.ncr : at.inv;
        std::int32_t const rated = get(at.frs) == 0 ? 500 : get(at.frs);
        return {rated * 100, step * get(at.acc), step * get(at.dec), get(current), get(at.ith)};
    }

    /// A frequency in mHz limited to LSP and HSP, in the direction of the reference: LSP applies to a reference of 0,
    /// too.
    [[nodiscard]] constexpr std::int32_t limited(std::int32_t frequency, bool is_backwards) const noexcept
    {
        std::int32_t const most = get(at.hsp) * 100;
        std::int32_t const least = get(at.lsp) * 100;
        std::int32_t const size = frequency < 0 ? -frequency : frequency;
        std::int32_t const cut = size > most ? most : size < least ? least : size;
        return is_backwards ? -cut : cut;
    }

    /// mHz for revolutions a minute: by the motor's nameplate, or by SDS where there is none.
    [[nodiscard]] constexpr std::int64_t to_millihertz(std::int64_t speed) const noexcept
    {
        if (not at.has(at.nsp)) {
            std::int32_t const per_hertz = get(at.sds);
            return per_hertz == 0 ? 0 : speed * 1'000 / per_hertz;
        }
        return speed * pole_pairs() * 50 / 3;
    }
    [[nodiscard]] constexpr std::int64_t to_rpm(std::int64_t millihertz) const noexcept
    {
        return at.has(at.nsp) ? millihertz / 50 * 3 / pole_pairs() : millihertz / 100 * get(at.sds) / 10;
    }

    /// The time without a request after which the link is lost; 0 where the drive does not supervise it.
    [[nodiscard]] constexpr duration time_out() const noexcept
    {
        if (not at.has(at.tto)) {
            bool const is_ignored = (get(at.cmi) & at.guards.nto) != 0;
            return is_ignored ? duration{} : at.guards.fixed_timeout;
        }
        bool const is_ignored = reaction_to_loss() == loss_reaction::ignore;
        return is_ignored ? duration{} : milliseconds(100) * registers_.get(at.tto);
    }

    /// The reaction to a lost link (SLL); freewheel where it cannot be set.
    [[nodiscard]] constexpr loss_reaction reaction_to_loss() const noexcept
    {
        return at.has(at.sll) ? static_cast<loss_reaction>(get(at.sll)) : loss_reaction::freewheel;
    }

    /// Whether it resets the fault of a lost link once the link is back, and continues as commanded (ATR).
    [[nodiscard]] constexpr bool restarts_by_itself() const noexcept
    {
        constexpr std::int32_t always = 1;
        return at.has(at.atr) and get(at.atr) == always;
    }

    /// Whether "disable operation" removes the torque (DOTD) instead of following the ramp.
    [[nodiscard]] constexpr bool freewheels_when_disabled() const noexcept
    {
        return at.has(at.dotd) and get(at.dotd) == 0;
    }

    /// How STT sets a motor to stop.
    [[nodiscard]] constexpr stopping as_set() const noexcept
    {
        constexpr altivar::simulated_behaviour const& numbers = altivar::behaviour_of<Device>;
        switch (registers_.get(at.stt)) {
        case numbers.fast_stop: return stopping::fast;
        case numbers.freewheel: return stopping::freewheel;
        case numbers.dc_injection: return stopping::injection;
        default: return stopping::ramp;
        }
    }

    /// The line settings in the registers. BDR is that of another line where a drive has TBR, too.
    [[nodiscard]] constexpr line_setting line() const noexcept
    {
        return {registers_.get(at.has(at.tbr) ? at.tbr : at.bdr), registers_.get(at.tfo)};
    }

private:
    [[nodiscard]] constexpr std::int32_t get(std::size_t place) const noexcept { return registers_.get(place); }

    /// What one count of ACC and DEC is, in us: INR 0, 1 and 2 where a drive has it, else 0.1 s.
    constexpr std::int64_t ramp_step() const noexcept
    {
        if (not at.has(at.inr)) {
            return 100'000;
        }
        return get(at.inr) == 0 ? 10'000 : get(at.inr) == 2 ? 1'000'000 : 100'000;
    }

    constexpr std::int32_t pole_pairs() const noexcept
    {
        std::int32_t const speed = get(at.nsp);
        std::int32_t const pairs = speed == 0 ? 1 : (get(at.frs) * 6 + speed / 2) / speed;
        return pairs == 0 ? 1 : pairs;
    }

    image<Device> const& registers_;
};

} // namespace rtuwire::sim

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the words of a drive's settings mean to its model: ramps, speed limits, the motor's nameplate, the
// supervision of the link.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/image.hpp>
#include <rtuwire/sim/motor.hpp>
#include <rtuwire/sim/places.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// A look at the settings in an image, which outlives it.
template <device_type Device> class parameters {
    static constexpr places<Device> at{};

public:
    explicit constexpr parameters(image<Device> const& registers) noexcept : registers_{registers}
    {}

    [[nodiscard]] constexpr motor_settings motor() const noexcept
    {
        std::int64_t const step = ramp_step();
        std::size_t const current = at.has(at.ncr) ? at.ncr : at.inv;
        std::int32_t const rated = get(at.frs) == 0 ? 500 : get(at.frs);
        return {rated * 100, step * get(at.acc), step * get(at.dec), get(current), get(at.ith)};
    }

    /// A frequency in mHz between LSP and HSP, either way round.
    [[nodiscard]] constexpr std::int32_t limited(std::int32_t frequency) const noexcept
    {
        std::int32_t const most = get(at.hsp) * 100;
        std::int32_t const least = get(at.lsp) * 100;
        std::int32_t const size = frequency < 0 ? -frequency : frequency;
        std::int32_t const cut = size > most ? most : size < least ? least : size;
        return frequency < 0 ? -cut : cut;
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
        return at.has(at.nsp) ? millihertz / 50 * 3 / pole_pairs()
                              : millihertz / 100 * get(at.sds) / 10;
    }

    /// After how much silence the drive trips; 0 where it does not.
    [[nodiscard]] constexpr duration time_out() const noexcept
    {
        if (not at.has(at.tto)) {
            bool const is_ignored = (get(at.cmi) & unsupervised) != 0;
            return is_ignored ? duration{} : Device::silence.factory;
        }
        return trips_on_loss() ? milliseconds(100) * registers_.get(at.tto) : duration{};
    }

    /// SLL 2 and above: a lost link is answered by a ramp, not by freewheel.
    [[nodiscard]] constexpr bool ramps_on_loss() const noexcept { return get(at.sll) >= 2; }

    /// CMI bit by which an ATV28 does not supervise its link (NTO).
    static constexpr std::uint16_t unsupervised = 0x4000;

private:
    [[nodiscard]] constexpr std::int32_t get(std::size_t place) const noexcept
    {
        return registers_.get(place);
    }

    /// What one count of ACC and DEC is, in us: INR 0, 1 and 2 on an ATV320, 0.1 s elsewhere.
    constexpr std::int64_t ramp_step() const noexcept
    {
        if (not at.has(at.inr)) {
            return 100'000;
        }
        return get(at.inr) == 0 ? 10'000 : get(at.inr) == 2 ? 1'000'000 : 100'000;
    }

    /// SLL: 0 ignores a loss, 4 and 5 go on at another speed.
    constexpr bool trips_on_loss() const noexcept
    {
        std::int32_t const reaction = get(at.sll);
        return reaction != 0 and reaction != 4 and reaction != 5;
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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a drive demands of its motor: a frequency in a direction, or a kind of stop; from its commands, its channels,
// its limits and a link that may be lost.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/channels.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/parameters.hpp>
#include <rtuwire/sim/drive/registers/fault_record.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// A view of a drive's registers and commands, which outlive it.
template <device_type Device> class demand {
    static constexpr register_index<Device> at{};

public:
    /// `analog` is the reference at the terminals, in mHz.
    constexpr demand(image<Device> const& its_registers, control const& commands, std::int32_t analog,
                     bool is_link_lost) noexcept
        : registers_{its_registers}, commands_{commands}, analog_{analog}, is_link_lost_{is_link_lost}
    {}

    /// The reference, in mHz, before the limits and without the direction of the command.
    [[nodiscard]] constexpr std::int32_t asked() const noexcept
    {
        bool const falls_back = is_link_lost_ and set().reaction_to_loss() == loss_reaction::fall_back_to_a_speed;
        std::int32_t const given = refers_to_link() ? registers_.get_signed(at.lfr) * 100 : analog_;
        return falls_back ? 0 : given;
    }

    /// The direction that is asked for: that of the reference and of the command. A reference has one even where it is no
    /// step of LFR, or another speed is taken for it.
    [[nodiscard]] constexpr bool is_backwards() const noexcept
    {
        bool const is_negative = registers_.get_signed(at.lfr) < 0 or registers_.get_signed(at.lfrd) < 0;
        return (refers_to_link() ? is_negative : analog_ < 0) != commands_.is_reversed();
    }

    /// How the motor is being stopped; `none` while it may turn.
    [[nodiscard]] constexpr stopping how_it_stops() const noexcept
    {
        if (commands_.state_machine().state() == cia402::state::fault_reaction_active) {
            return how_a_fault_stops();
        }
        if (commands_.state_machine().is_leaving() and commands_.is_by_link() and set().freewheels_when_disabled()) {
            return stopping::freewheel;
        }
        stopping const how = commands_.how_it_stops();
        return how == stopping::as_set ? set().as_set() : how;
    }

    /// The target of the ramp, in mHz.
    [[nodiscard]] constexpr std::int32_t target() const noexcept
    {
        return how_it_stops() == stopping::none ? set().limited(asked(), is_backwards()) : 0;
    }

    /// Whether the reference lies outside LSP and HSP.
    [[nodiscard]] constexpr bool is_limited() const noexcept { return set().limited(asked(), asked() < 0) != asked(); }

private:
    constexpr parameters<Device> set() const noexcept { return parameters<Device>{registers_}; }

    constexpr bool refers_to_link() const noexcept
    {
        return commands_.is_by_link() and channels<Device>{registers_}.refers_to_link();
    }

    /// A fault removes the torque, unless it is a lost link with another reaction in SLL.
    constexpr stopping how_a_fault_stops() const noexcept
    {
        if (commands_.fault() != link_fault) {
            return stopping::freewheel;
        }
        switch (set().reaction_to_loss()) {
        case loss_reaction::ramp: return stopping::ramp;
        case loss_reaction::fast: return stopping::fast;
        case loss_reaction::injection: return stopping::injection;
        case loss_reaction::ignore:
        case loss_reaction::freewheel:
        case loss_reaction::stop_without_fault:
        case loss_reaction::fall_back_to_a_speed:
        case loss_reaction::keep_the_speed: break;
        }
        return stopping::freewheel;
    }

    image<Device> const& registers_;
    control const& commands_;
    std::int32_t analog_;
    bool is_link_lost_;
};

/// Moves a motor for the time `passed`, as demanded.
template <device_type Device>
constexpr void drive_motor(motor& shaft, demand<Device> const& asked, bool has_power, duration passed,
                           motor_settings settings) noexcept
{
    constexpr std::int64_t fast = 4; ///< of the ramp, as dCF is delivered
    stopping const how = asked.how_it_stops();
    if (not has_power or how == stopping::freewheel) {
        shaft.coast(passed, settings);
    } else if (how == stopping::injection) {
        shaft.inject(passed, settings);
    } else {
        settings.deceleration /= how == stopping::fast ? fast : 1;
        shaft.drive(asked.target(), passed, settings);
    }
}

} // namespace rtuwire::sim

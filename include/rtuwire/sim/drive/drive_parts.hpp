// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a simulated drive consists of, and how its parts follow one another: settings choose the channel, channel and
// commands make the demand, the demand turns the motor, and the monitoring registers report all of it.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/channels.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/demand.hpp>
#include <rtuwire/sim/drive/link_watchdog.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/parameters.hpp>
#include <rtuwire/sim/drive/registers/fault_record.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/memory.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>
#include <rtuwire/sim/drive/state_machine.hpp>
#include <rtuwire/sim/drive/status_registers.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The parts of a drive. Internal: `drive` is the one to use.
template <device_type Device> class drive_parts {
public:
    [[nodiscard]] constexpr sim::state_machine const& state_machine() const noexcept
    {
        return control_.state_machine();
    }
    [[nodiscard]] constexpr sim::motor const& motor() const noexcept { return motor_; }
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return control_.fault(); }

protected:
    using registers = image<Device>;
    static constexpr altivar::drive_layout const& layout = Device::layout;
    static constexpr altivar::simulated_behaviour const& behaviour = altivar::behaviour_of<Device>;
    static constexpr register_index<Device> at{};

    constexpr void power_up(instant now) noexcept
    {
        now_ = now;
        control_.power_up();
        motor_ = sim::motor{};
        link_watchdog_ = link_watchdog{};
        line_ = set().line();
        arrange();
        update_status();
    }

    /// Chooses the commanding channel by the present settings and inputs.
    constexpr void arrange() noexcept
    {
        control_.choose(channels<Device>{registers_}.choose(terminals_));
        if (not behaviour.sets_line_at_power_up) {
            line_ = set().line();
        }
    }

    /// Brings everything up to date after a change, without time passing.
    constexpr void settle() noexcept
    {
        arrange();
        turn(duration{});
        update_status();
    }

    constexpr parameters<Device> set() const noexcept { return parameters<Device>{registers_}; }

    constexpr sim::demand<Device> demand() const noexcept
    {
        return {registers_, control_, analog_, link_watchdog_.has_lost()};
    }

    constexpr void turn(duration passed) noexcept
    {
        drive_motor(motor_, demand(), cia402::has_power(state_machine().state()), passed, set().motor());
        if (motor_.is_at_rest()) {
            control_.at_rest();
        }
    }

    constexpr void update_status() noexcept
    {
        sim::demand<Device> const now = demand();
        bool const has_power = cia402::has_power(state_machine().state());
        bool const is_by_link = control_.is_by_link();
        appearance const seen{.state = state_machine().state(),
                              .target = now.target(),
                              .is_backwards = now.is_backwards(),
                              .is_limited = now.is_limited(),
                              .is_local = layout.shows_forced_local_only ? control_.is_forced_local() : not is_by_link,
                              .is_by_link = is_by_link,
                              .is_stopped_by_key = control_.is_stopped_by_key(),
                              .has_cause = control_.has_cause(),
                              .tripped_in_quick_stop = state_machine().tripped_in_quick_stop(),
                              .is_injecting = has_power and now.how_it_stops() == stopping::injection,
                              .is_memory_busy = memory_.is_busy()};
        update_status_registers(registers_, seen, motor_);
        show_active_fault(registers_, fault());
        show_inputs(registers_, terminals_);
    }

    registers registers_{};
    memory<Device> memory_{};
    control control_{layout};
    sim::motor motor_{};
    link_watchdog link_watchdog_{};
    logic_inputs terminals_{};
    line_setting line_{};
    instant now_{0};
    std::int32_t analog_{0};
};

} // namespace rtuwire::sim

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated Altivar: the registers of a whole device as a bank for a server, a state machine, a motor on a ramp, a
// supervised link, a scanner, faults, local control and an EEPROM. Time passes only in `advance`. Modelled on the
// manuals; what they do not print of a real drive is missing.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/drive_bank.hpp>
#include <rtuwire/sim/drive/link_watchdog.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/parameters.hpp>
#include <rtuwire/sim/drive/registers/fault_record.hpp>
#include <rtuwire/sim/drive/state_machine.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// One simulated drive; a register bank. Call `advance` in each pass before the bank is served, and
/// `note_contact` for each request to this unit.
template <device_type Device> class drive : public drive_bank<Device> {
    using base = drive_bank<Device>;
    using base::analog_;
    using base::at;
    using base::behaviour;
    using base::control_;
    using base::line_;
    using base::link_watchdog_;
    using base::memory_;
    using base::motor_;
    using base::now_;
    using base::power_up;
    using base::registers_;
    using base::set;
    using base::settle;
    using base::terminals_;
    using base::turn;
    using base::update_status;
    using typename base::registers;

public:
    using base::fault;
    using base::motor;
    using base::state_machine;

    /// Powered up at `now`, commissioned: Modbus commands it, and it has a unit address.
    explicit constexpr drive(instant power_on, std::uint16_t address = 1) noexcept
    {
        memory_.commission(registers_, address);
        power_up(power_on);
    }

    /// Lets time pass: the motor follows its ramp, the link may be lost.
    constexpr void advance(instant now) noexcept
    {
        duration const passed = now - now_;
        memory_.advance(within_reach(now_, now));
        now_ = now;
        control_.initialised();
        turn(passed);
        if (link_watchdog_.is_lost(now, set().time_out())) {
            lose_link();
        }
        restart_by_itself();
        settle();
    }

    /// Reports a request to this unit.
    constexpr void note_contact() noexcept { link_watchdog_.note_contact(now_); }

    // Operations at the drive itself.

    /// Gives the command to the keypad, or takes it back.
    constexpr void set_local(bool is_local) noexcept
    {
        control_.set_local(is_local);
        settle();
    }

    /// The STOP key, pressed and released, or held: the drive falls back, and reports it until it runs again.
    constexpr void press_stop() noexcept
    {
        hold_stop(true);
        hold_stop(false);
    }
    constexpr void hold_stop(bool is_held) noexcept
    {
        control_.hold_stop(is_held);
        settle();
    }

    /// Closes or opens a logic input; LI1 is number 1, and runs forward where the terminals command.
    constexpr void set_input(std::size_t number, bool is_closed) noexcept
    {
        terminals_.set(number, is_closed);
        settle();
    }

    /// Sets the reference at the analog input, in mHz.
    constexpr void set_analog_reference(std::int32_t frequency) noexcept
    {
        analog_ = frequency;
        settle();
    }

    /// A fault whose cause stays until `clear_cause`; `code` is its LFT.
    constexpr void inject_fault(std::uint16_t code) noexcept
    {
        control_.set_cause(true);
        trip(code);
    }
    constexpr void clear_cause() noexcept { control_.set_cause(false); }

    /// Power off and on: what was not saved is lost, and every order with it.
    constexpr void power_cycle(instant now) noexcept
    {
        registers_ = registers{};
        faults_ = fault_record<Device>{};
        memory_.recall(registers_);
        power_up(now);
    }

    // What can be seen at the drive itself.

    /// How often the EEPROM was written.
    [[nodiscard]] constexpr std::uint32_t eeprom_writes() const noexcept { return memory_.writes(); }

    /// Whether it receives nothing at all: some drives while their EEPROM is busy.
    [[nodiscard]] constexpr bool is_silent() const noexcept
    {
        return memory_.is_busy() and behaviour.is_silent_while_saving;
    }

    /// The unit address that it receives; with 0 it receives broadcasts only.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return registers_.get(at.add); }

    /// Rate and format of the line as they are in effect, as values of its registers.
    [[nodiscard]] constexpr line_setting line() const noexcept { return line_; }

private:
    constexpr void lose_link() noexcept
    {
        loss_reaction const how = set().reaction_to_loss();
        if (how == loss_reaction::stop_without_fault) {
            control_.abandon();
        } else if (is_fault(how)) {
            trip(link_fault);
            if (set().restarts_by_itself() and not behaviour.forgets_orders_on_loss) {
                return;
            }
            control_.forget_command();
        } else {
            return;
        }
        for (std::size_t const order : std::array{at.cmd, at.cmdd, at.lfr, at.lfrd}) {
            registers_.put(order, 0);
        }
    }

    /// Restarts as ATR sets it once the link is back. Of the faults that ATR restarts after, this is the only one.
    constexpr void restart_by_itself() noexcept
    {
        if (set().restarts_by_itself() and fault() == link_fault and link_watchdog_.is_back(now_)) {
            control_.restart();
        }
    }

    constexpr void trip(std::uint16_t code) noexcept
    {
        if (control_.trip(code)) {
            faults_.add(registers_, code);
            update_status();
        }
    }

    fault_record<Device> faults_{};
};

} // namespace rtuwire::sim

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated Altivar: the registers of a whole device as a bank for a server, a state chart, a motor on
// a ramp, a link that is supervised, a scanner, faults, local control and an EEPROM. Time is what
// `advance` says. Made from what the manuals tell; of a real drive's habits it knows no more.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/configure_scanner.hpp>
#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/bank.hpp>
#include <rtuwire/sim/chart.hpp>
#include <rtuwire/sim/control.hpp>
#include <rtuwire/sim/display.hpp>
#include <rtuwire/sim/fault_record.hpp>
#include <rtuwire/sim/image.hpp>
#include <rtuwire/sim/memory.hpp>
#include <rtuwire/sim/motor.hpp>
#include <rtuwire/sim/parameters.hpp>
#include <rtuwire/sim/places.hpp>
#include <rtuwire/sim/scanner.hpp>
#include <rtuwire/sim/supervision.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// One simulated drive; a register bank. Call `advance` in each pass before the bank is served, and
/// `note_contact` for each request to this unit.
template <device_type Device> class drive {
    using registers = image<Device>;
    static constexpr altivar::drive_profile const& profile = Device::profile;

public:
    /// Switched on at `now`, as delivered.
    explicit constexpr drive(instant now) noexcept { power_up(now); }

    /// Lets time pass: the motor follows its ramp, the link may be lost.
    constexpr void advance(instant now) noexcept
    {
        duration const passed = now - now_;
        now_ = now;
        control_.initialised();
        if (supervision_.is_lost(now, set().time_out())) {
            lose_link();
        }
        turn(passed);
        show();
    }

    /// Takes note of a request to this unit.
    constexpr void note_contact() noexcept { supervision_.note_contact(now_); }

    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        bool is_known = true;
        for (std::size_t i = 0; i < count; ++i) {
            is_known = is_known and registers::at_address(start + i) != registers::nowhere;
        }
        return is_known ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start,
                                             register_view values) const noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t const place = registers::at_address(start + i);
            if (place == registers::nowhere or registers::rule(place).mode == access::read_only) {
                return errc::illegal_data_address;
            }
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            errc const wrong = check_word(registers::at_address(start + i), values[i]);
            if (wrong != errc::none) {
                return wrong;
            }
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(word_at(registers::at_address(start + i)));
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            store(registers::at_address(start + i), values[i]);
        }
        turn(duration{});
        show();
        return errc::none;
    }

    // What happens at the drive itself.

    /// Somebody takes the command at the keypad, or gives it back.
    constexpr void set_local(bool is_local) noexcept
    {
        control_.set_local(is_local);
        show();
    }

    /// The STOP key: the drive falls back, and says so until it runs again.
    constexpr void press_stop() noexcept
    {
        control_.press_stop();
        show();
    }

    /// A fault whose cause stays until `clear_cause`; `code` is its LFT.
    constexpr void inject_fault(std::uint16_t code) noexcept
    {
        control_.set_cause(true);
        trip(code);
    }
    constexpr void clear_cause() noexcept { control_.set_cause(false); }

    /// Off and on again: what was not saved is lost.
    constexpr void power_cycle(instant now) noexcept
    {
        registers_ = registers{};
        memory_.recall(registers_);
        power_up(now);
    }

    // What can be seen at the drive itself.

    [[nodiscard]] constexpr sim::chart const& chart() const noexcept { return control_.chart(); }
    [[nodiscard]] constexpr sim::motor const& motor() const noexcept { return motor_; }
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return control_.fault(); }

    /// The word of a register by its mnemonic; 0 for one that this device does not have.
    [[nodiscard]] constexpr std::uint16_t word(text code) const noexcept
    {
        return word_at(registers::at(code));
    }

private:
    static constexpr places<Device> at{};
    static constexpr scanner<Device> inputs{altivar::scanner_input_words,
                                            altivar::scanner_input_addresses};
    static constexpr scanner<Device> outputs{altivar::scanner_output_words,
                                             altivar::scanner_output_addresses};

    constexpr void power_up(instant now) noexcept
    {
        now_ = now;
        control_.power_up();
        motor_ = sim::motor{};
        supervision_ = supervision{};
        registers_.put(at.cmd, 0);
        registers_.put(at.lfr, 0);
        registers_.put(at.lfrd, 0);
        registers_.put(at.cmi, registers_.get(at.cmi) & parameters<Device>::unsupervised);
        show();
    }

    // The line's side.

    constexpr errc check_word(std::size_t place, std::uint16_t word) const noexcept
    {
        bool const is_command = place == at.cmd or place == at.lfr or place == at.lfrd;
        if (is_command) {
            bool const is_refused = control_.is_local() and profile.refuses_commands_in_local;
            return is_refused ? errc::server_device_failure : errc::none;
        }
        if (registers::rule(place).mode == access::configuration and
            cia402::has_power(chart().state())) {
            return errc::server_device_failure;
        }
        return registers_.check(place, word);
    }

    constexpr std::uint16_t word_at(std::size_t place) const noexcept
    {
        bool const is_scanned = inputs.has(place);
        return registers_.get(is_scanned ? inputs.target_of(place, registers_) : place);
    }

    constexpr void store(std::size_t place, std::uint16_t word) noexcept
    {
        registers_.put_word(place, word);
        if (registers::rule(place).mode == access::configuration) {
            reconfigured();
        }
        if (outputs.has(place)) {
            forward(outputs.target_of(place, registers_), word);
        } else {
            act_on(place, word);
        }
    }

    /// A scanner output word: what its register would refuse is dropped.
    constexpr void forward(std::size_t target, std::uint16_t word) noexcept
    {
        if (target != registers::nowhere and registers::rule(target).mode != access::read_only and
            check_word(target, word) == errc::none) {
            registers_.put_word(target, word);
            act_on(target, word);
        }
    }

    constexpr void act_on(std::size_t place, std::uint16_t word) noexcept
    {
        if (place == at.cmd or place == at.cmdd) {
            obey(word);
        } else if (place == at.lfr) {
            registers_.put(at.lfrd, set().to_rpm(registers_.get_signed(at.lfr) * 100));
        } else if (place == at.lfrd) {
            registers_.put(at.lfr, set().to_millihertz(registers_.get_signed(at.lfrd)) / 100);
        } else if (place == at.cmi) {
            extended_command(word);
        }
    }

    constexpr void reconfigured() noexcept
    {
        if (profile.falls_back_when_configured and chart().state() == cia402::state::switched_on) {
            control_.fall_back();
        }
    }

    constexpr void obey(std::uint16_t word) noexcept
    {
        registers_.put(at.cmdd, word);
        if (control_.obey(word)) {
            supervision_.note_contact(now_);
        }
    }

    constexpr void extended_command(std::uint16_t word) noexcept
    {
        if (not cia402::has_power(chart().state())) {
            memory_.execute(registers_, word);
        }
    }

    // The link and its faults.

    constexpr void lose_link() noexcept
    {
        trip(link_fault);
        control_.forget_command();
        registers_.put(at.cmd, 0);
        registers_.put(at.lfr, 0);
        registers_.put(at.lfrd, 0);
    }

    constexpr void trip(std::uint16_t code) noexcept
    {
        if (control_.trip(code)) {
            record_fault(registers_, code);
            show();
        }
    }

    // The motor.

    constexpr parameters<Device> set() const noexcept { return parameters<Device>{registers_}; }

    /// What the reference asks for, in mHz, before the limits.
    constexpr std::int32_t asked() const noexcept
    {
        std::int32_t const value = registers_.get_signed(at.lfr) * 100;
        return control_.is_reversed() ? -value : value;
    }

    constexpr std::int32_t target() const noexcept
    {
        return control_.is_stopping() ? 0 : set().limited(asked());
    }

    constexpr void turn(duration passed) noexcept
    {
        constexpr std::int64_t fast = 4; ///< of the ramp, as dCF is delivered
        motor_settings settings = set().motor();
        if (not cia402::has_power(chart().state()) or is_freewheeling()) {
            motor_.coast(passed, settings);
        } else {
            settings.deceleration /= control_.is_stopping_fast() ? fast : 1;
            motor_.drive(target(), passed, settings);
        }
        if (motor_.is_at_rest()) {
            control_.at_rest();
        }
    }

    /// A fault takes the torque away, unless it is a lost link that SLL wants a ramp for.
    constexpr bool is_freewheeling() const noexcept
    {
        bool const ramps = fault() == link_fault and set().ramps_on_loss();
        return chart().state() == cia402::state::fault_reaction_active and not ramps;
    }

    constexpr void show() noexcept
    {
        appearance const seen{chart().state(),
                              asked(),
                              target(),
                              set().limited(asked()) != asked(),
                              control_.is_local(),
                              control_.is_stopped_by_key(),
                              control_.has_cause(),
                              chart().tripped_in_quick_stop()};
        display(registers_, seen, motor_);
    }

    registers registers_{};
    memory<Device> memory_{};
    control control_{profile};
    sim::motor motor_{};
    supervision supervision_{};
    instant now_{0};
};

} // namespace rtuwire::sim

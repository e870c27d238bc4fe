// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated Altivar: the registers of a whole device as a bank for a server, a state machine, a motor on a ramp, a
// supervised link, a scanner, faults, local control and an EEPROM. Time passes only in `advance`. Modelled on the
// manuals; what they do not print of a real drive is missing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/image.hpp>
#include <rtuwire/sim/drive/memory.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/parameters.hpp>
#include <rtuwire/sim/drive/register_rules.hpp>
#include <rtuwire/sim/drive/state_machine.hpp>
#include <rtuwire/sim/drive/status_registers.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// One simulated drive; a register bank. Call `advance` in each pass before the bank is served, and
/// `note_contact` for each request to this unit.
template <device_type Device> class simulated_drive {
    using registers = image<Device>;
    static constexpr altivar::drive_layout const& layout = Device::layout;
    static constexpr altivar::simulated_behaviour const& behaviour = altivar::behaviour_of<Device>;
    static constexpr register_index<Device> at{};

    using orders = menu_orders_of<registers>;
    static constexpr scanner_half<Device> inputs{Device::scanner.input_words, Device::scanner.input_addresses};
    static constexpr scanner_half<Device> outputs{Device::scanner.output_words, Device::scanner.output_addresses};

public:
    /// Powered up at `now`, commissioned: Modbus commands it, and it has a unit address.
    explicit constexpr simulated_drive(instant power_on, std::uint16_t address = 1) noexcept
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

    // The bank, as a server sees it.

    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        bool is_known = true;
        for (std::size_t i = 0; i < count; ++i) {
            is_known = is_known and registers::at_address(start + i) != registers::nowhere;
        }
        return is_known ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
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
        return fit(start, values) ? errc::none : errc::illegal_data_value;
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
        settle();
        return errc::none;
    }

    /// The word of a register by its mnemonic; 0 for one that this device does not have.
    [[nodiscard]] constexpr std::uint16_t word(literal code) const noexcept { return word_at(registers::at(code)); }

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

    [[nodiscard]] constexpr detail::state_machine const& state_machine() const noexcept
    {
        return control_.state_machine();
    }
    [[nodiscard]] constexpr simulated_motor const& motor() const noexcept { return motor_; }
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return control_.fault(); }

private:
    // What a word may be, and what a written word does; and the scanner, whose words stand for other registers.

    constexpr errc check_word(std::size_t place, std::uint16_t word) const noexcept
    {
        bool const is_command = place == at.cmd or place == at.cmdd or place == at.lfr or place == at.lfrd;
        if (is_command and place != registers::nowhere) {
            bool const is_refused = control_.is_forced_local() and layout.refuses_commands_in_local;
            return is_refused ? errc::server_device_failure : errc::none;
        }
        if (registers::rule(place).mode == access::configuration and cia402::has_power(state_machine().state())) {
            return errc::server_device_failure;
        }
        errc const wrong = registers_.check(place, word);
        if constexpr (is_whole<Device>) {
            return wrong == errc::none and orders::refuses(place, word) ? errc::server_device_failure : wrong;
        } else {
            return wrong;
        }
    }

    /// Whether words fit each other and what is held beside them.
    constexpr bool fit([[maybe_unused]] std::uint16_t start, [[maybe_unused]] register_view values) const noexcept
    {
        if constexpr (is_whole<Device>) {
            speed_limits<registers> after{registers_};
            for (std::size_t i = 0; i < values.size(); ++i) {
                after.put(registers::at_address(start + i), values[i]);
            }
            return after.hold();
        } else {
            return true;
        }
    }

    constexpr std::uint16_t word_at(std::size_t place) const noexcept
    {
        bool const is_scanned = inputs.has(place);
        return registers_.get(is_scanned ? inputs.target_of(place, registers_) : place);
    }

    constexpr void store(std::size_t place, std::uint16_t word) noexcept
    {
        registers_.put_word(place, word);
        if (registers::rule(place).mode == access::configuration and layout.falls_back_when_configured and
            state_machine().state() == cia402::state::switched_on) {
            control_.fall_back();
        }
        if (outputs.has(place)) {
            forward(outputs.target_of(place, registers_), word);
        } else {
            act_on(place, word);
        }
    }

    /// Stores a scanner output word in its target register; a word that the target would refuse is dropped.
    constexpr void forward(std::size_t target, std::uint16_t word) noexcept
    {
        register_block const alone{word};
        if (target != registers::nowhere and registers::rule(target).mode != access::read_only and
            check_word(target, word) == errc::none and fit(registers::rule(target).address, alone)) {
            registers_.put_word(target, word);
            act_on(target, word);
        }
    }

    constexpr void act_on(std::size_t place, std::uint16_t word) noexcept
    {
        if (place == at.cmd or place == at.cmdd) {
            apply(word);
        } else if (place == at.lfr) {
            registers_.put(at.lfrd, set().to_rpm(registers_.get_signed(at.lfr) * 100));
        } else if (place == at.lfrd) {
            registers_.put(at.lfr, set().to_millihertz(registers_.get_signed(at.lfrd)) / 100);
        } else if (place == at.cmi) {
            extended_command(word);
        } else {
            execute(place, word);
        }
    }

    /// Executes an order in a parameter.
    constexpr void execute([[maybe_unused]] std::size_t place, [[maybe_unused]] std::uint16_t word) noexcept
    {
        if constexpr (is_whole<Device>) {
            if (orders::reads_zero_again(place)) {
                registers_.put(place, 0);
            }
            if (orders::recalls_factory_settings(place, word)) {
                memory_.deliver(registers_, now_);
            }
        }
    }

    constexpr void apply(std::uint16_t word) noexcept
    {
        registers_.put(at.cmd, word);
        registers_.put(at.cmdd, word);
        if (control_.apply(word)) {
            link_watchdog_.note_contact(now_);
        }
    }

    constexpr void extended_command(std::uint16_t word) noexcept
    {
        if (not cia402::has_power(state_machine().state())) {
            memory_.execute(registers_, word, now_);
        }
    }

    // What follows a change or the time: settings choose the channel, channel and commands make the demand, the demand
    // turns the motor, and the monitoring registers report all of it.

    constexpr void power_up(instant now) noexcept
    {
        now_ = now;
        control_.power_up();
        motor_ = simulated_motor{};
        link_watchdog_ = link_watchdog{};
        line_ = set().line();
        arrange();
        update_status();
    }

    /// Chooses the commanding channel by the present settings and inputs.
    constexpr void arrange() noexcept
    {
        control_.choose(set().choose(terminals_));
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

    constexpr detail::demand<Device> demand() const noexcept
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
        detail::demand<Device> const now = demand();
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

    // Faults.

    constexpr void lose_link() noexcept
    {
        loss_reaction const how = set().reaction_to_loss();
        if (how == loss_reaction::stop_without_fault) {
            control_.abandon();
        } else if (is_fault(how)) {
            trip(sim::link_fault);
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
        if (set().restarts_by_itself() and fault() == sim::link_fault and link_watchdog_.is_back(now_)) {
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

    registers registers_{};
    memory<Device> memory_{};
    fault_record<Device> faults_{};
    control control_{layout}; ///< the state, and which channel commands
    simulated_motor motor_{};
    link_watchdog link_watchdog_{};
    logic_inputs terminals_{};
    line_setting line_{}; ///< in effect
    instant now_{0};
    std::int32_t analog_{0}; ///< the reference at the terminals, in mHz
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

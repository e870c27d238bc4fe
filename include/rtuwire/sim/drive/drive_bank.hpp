// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated drive as its server sees it: a bank of registers. What a word may be, what a written word does, and the
// scanner, whose words stand for other registers.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/sim/drive/drive_parts.hpp>
#include <rtuwire/sim/drive/registers/menu_order.hpp>
#include <rtuwire/sim/drive/registers/row_rules.hpp>
#include <rtuwire/sim/drive/registers/scanner.hpp>
#include <rtuwire/sim/drive/registers/speed_limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The bank of a drive. Internal: `drive` is the one to use.
template <device_type Device> class drive_bank : public drive_parts<Device> {
protected:
    using parts = drive_parts<Device>;
    using parts::at;
    using parts::control_;
    using parts::layout;
    using parts::link_watchdog_;
    using parts::memory_;
    using parts::now_;
    using parts::registers_;
    using parts::set;
    using parts::settle;
    using typename parts::registers;

public:
    using parts::state_machine;

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
        return check_together(start, values);
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

private:
    using orders = menu_orders_of<registers>;
    static constexpr scanner_half<Device> inputs{Device::scanner.input_words, Device::scanner.input_addresses};
    static constexpr scanner_half<Device> outputs{Device::scanner.output_words, Device::scanner.output_addresses};

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

    /// Whether the words of a request fit each other and what is held beside them.
    constexpr errc check_together([[maybe_unused]] std::uint16_t start,
                                  [[maybe_unused]] register_view values) const noexcept
    {
        if constexpr (is_whole<Device>) {
            speed_limits<registers> after{registers_};
            for (std::size_t i = 0; i < values.size(); ++i) {
                after.put(registers::at_address(start + i), values[i]);
            }
            return after.hold() ? errc::none : errc::illegal_data_value;
        } else {
            return errc::none;
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
        if (target != registers::nowhere and registers::rule(target).mode != access::read_only and
            check_word(target, word) == errc::none and fits(target, word)) {
            registers_.put_word(target, word);
            act_on(target, word);
        }
    }

    /// Whether a single word fits what is held beside it.
    constexpr bool fits([[maybe_unused]] std::size_t place, [[maybe_unused]] std::uint16_t word) const noexcept
    {
        if constexpr (is_whole<Device>) {
            speed_limits<registers> after{registers_};
            after.put(place, word);
            return after.hold();
        } else {
            return true;
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
};

} // namespace rtuwire::sim

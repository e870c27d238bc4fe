// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated Altivar: the registers of a whole device as a bank for a server, a state chart, a motor on
// a ramp, a link that is supervised, a scanner, faults, local control and an EEPROM. Time is what
// `advance` says. Made from what the manuals tell; of a real drive's habits it knows no more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/configure_scanner.hpp>
#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/server/bank.hpp>
#include <rtuwire/sim/chart.hpp>
#include <rtuwire/sim/image.hpp>
#include <rtuwire/sim/motor.hpp>
#include <rtuwire/sim/supervision.hpp>

namespace rtuwire::sim {

/// LFT of a lost serial link, on every Altivar.
inline constexpr std::uint16_t link_fault = 5;

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
        chart_.initialised();
        if (supervision_.is_lost(now, time_out())) {
            lose_link();
        }
        turn(passed);
        show();
    }

    /// Takes note of a request to this unit, whatever it asks.
    constexpr void note_contact() noexcept { supervision_.note_contact(now_); }

    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (registers::at_address(start + i) == registers::nowhere) {
                return errc::illegal_data_address;
            }
        }
        return errc::none;
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
        is_local_ = is_local;
        if (is_local) {
            chart_.fall_back();
        }
        show();
    }

    /// The STOP key: the drive falls back, and says so until it runs again.
    constexpr void press_stop() noexcept
    {
        is_stopped_by_key_ = true;
        chart_.fall_back();
        show();
    }

    /// A fault whose cause stays until `clear_cause`; `code` is its LFT.
    constexpr void inject_fault(std::uint16_t code) noexcept
    {
        has_cause_ = true;
        trip(code);
    }
    constexpr void clear_cause() noexcept { has_cause_ = false; }

    /// Off and on again: what was not saved is lost.
    constexpr void power_cycle(instant now) noexcept
    {
        registers_ = registers{};
        registers_.restore(eeprom_);
        power_up(now);
    }

    // What can be seen at the drive itself.

    [[nodiscard]] constexpr sim::chart const& chart() const noexcept { return chart_; }
    [[nodiscard]] constexpr sim::motor const& motor() const noexcept { return motor_; }
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return fault_; }

    /// The word of a register by its mnemonic; 0 for one that this device does not have.
    [[nodiscard]] constexpr std::uint16_t word(text code) const noexcept
    {
        return word_at(registers::at(code));
    }

private:
    /// The places of the registers that the model reads or shows.
    struct places {
        std::size_t cmd{registers::at("CMD")}, cmdd{registers::at("CMDD")};
        std::size_t lfr{registers::at("LFR")}, lfrd{registers::at("LFRD")};
        std::size_t cmi{registers::at("CMI")}, eta{registers::at("ETA")};
        std::size_t etad{registers::at("ETAD")}, eti{registers::at("ETI")};
        std::size_t rfr{registers::at("RFR")}, frh{registers::at("FRH")};
        std::size_t rfrd{registers::at("RFRD")}, frhd{registers::at("FRHD")};
        std::size_t spd{registers::at("SPD")}, lcr{registers::at("LCR")};
        std::size_t otr{registers::at("OTR")}, opr{registers::at("OPR")};
        std::size_t uln{registers::at("ULN")}, thd{registers::at("THD")};
        std::size_t thr{registers::at("THR")}, lft{registers::at("LFT")};
        std::size_t hmis{registers::at("HMIS")}, errd{registers::at("ERRD")};
        std::size_t acc{registers::at("ACC")}, dec{registers::at("DEC")};
        std::size_t inr{registers::at("INR")}, hsp{registers::at("HSP")};
        std::size_t lsp{registers::at("LSP")}, frs{registers::at("FRS")};
        std::size_t nsp{registers::at("NSP")}, sds{registers::at("SDS")};
        std::size_t ncr{registers::at("NCR")}, inv{registers::at("INV")};
        std::size_t ith{registers::at("ITH")}, tto{registers::at("TTO")};
        std::size_t sll{registers::at("SLL")};
    };
    static constexpr places at{};

    static constexpr std::int32_t volts_of_mains = 400;
    static constexpr std::uint16_t direct_control = 0x8000; ///< CMD, ATV28
    static constexpr std::uint16_t release_link = 0x0100;   ///< CMD, with the bit above
    static constexpr std::uint16_t ramp_stop = 0x1000;
    static constexpr std::uint16_t dc_stop = 0x2000;
    static constexpr std::uint16_t fast_stop = 0x4000;
    static constexpr std::uint16_t restore_bit = 0x0004;  ///< CMI, ATV28
    static constexpr std::uint16_t unsupervised = 0x4000; ///< CMI, ATV28

    constexpr void power_up(instant now) noexcept
    {
        now_ = now;
        chart_.power_up();
        motor_ = sim::motor{};
        supervision_ = supervision{};
        fault_ = 0;
        has_cause_ = is_stopped_by_key_ = is_local_ = false;
        registers_.put(at.cmd, 0);
        registers_.put(at.lfr, 0);
        registers_.put(at.lfrd, 0);
        registers_.put(at.cmi, registers_.get(at.cmi) & unsupervised);
        show();
    }

    // The line's side.

    constexpr errc check_word(std::size_t place, std::uint16_t word) const noexcept
    {
        bool const is_command = place == at.cmd or place == at.lfr or place == at.lfrd;
        if (is_command) {
            bool const is_refused = is_local_ and profile.refuses_commands_in_local;
            return is_refused ? errc::server_device_failure : errc::none;
        }
        if (registers::rule(place).mode == access::configuration and
            cia402::has_power(chart_.state())) {
            return errc::server_device_failure;
        }
        return registers_.check(place, word);
    }

    constexpr std::uint16_t word_at(std::size_t place) const noexcept
    {
        std::size_t const slot = slot_of(place, altivar::scanner_input_words);
        if (slot == profile.scanner_words) {
            return registers_.get(place);
        }
        return registers_.get(target_of(altivar::scanner_input_addresses, slot));
    }

    /// Which scanner word a register is; the number of slots where it is none.
    static constexpr std::size_t slot_of(std::size_t place, std::uint16_t first) noexcept
    {
        std::size_t slot = 0;
        while (slot < profile.scanner_words and registers::at_address(first + slot) != place) {
            ++slot;
        }
        return slot;
    }

    /// The register that a scanner's slot stands for; none for address 0 or one that does not exist.
    constexpr std::size_t target_of(std::uint16_t first, std::size_t slot) const noexcept
    {
        return registers::at_address(registers_.get(registers::at_address(first + slot)));
    }

    constexpr void store(std::size_t place, std::uint16_t word) noexcept
    {
        registers_.put(place, registers::rule(place).is_signed
                                  ? std::int64_t{static_cast<std::int16_t>(word)}
                                  : std::int64_t{word});
        if (registers::rule(place).mode == access::configuration) {
            reconfigured();
        }
        std::size_t const slot = slot_of(place, altivar::scanner_output_words);
        if (slot < profile.scanner_words) {
            forward(target_of(altivar::scanner_output_addresses, slot), word);
        } else {
            act_on(place, word);
        }
    }

    /// A scanner output word: what its register would refuse is dropped.
    constexpr void forward(std::size_t target, std::uint16_t word) noexcept
    {
        if (target != registers::nowhere and registers::rule(target).mode != access::read_only and
            check_word(target, word) == errc::none) {
            registers_.put(target, registers::rule(target).is_signed
                                       ? std::int64_t{static_cast<std::int16_t>(word)}
                                       : std::int64_t{word});
            act_on(target, word);
        }
    }

    constexpr void act_on(std::size_t place, std::uint16_t word) noexcept
    {
        if (place == at.cmd or place == at.cmdd) {
            obey(word);
        } else if (place == at.lfr) {
            registers_.put(at.lfrd, to_rpm(registers_.get_signed(at.lfr) * 100));
        } else if (place == at.lfrd) {
            registers_.put(at.lfr, to_millihertz(registers_.get_signed(at.lfrd)) / 100);
        } else if (place == at.cmi) {
            extended_command(word);
        }
    }

    constexpr void reconfigured() noexcept
    {
        bool const falls =
            profile.falls_back_when_configured and chart_.state() == cia402::state::switched_on;
        if (falls) {
            chart_.fall_back();
        }
    }

    constexpr void obey(std::uint16_t word) noexcept
    {
        std::uint16_t const before = last_command_;
        last_command_ = word;
        registers_.put(at.cmdd, word);
        if (is_local_) {
            return;
        }
        bool const is_direct = profile.dc_injection != 0 and (word & direct_control) != 0;
        if (is_direct) {
            obey_directly(word);
            return;
        }
        cia402::command const what = cia402::recognise(before, word);
        chart_.obey(what, not has_cause_);
        if (what == cia402::command::fault_reset and not has_fault()) {
            fault_was_reset();
        }
        if (chart_.state() == cia402::state::operation_enabled) {
            is_stopped_by_key_ = false;
        }
    }

    constexpr void obey_directly(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t enabled = 0x000A;
        if ((word & release_link) != 0) {
            set_local(true);
        } else if ((word & enabled) == enabled) {
            chart_.enable_directly();
        } else {
            chart_.fall_back();
        }
    }

    constexpr bool has_fault() const noexcept
    {
        return chart_.state() == cia402::state::fault or
               chart_.state() == cia402::state::fault_reaction_active;
    }

    constexpr void fault_was_reset() noexcept
    {
        fault_ = 0;
        supervision_.note_contact(now_);
    }

    constexpr void extended_command(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t factory_bit = 0x0001;
        constexpr std::uint16_t orders = factory_bit | altivar::save_bit | restore_bit;
        bool const clears_itself = not profile.shows_eeprom_access;
        if (cia402::has_power(chart_.state())) {
            return;
        }
        if ((word & factory_bit) != 0) {
            registers_.restore(registers::factory());
        } else if ((word & altivar::save_bit) != 0) {
            eeprom_ = registers_.all();
            ++saves_;
        } else if ((word & restore_bit) != 0 and clears_itself) {
            registers_.restore(eeprom_);
        }
        registers_.put(at.cmi, clears_itself ? word & ~orders : word);
    }

    // The link.

    constexpr duration time_out() const noexcept
    {
        bool const is_ignored = at.tto == registers::nowhere
                                    ? (registers_.get(at.cmi) & unsupervised) != 0
                                    : not trips_on_loss(registers_.get(at.sll));
        if (is_ignored) {
            return duration{};
        }
        return at.tto == registers::nowhere ? Device::silence.factory
                                            : milliseconds(100) * registers_.get(at.tto);
    }

    /// SLL: 0 ignores a loss, 4 and 5 go on at another speed.
    static constexpr bool trips_on_loss(std::uint16_t reaction) noexcept
    {
        return reaction != 0 and reaction != 4 and reaction != 5;
    }

    constexpr void lose_link() noexcept
    {
        trip(link_fault);
        last_command_ = 0;
        registers_.put(at.cmd, 0);
        registers_.put(at.lfr, 0);
        registers_.put(at.lfrd, 0);
    }

    constexpr void trip(std::uint16_t code) noexcept
    {
        if (has_fault()) {
            return;
        }
        fault_ = code;
        registers_.put(at.lft, code);
        registers_.put(at.errd, code == link_fault ? 0x7510 : 0x1000);
        remember(code);
        chart_.trip();
        show();
    }

    /// The fault record: the newest first.
    constexpr void remember(std::uint16_t code) noexcept
    {
        constexpr std::array<std::size_t, 5> record{
            registers::at("DP0") == registers::nowhere ? registers::at("DP1")
                                                       : registers::at("DP0"),
            registers::at("DP1"), registers::at("DP2"), registers::at("DP3"), registers::at("DP4")};
        for (std::size_t i = record.size() - 1; i > 0; --i) {
            registers_.put(record[i], registers_.get(record[i - 1]));
        }
        registers_.put(record[0], code);
    }

    // The motor.

    constexpr motor_settings settings() const noexcept
    {
        std::int64_t step = 100'000;
        if (at.inr != registers::nowhere) {
            std::uint16_t const inr = registers_.get(at.inr);
            step = inr == 0 ? 10'000 : inr == 2 ? 1'000'000 : 100'000;
        }
        std::size_t const current = at.ncr == registers::nowhere ? at.inv : at.ncr;
        std::int32_t const rated = registers_.get(at.frs) == 0 ? 500 : registers_.get(at.frs);
        return {rated * 100, step * registers_.get(at.acc), step * registers_.get(at.dec),
                registers_.get(current), registers_.get(at.ith)};
    }

    /// What the reference asks for, before the limits.
    constexpr std::int32_t asked() const noexcept
    {
        std::int32_t const value = registers_.get_signed(at.lfr) * 100;
        return (last_command_ & altivar::reverse_bit) != 0 ? -value : value;
    }

    constexpr bool is_stopping() const noexcept
    {
        bool const is_direct = (last_command_ & direct_control) != 0;
        bool const has_stop_bit = is_direct
                                      ? (last_command_ & (ramp_stop | dc_stop | fast_stop)) != 0
                                      : (last_command_ & profile.halt) != 0;
        return chart_.is_leaving() or has_stop_bit or
               chart_.state() != cia402::state::operation_enabled;
    }

    constexpr std::int32_t limited(std::int32_t value) const noexcept
    {
        std::int32_t const most = registers_.get(at.hsp) * 100;
        std::int32_t const least = registers_.get(at.lsp) * 100;
        std::int32_t const size = value < 0 ? -value : value;
        std::int32_t const cut = size > most ? most : size < least ? least : size;
        return value < 0 ? -cut : cut;
    }

    constexpr void turn(duration passed) noexcept
    {
        if (not cia402::has_power(chart_.state()) or is_freewheeling()) {
            motor_.coast(passed, settings());
        } else {
            motor_settings set = settings();
            bool const is_fast = chart_.state() == cia402::state::quick_stop_active or
                                 (last_command_ & direct_control & fast_stop) != 0;
            set.deceleration = is_fast ? set.deceleration / 4 : set.deceleration;
            motor_.drive(is_stopping() ? 0 : limited(asked()), passed, set);
        }
        if (motor_.is_at_rest()) {
            chart_.at_rest();
        }
    }

    /// A fault takes the torque away, unless it is a lost link that SLL wants a ramp for.
    constexpr bool is_freewheeling() const noexcept
    {
        std::uint16_t const reaction = registers_.get(at.sll);
        bool const ramps = fault_ == link_fault and reaction >= 2;
        return chart_.state() == cia402::state::fault_reaction_active and not ramps;
    }

    /// Millihertz for revolutions a minute: by the motor's nameplate, or by SDS.
    constexpr std::int32_t to_millihertz(std::int32_t speed) const noexcept
    {
        if (at.nsp == registers::nowhere) {
            std::int32_t const per_hertz = registers_.get(at.sds);
            return per_hertz == 0 ? 0 : speed * 1'000 / per_hertz;
        }
        return speed * pole_pairs() * 50 / 3;
    }
    constexpr std::int32_t to_rpm(std::int32_t millihertz) const noexcept
    {
        if (at.nsp == registers::nowhere) {
            return millihertz / 100 * registers_.get(at.sds) / 10;
        }
        return millihertz / 50 * 3 / pole_pairs();
    }
    constexpr std::int32_t pole_pairs() const noexcept
    {
        std::int32_t const speed = registers_.get(at.nsp);
        std::int32_t const pairs =
            speed == 0 ? 1 : (registers_.get(at.frs) * 6 + speed / 2) / speed;
        return pairs == 0 ? 1 : pairs;
    }

    // What the registers show.

    constexpr std::uint16_t status() const noexcept
    {
        std::uint32_t word = cia402::status_bits(chart_.state());
        bool const runs = chart_.state() == cia402::state::operation_enabled;
        std::int32_t const target = is_stopping() ? 0 : limited(asked());
        word |= profile.mains_bit_is_inverted ? 0U : 0x10U;
        word |= is_local_ ? 0U : altivar::remote_bit;
        word |= runs and motor_.frequency() == target ? altivar::reference_reached_bit : 0U;
        word |= runs and limited(asked()) != asked() ? altivar::reference_limited_bit : 0U;
        word |= is_stopped_by_key_ ? altivar::stop_key_bit : 0U;
        word |= motor_.frequency() < 0 ? altivar::runs_backwards_bit : 0U;
        return static_cast<std::uint16_t>(word);
    }

    constexpr std::uint16_t product_state() const noexcept
    {
        constexpr std::uint16_t ready = 2, freewheel = 3, runs = 4, accelerates = 5, slows = 6,
                                in_fault = 23;
        if (has_fault()) {
            return in_fault;
        }
        if (not cia402::has_power(chart_.state())) {
            return chart_.state() == cia402::state::switch_on_disabled ? freewheel : ready;
        }
        return motor_.is_accelerating() ? accelerates : motor_.is_decelerating() ? slows : runs;
    }

    constexpr void show() noexcept
    {
        std::int32_t const now_at = motor_.frequency();
        std::int32_t const goal = is_stopping() ? 0 : limited(asked());
        bool const is_signed = registers::rule(at.rfr).is_signed;
        std::int32_t const size = now_at < 0 ? -now_at : now_at;
        registers_.put(at.eta, status());
        registers_.put(at.etad, status());
        registers_.put(at.rfr, (is_signed ? now_at : size) / 100);
        registers_.put(at.frh, goal / 100);
        registers_.put(at.rfrd, to_rpm(now_at));
        registers_.put(at.frhd, to_rpm(goal));
        registers_.put(at.spd, to_rpm(size));
        registers_.put(at.lcr, motor_.current());
        registers_.put(at.otr, motor_.current() * 300);
        registers_.put(at.opr, motor_.current() * size / 20'000);
        registers_.put(at.uln, volts_of_mains * registers::rule(at.uln).steps_per_unit);
        registers_.put(at.thr, motor_.thermal_state());
        registers_.put(at.thd, motor_.thermal_state() / 2);
        registers_.put(at.hmis, product_state());
        show_extended();
    }

    constexpr void show_extended() noexcept
    {
        constexpr unsigned fault_is_gone = 2, motor_turns = 4, accelerates = 9, slows = 10,
                           by_link = 14, backwards = 15;
        std::uint32_t word = 0;
        word |= (has_fault() and not has_cause_ ? 1U : 0U) << fault_is_gone;
        word |= (motor_.is_at_rest() ? 0U : 1U) << motor_turns;
        word |= (motor_.is_accelerating() ? 1U : 0U) << accelerates;
        word |= (motor_.is_decelerating() ? 1U : 0U) << slows;
        word |= (is_local_ ? 0U : 1U) << by_link;
        word |= (asked() < 0 ? 1U : 0U) << backwards;
        registers_.put(at.eti, word);
    }

    registers registers_{};
    typename registers::words eeprom_{registers::factory()};
    sim::chart chart_{profile.chart};
    sim::motor motor_{};
    supervision supervision_{};
    instant now_{};
    std::uint32_t saves_{0};
    std::uint16_t last_command_{0};
    std::uint16_t fault_{0};
    bool has_cause_{false};
    bool is_local_{false};
    bool is_stopped_by_key_{false};
};

} // namespace rtuwire::sim

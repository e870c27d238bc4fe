// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Who commands a simulated drive and what the command words did: its chart, the edges of the words, direct
// control, the keys on the drive, the fault. Knows neither registers nor a motor.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/channels.hpp>
#include <rtuwire/sim/chart.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// How a motor is brought to rest; `as_set` is what the register STT says.
enum class stopping : std::uint8_t { none, ramp, fast, freewheel, injection, as_set };

/// The command side of a drive.
class control {
public:
    explicit constexpr control(altivar::drive_profile const& profile) noexcept
        : profile_{&profile}, chart_{profile.chart}
    {}

    [[nodiscard]] constexpr sim::chart const& chart() const noexcept { return chart_; }

    /// LFT of the fault that the drive is in; 0 in none.
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return fault_; }
    [[nodiscard]] constexpr bool has_cause() const noexcept { return has_cause_; }
    [[nodiscard]] constexpr bool is_stopped_by_key() const noexcept { return is_stopped_by_key_; }
    [[nodiscard]] constexpr bool has_fault() const noexcept
    {
        return cia402::is_in_fault(chart_.state());
    }

    /// Whether Modbus commands the drive.
    [[nodiscard]] constexpr bool is_by_link() const noexcept
    {
        return choice_.is_link and not is_forced_local() and not is_released_;
    }

    /// Whether somebody at the drive has taken the command away, by a key or an input.
    [[nodiscard]] constexpr bool is_forced_local() const noexcept
    {
        return is_at_keypad_ or choice_.is_forced_local;
    }

    /// Whether the command asks for the other direction.
    [[nodiscard]] constexpr bool is_reversed() const noexcept
    {
        return is_by_link() and (last_command_ & altivar::reverse_bit) != 0;
    }

    /// How the motor is being stopped; `none` while it may turn.
    [[nodiscard]] constexpr stopping how_it_stops() const noexcept
    {
        if (chart_.state() == cia402::state::quick_stop_active) {
            return stopping::fast;
        }
        if (chart_.state() != cia402::state::operation_enabled or chart_.is_leaving()) {
            return is_by_link() and not choice_.is_io_profile ? stopping::ramp : stopping::as_set;
        }
        if (is_abandoned_) {
            return stopping::as_set;
        }
        return is_by_link() ? how_the_word_stops() : stopping::none;
    }

    /// Switched on; of what was before it knows nothing. A drive with direct control obeys its terminals until
    /// the link commands it.
    constexpr void power_up() noexcept
    {
        *this = control{*profile_};
        is_released_ = profile_->direct_control != 0;
        chart_.power_up();
    }
    constexpr void initialised() noexcept { chart_.initialised(); }

    /// The motor stands.
    constexpr void at_rest() noexcept
    {
        chart_.at_rest();
        if (is_abandoned_) {
            is_abandoned_ = false;
            chart_.fall_back();
        }
    }

    /// A configuration write.
    constexpr void fall_back() noexcept { chart_.fall_back(); }

    /// Settings and inputs as they are now. Whoever takes the command over finds the drive stopped.
    constexpr void choose(channel_choice const& now) noexcept
    {
        bool const was_by_link = is_by_link();
        choice_ = now;
        if (was_by_link != is_by_link()) {
            chart_.fall_back();
        }
        if (not is_by_link() and not is_at_keypad_) {
            run_by_level(choice_.is_run_closed);
        }
    }

    /// A command word; whether it reset a fault.
    constexpr bool obey(std::uint16_t word) noexcept
    {
        std::uint16_t const before = last_command_;
        last_command_ = word;
        if (choice_.is_link and not is_forced_local()) {
            set_released(is_direct(word) and (word & release_link) != 0);
        }
        if (not is_by_link()) {
            return false;
        }
        is_abandoned_ = false;
        bool const is_reset = reset_by(before, word);
        if (not is_reset) {
            follow(word);
        }
        if (chart_.state() == cia402::state::operation_enabled) {
            is_stopped_by_key_ = is_stop_held_;
        }
        if (is_stop_held_) {
            chart_.fall_back();
        }
        return is_reset;
    }

    /// The drive itself takes the command back.
    constexpr void forget_command() noexcept { last_command_ = 0; }

    /// The link is lost and the drive stops for it, but trips for nothing: back to "switch on disabled" at rest.
    constexpr void abandon() noexcept
    {
        is_abandoned_ = true;
        forget_command();
    }

    /// A fault by its LFT; false where the drive is in one already, which counts.
    constexpr bool trip(std::uint16_t code) noexcept
    {
        if (has_fault()) {
            return false;
        }
        fault_ = code;
        chart_.trip();
        return true;
    }

    /// Resets a fault by itself and goes on with the word that stands, as an automatic restart does.
    constexpr void restart() noexcept
    {
        chart_.obey(cia402::command::fault_reset, not has_cause_);
        fault_ = has_fault() ? fault_ : std::uint16_t{0};
        constexpr std::uint16_t running = 0x000F;
        if (not has_fault() and is_by_link() and (last_command_ & running) == running) {
            chart_.enable_directly();
        }
    }

    /// While a fault has its cause, no reset ends it.
    constexpr void set_cause(bool is_there) noexcept { has_cause_ = is_there; }

    /// Somebody takes the command at the keypad, or gives it back.
    constexpr void set_local(bool is_local) noexcept
    {
        is_at_keypad_ = is_local;
        if (is_local) {
            chart_.fall_back();
        }
    }

    /// The STOP key, held or let go: the drive falls back, runs for nobody while it is held, and says so until it
    /// runs again.
    constexpr void hold_stop(bool is_held) noexcept
    {
        is_stop_held_ = is_held;
        if (is_held) {
            is_stopped_by_key_ = true;
            chart_.fall_back();
        }
    }

private:
    static constexpr std::uint16_t release_link = 0x0100; ///< CMD, with the bit of direct control
    static constexpr std::uint16_t ramp_stop = 0x1000;
    static constexpr std::uint16_t dc_stop = 0x2000;
    static constexpr std::uint16_t fast_stop = 0x4000;

    constexpr bool is_direct(std::uint16_t word) const noexcept
    {
        return (word & profile_->direct_control) != 0;
    }

    constexpr stopping how_the_word_stops() const noexcept
    {
        if (not is_direct(last_command_)) {
            return (last_command_ & profile_->halt) != 0 ? stopping::as_set : stopping::none;
        }
        if ((last_command_ & fast_stop) != 0) {
            return stopping::fast;
        }
        if ((last_command_ & dc_stop) != 0) {
            return stopping::injection;
        }
        return (last_command_ & ramp_stop) != 0 ? stopping::ramp : stopping::none;
    }

    /// The link gives the control to the terminals, or takes it back.
    constexpr void set_released(bool is_released) noexcept
    {
        if (is_released_ != is_released) {
            is_released_ = is_released;
            chart_.fall_back();
        }
    }

    /// In a fault the edge of bit 7 counts, in words of any kind, and nothing else does.
    constexpr bool reset_by(std::uint16_t before, std::uint16_t word) noexcept
    {
        if (chart_.state() != cia402::state::fault or not cia402::is_reset_edge(before, word)) {
            return false;
        }
        chart_.obey(cia402::command::fault_reset, not has_cause_);
        fault_ = has_fault() ? fault_ : std::uint16_t{0};
        return not has_fault();
    }

    constexpr void follow(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t run = 0x0001;
        if (choice_.is_io_profile) {
            run_by_level((word & run) != 0);
        } else if (is_direct(word)) {
            obey_directly(word);
        } else {
            chart_.obey(cia402::recognise(word), false);
        }
    }

    /// The five words of direct control have bits 1 and 3; others take the power away.
    constexpr void obey_directly(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t enabled = 0x000A;
        if ((word & enabled) == enabled) {
            chart_.enable_directly();
        } else {
            chart_.fall_back();
        }
    }

    constexpr void run_by_level(bool is_asked) noexcept
    {
        if (is_asked and not is_stop_held_) {
            chart_.enable_directly();
        } else if (chart_.state() == cia402::state::operation_enabled) {
            chart_.obey(cia402::command::switch_on, false); // "disable operation"
        }
    }

    altivar::drive_profile const* profile_;
    sim::chart chart_;
    channel_choice choice_{};
    std::uint16_t last_command_{0};
    std::uint16_t fault_{0};
    bool has_cause_{false};
    bool is_at_keypad_{false};
    bool is_released_{false};
    bool is_abandoned_{false};
    bool is_stop_held_{false};
    bool is_stopped_by_key_{false};
};

} // namespace rtuwire::sim

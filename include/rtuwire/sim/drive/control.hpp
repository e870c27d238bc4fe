// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which channel commands a simulated drive and what the command words did: its state machine, the edges of the words,
// direct control, the keys on the drive, the fault. The channels are its link, which it supervises, its logic inputs and its
// keypad. Knows neither registers nor a motor.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/state_machine.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The logic inputs of a drive, LI1 first.
class logic_inputs {
public:
    constexpr void set(std::size_t number, bool is_closed) noexcept
    {
        std::uint32_t const bit = number == 0 or number > 16 ? 0U : 1U << (number - 1);
        closed_ = is_closed ? closed_ | bit : closed_ & ~bit;
    }
    [[nodiscard]] constexpr bool is_closed(std::size_t number) const noexcept
    {
        return number > 0 and number <= 16 and ((closed_ >> (number - 1)) & 1U) != 0;
    }

    /// The closed inputs as bits, LI1 in bit 0.
    [[nodiscard]] constexpr std::uint16_t image() const noexcept { return static_cast<std::uint16_t>(closed_); }

private:
    std::uint32_t closed_{0};
};

/// Which channel commands, and how.
struct channel_choice {
    bool is_link{true};          ///< the settings give the command to Modbus
    bool is_forced_local{false}; ///< an input takes it away
    bool is_io_profile{false};   ///< bit 0 of the command word is RUN
    bool is_run_closed{false};   ///< the terminals command to run: LI1, two wires, by level
};

/// Who commands the drive: the link by the settings, unless a key or an input takes the command away, or the link has
/// given it to the terminals.
class command_source {
public:
    constexpr void choose(channel_choice const& now) noexcept { choice_ = now; }
    [[nodiscard]] constexpr channel_choice const& choice() const noexcept { return choice_; }

    /// Whether the settings give the command to the link, and nothing at the drive takes it away.
    [[nodiscard]] constexpr bool may_be_link() const noexcept { return choice_.is_link and not is_forced_local(); }

    /// Whether the link commands.
    [[nodiscard]] constexpr bool is_link() const noexcept { return may_be_link() and not is_released_; }

    /// Whether a key or an input at the drive has taken the command from Modbus.
    [[nodiscard]] constexpr bool is_forced_local() const noexcept { return is_at_keypad_ or choice_.is_forced_local; }
    [[nodiscard]] constexpr bool is_at_keypad() const noexcept { return is_at_keypad_; }
    constexpr void set_at_keypad(bool is_at_keypad) noexcept { is_at_keypad_ = is_at_keypad; }

    /// The link gives the control to the terminals, or takes it back; returns whether that changed it.
    constexpr bool set_released(bool is_released) noexcept
    {
        bool const is_new = is_released_ != is_released;
        is_released_ = is_released;
        return is_new;
    }

private:
    channel_choice choice_{};
    bool is_at_keypad_{false};
    bool is_released_{false};
};

/// How a drive supervises its serial link: after the first request, each next one must come within the time-out.
class link_watchdog {
public:
    /// A request has come.
    constexpr void note_contact(instant now) noexcept
    {
        back_at_ = has_lost_ ? now : back_at_;
        has_lost_ = false;
        is_armed_ = true;
        last_ = now;
    }

    /// Whether the link was lost, and no request has come since.
    [[nodiscard]] constexpr bool has_lost() const noexcept { return has_lost_; }

    /// Whether requests have come again for a second: a drive that restarts by itself waits so long.
    [[nodiscard]] constexpr bool is_back(instant now) const noexcept
    {
        return not has_lost_ and now - back_at_ >= milliseconds(1'000);
    }

    /// Whether the time-out has passed since the last request, reported once; a time-out of 0 never passes.
    [[nodiscard]] constexpr bool is_lost(instant now, duration time_out) noexcept
    {
        bool const is_over =
            is_armed_ and time_out.microseconds != 0 and (now - last_).microseconds >= time_out.microseconds;
        if (is_over) {
            is_armed_ = false;
            has_lost_ = true;
        }
        return is_over;
    }

private:
    instant last_{0};
    instant back_at_{0};
    bool has_lost_{false};
    bool is_armed_{false};
};

/// How a motor is stopped; `as_set` is the setting of the register STT.
enum class stopping : std::uint8_t { none, ramp, fast, freewheel, injection, as_set };

/// Whether a command word is one of direct control.
[[nodiscard]] constexpr bool is_direct(std::uint16_t word, altivar::drive_layout const& layout) noexcept
{
    return (word & layout.direct_control) != 0;
}

/// The five words of direct control have bits 1 and 3 set; others remove the power.
[[nodiscard]] constexpr bool is_direct_run(std::uint16_t word) noexcept
{
    constexpr std::uint16_t enabled = 0x000A;
    return (word & enabled) == enabled;
}

/// Whether a command word gives the control to the terminals.
[[nodiscard]] constexpr bool releases_link(std::uint16_t word, altivar::drive_layout const& layout) noexcept
{
    constexpr std::uint16_t release_link = 0x0100;
    return is_direct(word, layout) and (word & release_link) != 0;
}

/// How the bits of a command word stop a motor in operation; `none` where it may turn.
[[nodiscard]] constexpr stopping how_it_stops_by(std::uint16_t word, altivar::drive_layout const& layout) noexcept
{
    constexpr std::uint16_t ramp_stop = 0x1000, dc_stop = 0x2000, fast_stop = 0x4000;
    if (not is_direct(word, layout)) {
        return (word & layout.halt) != 0 ? stopping::as_set : stopping::none;
    }
    if ((word & fast_stop) != 0) {
        return stopping::fast;
    }
    if ((word & dc_stop) != 0) {
        return stopping::injection;
    }
    return (word & ramp_stop) != 0 ? stopping::ramp : stopping::none;
}

/// The command side of a drive.
class control {
public:
    explicit constexpr control(altivar::drive_layout const& layout) noexcept
        : layout_{&layout}, state_machine_{layout.state_machine}
    {}

    [[nodiscard]] constexpr detail::state_machine const& state_machine() const noexcept { return state_machine_; }

    /// LFT of the present fault; 0 for none.
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return fault_; }
    [[nodiscard]] constexpr bool has_cause() const noexcept { return has_cause_; }
    [[nodiscard]] constexpr bool is_stopped_by_key() const noexcept { return is_stopped_by_key_; }
    [[nodiscard]] constexpr bool has_fault() const noexcept { return cia402::is_in_fault(state_machine_.state()); }

    /// Whether Modbus commands the drive.
    [[nodiscard]] constexpr bool is_by_link() const noexcept { return source_.is_link(); }

    /// Whether a key or an input at the drive has taken the command from Modbus.
    [[nodiscard]] constexpr bool is_forced_local() const noexcept { return source_.is_forced_local(); }

    /// Whether the command asks for the other direction.
    [[nodiscard]] constexpr bool is_reversed() const noexcept
    {
        return is_by_link() and (last_command_ & altivar::reverse_bit) != 0;
    }

    /// How the motor is being stopped; `none` while it may turn.
    [[nodiscard]] constexpr stopping how_it_stops() const noexcept
    {
        if (state_machine_.state() == cia402::state::quick_stop_active) {
            return stopping::fast;
        }
        if (state_machine_.state() != cia402::state::operation_enabled or state_machine_.is_leaving()) {
            return is_by_link() and not source_.choice().is_io_profile ? stopping::ramp : stopping::as_set;
        }
        if (is_abandoned_) {
            return stopping::as_set;
        }
        return is_by_link() ? how_it_stops_by(last_command_, *layout_) : stopping::none;
    }

    /// Power-up: nothing before it is remembered. A drive with direct control follows its terminals until the link
    /// commands it.
    constexpr void power_up() noexcept
    {
        *this = control{*layout_};
        source_.set_released(layout_->direct_control != 0);
        state_machine_.power_up();
    }
    constexpr void initialised() noexcept { state_machine_.initialised(); }

    /// The motor has come to rest.
    constexpr void at_rest() noexcept
    {
        state_machine_.at_rest();
        if (is_abandoned_) {
            is_abandoned_ = false;
            state_machine_.fall_back();
        }
    }

    /// A configuration write.
    constexpr void fall_back() noexcept { state_machine_.fall_back(); }

    /// The present settings and inputs. A change of the commanding channel stops the drive.
    constexpr void choose(channel_choice const& now) noexcept
    {
        bool const was_by_link = is_by_link();
        source_.choose(now);
        if (was_by_link != is_by_link()) {
            state_machine_.fall_back();
        }
        if (not is_by_link() and not source_.is_at_keypad()) {
            run_by_level(now.is_run_closed);
        }
    }

    /// Applies a command word; returns whether it reset a fault.
    constexpr bool apply(std::uint16_t word) noexcept
    {
        std::uint16_t const before = last_command_;
        last_command_ = word;
        if (source_.may_be_link() and source_.set_released(releases_link(word, *layout_))) {
            state_machine_.fall_back();
        }
        if (not is_by_link()) {
            return false;
        }
        is_abandoned_ = false;
        bool const is_reset = reset_by(before, word);
        if (not is_reset) {
            follow(word);
        }
        if (state_machine_.state() == cia402::state::operation_enabled) {
            is_stopped_by_key_ = is_stop_held_;
        }
        if (is_stop_held_) {
            state_machine_.fall_back();
        }
        return is_reset;
    }

    /// The drive forgets its last command word.
    constexpr void forget_command() noexcept { last_command_ = 0; }

    /// The link is lost and the drive stops for it, without a fault: back to "switch on disabled" at rest.
    constexpr void abandon() noexcept
    {
        is_abandoned_ = true;
        forget_command();
    }

    /// Trips on a fault by its LFT; false where the drive is already in a fault, which stays.
    constexpr bool trip(std::uint16_t code) noexcept
    {
        if (has_fault()) {
            return false;
        }
        fault_ = code;
        state_machine_.trip();
        return true;
    }

    /// Resets a fault by itself and continues with the last command word, as an automatic restart does.
    constexpr void restart() noexcept
    {
        state_machine_.apply(cia402::command::fault_reset, not has_cause_);
        fault_ = has_fault() ? fault_ : std::uint16_t{0};
        constexpr std::uint16_t running = 0x000F;
        if (not has_fault() and is_by_link() and (last_command_ & running) == running) {
            state_machine_.enable_directly();
        }
    }

    /// While the cause of a fault is present, no reset clears the fault.
    constexpr void set_cause(bool is_there) noexcept { has_cause_ = is_there; }

    /// Gives the command to the keypad, or takes it back.
    constexpr void set_local(bool is_local) noexcept
    {
        source_.set_at_keypad(is_local);
        if (is_local) {
            state_machine_.fall_back();
        }
    }

    /// The STOP key, held or released: the drive falls back, does not run while it is held, and reports it until it
    /// runs again.
    constexpr void hold_stop(bool is_held) noexcept
    {
        is_stop_held_ = is_held;
        if (is_held) {
            is_stopped_by_key_ = true;
            state_machine_.fall_back();
        }
    }

private:
    /// In a fault only the edge of bit 7 has an effect, in words of any kind.
    constexpr bool reset_by(std::uint16_t before, std::uint16_t word) noexcept
    {
        if (state_machine_.state() != cia402::state::fault or not is_reset_edge(before, word)) {
            return false;
        }
        state_machine_.apply(cia402::command::fault_reset, not has_cause_);
        fault_ = has_fault() ? fault_ : std::uint16_t{0};
        return not has_fault();
    }

    constexpr void follow(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t run = 0x0001;
        if (source_.choice().is_io_profile) {
            run_by_level((word & run) != 0);
        } else if (is_direct(word, *layout_)) {
            is_direct_run(word) ? state_machine_.enable_directly() : state_machine_.fall_back();
        } else {
            state_machine_.apply(command_in(word), false);
        }
    }

    constexpr void run_by_level(bool is_asked) noexcept
    {
        if (is_asked and not is_stop_held_) {
            state_machine_.enable_directly();
        } else if (state_machine_.state() == cia402::state::operation_enabled) {
            state_machine_.apply(cia402::command::switch_on, false); // "disable operation"
        }
    }

    altivar::drive_layout const* layout_;
    detail::state_machine state_machine_;
    command_source source_{};
    std::uint16_t last_command_{0};
    std::uint16_t fault_{0};
    bool has_cause_{false};
    bool is_abandoned_{false};
    bool is_stop_held_{false};
    bool is_stopped_by_key_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

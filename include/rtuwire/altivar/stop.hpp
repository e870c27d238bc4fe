// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Stops a drive, in one of the ways that it has. None of them replaces an emergency stop: they reach
// the motor over a line that can fail.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// How the motor comes to rest.
enum class stop_by : std::uint8_t {
    ramp,         ///< disable operation; ends in "ready to switch on"
    freewheel,    ///< disable voltage: torque goes at once, the motor coasts
    quick_stop,   ///< the fast ramp
    halt,         ///< as STT says, and stays in operation enabled with the halt bit set
    dc_injection, ///< ATV28 only
};

/// Decides a stop, word by word.
class stop_script : public script {
public:
    constexpr stop_script(drive_profile const& profile, stop_by mode) noexcept
        : script{profile}, mode_{mode}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun:
            if (is_unsupported()) {
                return end(ending::unsupported);
            }
            return to_read(profile().eta);
        case event::kind::pause_over: return to_read(profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::written: return to_pause(look_period);
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        return end(ending::stuck);
    }

private:
    enum class asked : std::uint8_t { status, fault, control, frequency };

    constexpr bool is_unsupported() const noexcept
    {
        return (mode_ == stop_by::dc_injection and profile().dc_injection == 0) or
               (mode_ == stop_by::halt and profile().halt == 0);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        asked const which = asked_;
        asked_ = asked::status;
        switch (which) {
        case asked::status: return look(word);
        case asked::fault: return end_in_fault(word);
        case asked::control: return give(static_cast<std::uint16_t>(word | profile().halt));
        case asked::frequency: break;
        }
        return word == 0 ? at_rest() : to_pause(look_period);
    }

    constexpr wish ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        return to_read(address);
    }

    constexpr wish give(std::uint16_t word) noexcept
    {
        is_given_ = true;
        return to_write(profile().cmd, word);
    }

    constexpr wish look(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            return ask(asked::fault, profile().lft);
        }
        if (not cia402::has_power(at) and is_low_enough(at)) {
            return end(ending::succeeded);
        }
        if ((status & remote_bit) == 0) {
            return end(ending::local_control);
        }
        if (at == cia402::state::quick_stop_active) {
            return ask(asked::frequency, profile().rfr);
        }
        return at == cia402::state::operation_enabled ? leave_operation() : leave_switched_on(at);
    }

    /// "Switched on" is without power, but one command from running: only halt leaves a drive there.
    constexpr bool is_low_enough(cia402::state at) const noexcept
    {
        return at != cia402::state::unknown and
               (at != cia402::state::switched_on or mode_ == stop_by::halt);
    }

    constexpr wish leave_switched_on(cia402::state at) noexcept
    {
        return at == cia402::state::switched_on ? give(cia402::word_of(cia402::command::shutdown))
                                                : to_pause(look_period);
    }

    constexpr wish leave_operation() noexcept
    {
        if (is_given_) {
            bool const stays = mode_ == stop_by::halt or mode_ == stop_by::dc_injection;
            return stays ? ask(asked::frequency, profile().rfr) : to_pause(look_period);
        }
        switch (mode_) {
        case stop_by::ramp: return give(cia402::word_of(cia402::command::switch_on));
        case stop_by::freewheel: return give(cia402::word_of(cia402::command::disable_voltage));
        case stop_by::quick_stop: return give(cia402::word_of(cia402::command::quick_stop));
        case stop_by::halt: return ask(asked::control, profile().cmd);
        case stop_by::dc_injection: break;
        }
        return give(profile().dc_injection);
    }

    /// The motor stands, in a state that still has power.
    constexpr wish at_rest() noexcept
    {
        if (mode_ == stop_by::halt and reason().state == cia402::state::operation_enabled) {
            return end(ending::succeeded);
        }
        return to_write(profile().cmd, cia402::word_of(cia402::command::disable_voltage));
    }

    stop_by mode_;
    asked asked_{asked::status};
    bool is_given_{false};
};

/// Stops a drive; settles when the motor has no power, or for `halt` when it stands. A long ramp needs a
/// long limit.
class stop : public drive_talk<stop_script> {
public:
    template <device_type Device>
    explicit constexpr stop(station<Device> const& drive, stop_by mode = stop_by::ramp,
                            duration limit = milliseconds(30'000)) noexcept
        : drive_talk{drive.unit(), stop_script{Device::profile, mode}, limit}
    {}
};

} // namespace rtuwire::altivar

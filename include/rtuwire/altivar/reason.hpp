// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a conversation with a drive ended, and what was known of the drive then.
#pragma once

#include <cstdint>

#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// How it ended.
enum class ending : std::uint8_t {
    pending, ///< it has not
    succeeded,
    executed_unconfirmed,  ///< the drive took the order; what it did to the line cannot be asked
    refused,               ///< by an exception: `error` tells which
    no_place,              ///< the client keeps no more orders at once: see `drive_client`
    silent,                ///< no answer was accepted; `error` tells why
    stuck,                 ///< the state did not change in time, or fell back; a stop: taken, and not obeyed
    unconfirmed,           ///< a stop: its word was taken, or the motor slows down; it was not seen to stand
    in_fault,              ///< the drive is in fault; `fault` is its LFT
    local_control,         ///< somebody at the drive has the command
    reference_limited,     ///< done, but the reference is outside LSP..HSP
    refused_while_running, ///< only a stopped drive takes this
    unsupported,           ///< this drive cannot do that
    misconfigured,         ///< the drive's scanner holds other words than are needed
    halted,                ///< the halt bit is set: only a start takes it away
    overwritten,           ///< the command or reference in the drive is not the one written last
    overruled,             ///< a stop was ordered later, or is under way; or the drive was in fault or set up anew since
    contradictory,         ///< a negative reference and "reverse" at once: one sign for the direction
    unchecked,             ///< nobody looked whether the drive may be ordered
    unsupervised,          ///< the drive does not watch its link: it would never stop by itself
    runs_on_without_link,  ///< a lost link leaves the motor at its speed, or at a fallback speed
    other_channel,         ///< command or reference come from elsewhere than Modbus
    not_drive_profile,     ///< single bits of the control word run the drive (CHCF = IO)
    restarts_by_itself,    ///< after a fault, or by a closed run input after its power came back
    unknown_register,      ///< the drive does not have a register that has to be known
    timeout_too_short,     ///< the drive's time-out against the longest gap of the line
    run_input_closed,      ///< a terminal asks to run, and would as soon as it commands
    not_taken,             ///< a setting was written and reads back otherwise
    started_by_terminals,  ///< a local command runs the motor; the line cannot stop it
};

/// An ending with what was known.
struct reason {
    ending how{ending::pending};
    errc error{errc::none};
    cia402::state state{cia402::state::unknown}; ///< the last one seen
    std::uint16_t fault{0};                      ///< LFT, where it was read; 0 otherwise
    bool is_other_stop{false};                   ///< another stop than the one asked for: see stop.hpp

    friend constexpr bool operator==(reason const&, reason const&) noexcept = default;
};

/// An ending in words.
[[nodiscard]] constexpr text name_of(ending how) noexcept
{
    switch (how) {
    case ending::pending: return "under way";
    case ending::succeeded: return "done";
    case ending::executed_unconfirmed: return "executed, not confirmed";
    case ending::refused: return "refused by the drive";
    case ending::no_place: return "the client has no place for one more drive";
    case ending::silent: return "no answer";
    case ending::stuck: return "the drive does not follow";
    case ending::unconfirmed: return "told to stop, not seen to stand";
    case ending::in_fault: return "the drive is in fault";
    case ending::local_control: return "the drive is in local control";
    case ending::reference_limited: return "the reference is outside the drive's limits";
    case ending::refused_while_running: return "only possible while the motor is stopped";
    case ending::unsupported: return "this drive cannot do that";
    case ending::misconfigured: return "the drive's scanner holds other words";
    case ending::halted: return "the drive is halted";
    case ending::overwritten: return "another master commands the drive, or it lost its power";
    case ending::overruled: return "a stop, a fault or another set-up came later";
    case ending::contradictory: return "a negative reference and reverse at once";
    case ending::unchecked: return "the drive was not checked";
    case ending::unsupervised: return "the drive does not watch its link";
    case ending::runs_on_without_link: return "the drive runs on when its link is lost";
    case ending::other_channel: return "another channel commands the drive";
    case ending::not_drive_profile: return "single bits of the control word run the drive";
    case ending::restarts_by_itself: return "the drive restarts by itself";
    case ending::unknown_register: return "the drive does not have a register that has to be known";
    case ending::timeout_too_short: return "the drive's time-out is too short for the line";
    case ending::run_input_closed: return "a run input is closed";
    case ending::not_taken: return "a setting reads back otherwise";
    case ending::started_by_terminals: return "the terminals run the motor";
    }
    return "unknown";
}

} // namespace rtuwire::altivar

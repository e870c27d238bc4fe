// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a conversation with a drive ended, and what was known about the drive then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/errc_name.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How it ended.
enum class outcome_kind : std::uint8_t {
    pending, ///< not ended yet
    succeeded,
    executed_unconfirmed,  ///< the drive accepted the order; its effect on the link cannot be read
    refused,               ///< by an exception: `error` tells which
    no_place,              ///< the client cannot keep one more order: see `drive_client`
    silent,                ///< no response was accepted; `error` tells why
    state_timeout,         ///< the drive did not reach the state or speed in time; a stop: confirmed, and not obeyed
    fell_back,             ///< the drive had reached a state, and left it without a command from here
    stop_key,              ///< the drive shows that its STOP key was pressed
    aborted,               ///< given up: the drive is in no state for it, or the limit was over too early; see `error`
    unconfirmed,           ///< a stop: its word was confirmed, or the motor slows down; no standstill was read
    in_fault,              ///< the drive is in fault; `fault` is its LFT
    local_control,         ///< the drive is commanded locally, at its keypad or terminals
    reference_limited,     ///< done, but the reference is outside LSP..HSP: `limit` is kept
    refused_while_running, ///< only a stopped drive accepts this
    misconfigured,         ///< the drive's scanner holds other words than are needed
    halted,                ///< the halt bit is set: only a start takes it away
    overwritten,           ///< the command or reference in the drive is not the one written last
    overruled,            ///< a stop was ordered later or is under way; or the drive was in fault or set up again since
    contradictory,        ///< a negative reference and "reverse" at once: one sign for the direction
    unchecked,            ///< it was not checked whether the drive may be ordered
    unsupervised,         ///< the drive does not supervise its link: it would never stop by itself
    runs_on_without_link, ///< a lost link leaves the motor at its speed, or at a fallback speed
    other_channel,        ///< command or reference come from elsewhere than Modbus
    not_drive_profile,    ///< single bits of the control word run the drive (CHCF = IO)
    restarts_by_itself,   ///< after a fault, or by a closed run input after its power came back
    unknown_register,     ///< the drive lacks a register whose value is needed
    timeout_too_short,    ///< the drive's time-out is too short for the longest gap of the line
    run_input_closed,     ///< a run input is closed: the motor runs as soon as the terminals command
    not_taken,            ///< a written setting reads back with another value
    started_by_terminals, ///< a local command runs the motor; the line cannot stop it
    other_family,         ///< the drive, or the configuration, is of another family
    above_hsp,            ///< the reference is above the drive's HSP; `limit` is that
    below_lsp,            ///< the reference is below the drive's LSP, and the motor at rest; `limit` is that
    used_already,         ///< it had ended before this visit, and did nothing: `again()` begins it anew
};

/// An outcome and what was known about the drive. Who orders something looks at it.
struct [[nodiscard]] reason {
    outcome_kind kind{outcome_kind::pending};
    errc error{errc::none};
    cia402::state state{cia402::state::unknown}; ///< the last one read
    std::uint16_t fault{0};                      ///< LFT, where it was read; 0 otherwise
    bool is_other_stop{false};                   ///< another stop than the one ordered: see stop.hpp
    std::uint16_t limit{0};                      ///< HSP or LSP that refused or limits a reference: 0.1 Hz

    friend constexpr bool operator==(reason const&, reason const&) noexcept = default;
};

/// An outcome in words.
[[nodiscard]] constexpr literal name_of(outcome_kind kind) noexcept
{
    switch (kind) {
    case outcome_kind::pending: return "not ended";
    case outcome_kind::succeeded: return "done";
    case outcome_kind::executed_unconfirmed: return "executed, not confirmed";
    case outcome_kind::refused: return "refused by the drive";
    case outcome_kind::no_place: return "the client has no place for one more drive";
    case outcome_kind::silent: return "no response";
    case outcome_kind::state_timeout: return "the drive did not follow in time: look at its state and its ramp";
    case outcome_kind::fell_back:
        return "the drive fell back by itself, or by another master: look at its power and its terminals";
    case outcome_kind::stop_key: return "the drive's STOP key was pressed: look who is at the drive";
    case outcome_kind::aborted:
        return "given up before it was done: look at the line, the drive's state and the time limit";
    case outcome_kind::unconfirmed: return "told to stop, not seen to stand";
    case outcome_kind::in_fault: return "the drive is in fault";
    case outcome_kind::local_control: return "the drive is in local control";
    case outcome_kind::reference_limited: return "the reference is outside the drive's limits";
    case outcome_kind::refused_while_running: return "only possible while the motor is stopped";
    case outcome_kind::misconfigured: return "the drive's scanner holds other words";
    case outcome_kind::halted: return "the drive is halted";
    case outcome_kind::overwritten: return "another master commands the drive, or it lost its power";
    case outcome_kind::overruled: return "a stop, a fault or another set-up came later";
    case outcome_kind::contradictory: return "a negative reference and reverse at once";
    case outcome_kind::unchecked: return "the drive was not checked";
    case outcome_kind::unsupervised: return "the drive does not watch its link";
    case outcome_kind::runs_on_without_link: return "the drive runs on when its link is lost";
    case outcome_kind::other_channel: return "another channel commands the drive";
    case outcome_kind::not_drive_profile: return "single bits of the control word run the drive";
    case outcome_kind::restarts_by_itself: return "the drive restarts by itself";
    case outcome_kind::unknown_register: return "the drive does not have a register that has to be known";
    case outcome_kind::timeout_too_short: return "the drive's time-out is too short for the line";
    case outcome_kind::run_input_closed: return "a run input is closed";
    case outcome_kind::not_taken: return "a setting reads back otherwise";
    case outcome_kind::started_by_terminals: return "the terminals run the motor";
    case outcome_kind::other_family: return "the drive is of another family";
    case outcome_kind::above_hsp: return "the reference is above the drive's highest frequency, HSP";
    case outcome_kind::below_lsp: return "the reference is below the drive's lowest frequency, LSP";
    case outcome_kind::used_already: return "used already: begin it anew with again()";
    }
    return "unknown";
}

/// The same, for what shows any value.
[[nodiscard]] constexpr literal text_of(outcome_kind kind) noexcept { return name_of(kind); }

/// What a fault is called that has the same LFT on every drive here; empty for others, whose names depend on the drive:
/// `text_of(atv320::fault_code{why.fault})`.
[[nodiscard]] constexpr literal common_fault(std::uint16_t lft) noexcept
{
    switch (lft) {
    case 5: return "SLF: nobody asked the drive for longer than its time-out";
    case 9: return "OCF: overcurrent";
    case 16: return "OHF: drive overheated";
    case 17: return "OLF: motor overloaded";
    case 18: return "ObF: DC bus overvoltage";
    case 19: return "OSF: mains overvoltage";
    case 21: return "PHF: mains phase lost";
    case 23: return "SCF: motor short circuit";
    case 25: return "tnF: tuning failed";
    default: return "";
    }
}

/// All of a reason, as far as it is known: "the drive is in fault, LFT 9 (OCF: overcurrent), state fault; reset_fault resets it
/// once its cause is gone".
[[nodiscard]] constexpr auto text_of(reason const& why) noexcept
{
    constexpr std::size_t longest = 320;
    detail::short_text<longest> text;
    if (why.kind == outcome_kind::in_fault) {
        text.precede("; reset_fault resets it once its cause is gone");
    }
    if (why.is_other_stop) {
        text.precede(", another stop than the one ordered");
    }
    if (why.state != cia402::state::unknown) {
        text.precede(cia402::name_of(why.state));
        text.precede(", state ");
    }
    if (why.fault != 0) {
        if (literal const called = common_fault(why.fault); called.size() != 0) {
            text.precede(')');
            text.precede(called);
            text.precede(" (");
        }
        detail::precede_by_number(text, std::uint32_t{why.fault});
        text.precede(", LFT ");
    }
    if (why.kind == outcome_kind::silent and why.error == errc::timed_out) {
        text.precede(" in time");
    } else if (why.error != errc::none) {
        std::string_view const error = name(why.error);
        text.precede(error.data(), error.size());
        text.precede(": ");
    }
    if (why.limit != 0) {
        text.precede(" Hz");
        detail::precede_by_number(text, std::uint32_t{why.limit}, 1);
        text.precede(": ");
    }
    text.precede(name_of(why.kind));
    return text;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

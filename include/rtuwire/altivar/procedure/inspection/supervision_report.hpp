// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a check of a drive finds, and which findings its user accepts; and the rule for the drive's time-out, against the
// longest time that a line may leave it without a request.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/inspection/reference_limits.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How many longest gaps a drive's time-out has to cover: one lost exchange and its repetition still fit.
/// Internal.
inline constexpr std::uint32_t gaps_in_a_timeout = 3;

/// A drive's time-out, and the longest gap between two requests to it that its line can cause.
/// Internal.
struct period_rule {
    duration timeout{}; ///< 0: it has none, or none is known
    duration longest_gap{};

    /// Whether the requests are frequent enough: the time-out is at least three times the gap. This is also true for a
    /// drive without a time-out, which does not make that drive safe.
    [[nodiscard]] constexpr bool holds() const noexcept
    {
        // Three times the gap may be too long for a duration.
        std::uint32_t const all = timeout.microseconds, gap = longest_gap.microseconds;
        return all == 0 or (gap <= all and gap <= (all - gap) / 2U);
    }

    /// The shortest time-out that this line allows.
    [[nodiscard]] constexpr duration shortest_timeout() const noexcept { return longest_gap * gaps_in_a_timeout; }

    /// The longest period at which requests may go to a drive with this time-out; 0 where it has none.
    [[nodiscard]] constexpr duration longest_period() const noexcept
    {
        static_assert(gaps_in_a_timeout == 3);
        return detail::third_of(timeout);
    }

    friend constexpr bool operator==(period_rule const&, period_rule const&) noexcept = default;
};

/// The longest gap of a line where `count` conversations take turns and one unit does not answer. `exchange` is the
/// length of one exchange, request, response and silences included; `silent_unit` is what the unit costs, the response
/// time-out with all repetitions.
[[nodiscard]] constexpr duration longest_gap_of(std::uint32_t count, duration exchange, duration silent_unit) noexcept
{
    return exchange * count + silent_unit;
}

/// Findings that the user accepts; in a report, those that were found and accepted.
/// Internal.
struct supervision_risks {
    bool accept_unsupervised{false};      ///< SLL 0, TTO 0 or NTO: it runs on for ever without its line
    bool accept_running_on{false};        ///< SLL 4 or 5: it does the same, at some speed
    bool accept_other_channel{false};     ///< command or reference come from elsewhere
    bool accept_automatic_restart{false}; ///< ATR
    bool accept_closed_run_input{false};  ///< of a drive whose terminals command after power-up
    bool accept_unknown_registers{false}; ///< exception 02, or a value without a description
    bool accept_short_timeout{false};     ///< it may trip although the line is good

    friend constexpr bool operator==(supervision_risks const&, supervision_risks const&) noexcept = default;
};

/// Which risk a finding belongs to.
/// Internal.
struct named_risk {
    outcome_kind found;
    bool supervision_risks::*risk;
};

/// All that can be accepted. A control word of single bits (`not_drive_profile`) cannot: no command has its usual
/// meaning there.
/// Internal.
inline constexpr named_risk named_risks[]{
    {outcome_kind::unsupervised, &supervision_risks::accept_unsupervised},
    {outcome_kind::runs_on_without_link, &supervision_risks::accept_running_on},
    {outcome_kind::other_channel, &supervision_risks::accept_other_channel},
    {outcome_kind::local_control, &supervision_risks::accept_other_channel},
    {outcome_kind::restarts_by_itself, &supervision_risks::accept_automatic_restart},
    {outcome_kind::run_input_closed, &supervision_risks::accept_closed_run_input},
    {outcome_kind::unknown_register, &supervision_risks::accept_unknown_registers},
    {outcome_kind::timeout_too_short, &supervision_risks::accept_short_timeout},
};

/// What a drive is checked against.
struct supervision_options {
    supervision_risks risks{};
    /// The longest time without a request that the line may cause (`longest_gap_of`); 0: not checked.
    duration longest_gap{};
    /// Logic inputs that command run in two-wire control: LI1 forward, LI2 reverse. The others may be closed.
    std::uint16_t run_inputs{0x0003};
    /// What becomes of a reference that the drive's limits do not allow.
    beyond_limits beyond{beyond_limits::refuse};
};

/// What was found. It holds until a setting of the drive changes, or an unsaved one is lost with its power.
struct supervision_report {
    outcome_kind finding{
        outcome_kind::unchecked};              ///< `succeeded` where the drive may be ordered, accepted risks included
    period_rule period{};                      ///< the time-out that was read, 0 for none, and the line's gap
    std::uint16_t address{0};                  ///< the register that was refused, or accepted last; 0: none
    std::uint16_t word{0};                     ///< its value; 0 where the drive lacks it
    word_meaning words{word_meaning::unknown}; ///< of the drive profile: CHCF is not IO, DOTD is the ramp
    bool has_local_input{false};               ///< FLO: an input can take the command away
    reference_limits limits{};                 ///< as far as they were read
    supervision_risks accepted{};              ///< those that were found and accepted
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

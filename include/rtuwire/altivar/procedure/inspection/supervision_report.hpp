// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a check of a drive finds, and which findings its user accepts.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/inspection/period_rule.hpp>
#include <rtuwire/altivar/procedure/inspection/reference_limits.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Checks that a drive stands and that nothing commands it, before each single write of a restore.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/restoring/restore_agenda.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides the check, word by word. A drive in fault stands, too; a write that needs more care then needs the whole check
/// of `at_rest_procedure`, which ends this one as it ends.
///
/// | read of  | answer            | next                             |
/// |----------|-------------------|----------------------------------|
/// | ETA      | 2, 3, 4, 8        | read CMD                         |
/// |          | 5, 6, 7           | end: refused_while_running       |
/// |          | 1, or no state    | end: aborted                     |
/// | CMD      | 0                 | read RFR                         |
/// |          | other             | end: overwritten                 |
/// | RFR      | 0                 | end: succeeded; or at_rest       |
/// |          | other             | end: refused_while_running       |
/// | anything | no response       | end: silent                      |
/// |          | refused otherwise | end: refused                     |
///
/// A command of 0006 moves nothing either, but it is somebody's: a drive that another master holds ready is not restored.
class write_guard : public procedure {
public:
    constexpr write_guard(drive_layout const& layout, terminal_options const& options) noexcept
        : procedure{layout}, rest_{layout, options}, options_{options}
    {}

    /// Starts a check.
    constexpr action begin(write_care care) noexcept
    {
        *this = write_guard{layout(), options_};
        rest_ = at_rest_procedure{layout(), options_, {.ends_three_wire = care == write_care::all_inputs}};
        care_ = care;
        return to_read(layout().eta);
    }

    constexpr action step(event what) noexcept
    {
        if (asked_ == asked::rest) {
            action const next = run_inside(rest_, what);
            return what_of(next) == action_kind::end and reason().kind == outcome_kind::pending
                       ? end(outcome_kind::succeeded)
                       : next;
        }
        if (what.what() == event::kind::word_read) {
            return judge(what.word());
        }
        return what.what() == event::kind::failed ? end(what.error()) : end(outcome_kind::aborted);
    }

private:
    enum class asked : std::uint8_t { status, command, speed, rest };

    constexpr action judge(std::uint16_t word) noexcept
    {
        switch (asked_) {
        case asked::status: return judge_state(note(word));
        case asked::command:
            asked_ = asked::speed;
            return word == 0 ? to_read(layout().rfr) : end(outcome_kind::overwritten);
        case asked::speed:
        case asked::rest: break;
        }
        if (word != 0) {
            return end(outcome_kind::refused_while_running);
        }
        if (care_ == write_care::rest) {
            return end(outcome_kind::succeeded);
        }
        asked_ = asked::rest;
        return rest_.step({event::kind::begun});
    }

    constexpr action judge_state(cia402::state at) noexcept
    {
        if (stands(at) or at == cia402::state::fault) {
            asked_ = asked::command;
            return to_read(layout().cmd);
        }
        bool const may_turn = cia402::has_power(at) or at == cia402::state::fault_reaction_active;
        return end(may_turn ? outcome_kind::refused_while_running : outcome_kind::aborted);
    }

    at_rest_procedure rest_;
    terminal_options options_;
    asked asked_{asked::status};
    write_care care_{write_care::rest};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

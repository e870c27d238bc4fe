// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The last look at a drive at rest that was given to its terminals, or may have been: a motor that they started
// meanwhile loses its power, and is reported. However such a set-up ends, it ends with this look.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides the look, word by word. It begins with the outcome that the set-up has until now ("so").
///
/// | stage         | word read                      | confirmed | no response, or refused | limit over   |
/// |---------------|--------------------------------|-----------|-------------------------|--------------|
/// | looking       | 2, 3, 4: end: so               |           | cut: so                 | cut: so      |
/// |               | 5, 6: cut: started             |           |                         |              |
/// |               | 7, 8: read LFT                 |           |                         |              |
/// |               | 1: end: not known              |           |                         |              |
/// |               | no state: cut: not known       |           |                         |              |
/// | reading_fault | after 8: end: in_fault         |           | the same                | the same     |
/// |               | after 7: cut: in_fault         |           |                         |              |
/// | cutting       |                                | end: it   | end: it                 | write again  |
///
/// "Cut" writes the word that takes the motor's power away. A look that fails cuts, too: where the motor stands, that
/// changes nothing. A motor that this client ordered to run meanwhile is left alone, and that ends as `overruled`.
/// "Started" is `started_by_terminals`; "not known" is `aborted` instead of `succeeded`.
class last_look : public procedure {
public:
    /// The control word takes the motor's power away.
    constexpr last_look(drive_layout const& layout, std::uint16_t word) noexcept : procedure{layout}, word_{word} {}

    constexpr action begin(altivar::reason const& so, cia402::state seen) noexcept
    {
        so_ = so;
        note_state(seen);
        // A lost unit gets no read until its drive has stopped by itself, but it may get a word that stops.
        return so.error == errc::unit_lost ? cut() : look();
    }

    /// Of a motor that was just read to run.
    constexpr action begin_cut(cia402::state seen) noexcept
    {
        note_state(seen);
        so_.kind = outcome_kind::started_by_terminals;
        so_.error = errc::none;
        return cut();
    }

    constexpr action step(event what) noexcept
    {
        switch (stage_) {
        case stage::looking: return what.what() == event::kind::word_read ? judge(status_in(what)) : go_without(what);
        case stage::reading_fault: return trip(what.what() == event::kind::word_read ? what.word() : std::uint16_t{0});
        case stage::cutting: break;
        }
        if (what.what() == event::kind::late) {
            return cut();
        }
        so_.error = so_.error == errc::none ? what.error() : so_.error;
        return end_as(so_);
    }

    /// Whether the word that takes the power away was given.
    [[nodiscard]] constexpr bool is_cutting() const noexcept { return stage_ == stage::cutting; }

    /// The status that was read; 0 if none was.
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return status_; }

private:
    enum class stage : std::uint8_t { looking, reading_fault, cutting };

    constexpr action judge(std::uint16_t status) noexcept
    {
        status_ = status;
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            stage_ = stage::reading_fault;
            return to_read(layout().lft);
        }
        if (cia402::has_power(at)) {
            return begin_cut(at);
        }
        if (not stands(at) and so_.kind == outcome_kind::succeeded) {
            so_.kind = outcome_kind::aborted;
        }
        return at == cia402::state::unknown ? cut() : end_as(so_);
    }

    /// The look failed, or has no time any more.
    constexpr action go_without(event what) noexcept
    {
        if (so_.kind == outcome_kind::succeeded) {
            bool const is_late = what.what() == event::kind::late;
            so_.kind = is_late ? outcome_kind::aborted : kind_for(what.error());
            so_.error = what.error();
        }
        return cut();
    }

    /// The motor may still turn in a fault reaction.
    constexpr action trip(std::uint16_t code) noexcept
    {
        so_.fault = code;
        bool const may_turn = reason().state == cia402::state::fault_reaction_active;
        so_.kind = outcome_kind::in_fault;
        return may_turn ? cut() : end_as(so_);
    }

    constexpr action cut() noexcept
    {
        stage_ = stage::cutting;
        return to_stop(layout().cmd, word_);
    }

    altivar::reason so_{};
    std::uint16_t word_;
    std::uint16_t status_{0};
    stage stage_{stage::looking};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Clears a fault: bit 7 low, high, and low again, because only its rising edge counts. A drive without a fault is
// not written to.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides a reset, word by word. "Undo" writes 0000, and then ends so: bit 7 is not left high.
///
/// | stage         | word read     | confirmed  | no response  | refused       | limit over          |
/// |---------------|---------------|------------|--------------|---------------|---------------------|
/// | looking       | a status      |            | end: silent  | end: refused  | end: aborted        |
/// | looking_again | a status      |            | end: silent  | end: refused  | end: aborted        |
/// | low           |               | write 0080 | end: silent  | end: refused  | read LFT            |
/// | high          |               | write 0000 | undo: silent | undo: refused | read LFT            |
/// | low_again     |               | read ETA   | undo: silent | undo: refused | undo: state_timeout |
/// | undoing       |               | end: so    | end: so      | end: so       | write again         |
/// | checking      | a status      |            | end: silent  | end: refused  | end: state_timeout  |
/// | reading_fault | end: in_fault |            | end: silent  | end: refused  |                     |
///
/// | status         | looking        | looking_again  | checking       |
/// |----------------|----------------|----------------|----------------|
/// | 1 to 6         | read ETA       | end: succeeded | end: succeeded |
/// | another        |                | wait           |                |
/// | 7, or no state | wait           | wait           | wait           |
/// | 8 fault        | write 0000     | write 0000     | wait           |
///
/// A wait ends with another read of ETA, as looking. ETA is read with its neighbour, and alone where that showed no fault: no
/// late answer to one of both is taken for that to the other. Where the state read last is 7 or 8, and no older than the reset, the limit has
/// LFT read. Where 0080 was not sent because the unit was lost or has no place, there is nothing to undo.
/// Internal.
class reset_procedure : public procedure {
public:
    explicit constexpr reset_procedure(drive_layout const& layout) noexcept : procedure{layout} {}

    [[nodiscard]] constexpr reset_procedure anew() const noexcept { return reset_procedure{layout()}; }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun:
        case event::kind::pause_over: return look_first();
        case event::kind::word_read: return on_response(what);
        case event::kind::written: return after_write();
        case event::kind::failed: return go_without(what.error());
        case event::kind::late: break;
        }
        return end_late();
    }

private:
    enum class stage : std::uint8_t { looking, looking_again, low, high, low_again, undoing, checking, reading_fault };

    constexpr action on_response(event what) noexcept
    {
        return stage_ == stage::reading_fault
                   ? end_in_fault(what.word())
                   : judge_status(stage_ == stage::looking_again ? what.word() : status_in(what));
    }

    constexpr action judge_status(std::uint16_t status) noexcept
    {
        cia402::state const before = reason().state, at = note(status);
        is_looked_at_ = true;
        if (at == cia402::state::fault and stage_ != stage::checking) {
            return send_command(stage::low, 0);
        }
        if (cia402::is_in_fault(at) or at == cia402::state::unknown) {
            return to_pause(status_period);
        }
        if (stage_ == stage::looking) {
            return look_again();
        }
        return stage_ == stage::checking or at == before ? end(outcome_kind::succeeded) : to_pause(status_period);
    }

    constexpr action look_first() noexcept
    {
        stage_ = stage_ == stage::looking_again ? stage::looking : stage_;
        return look();
    }

    /// What was read may be older than this reset: a late answer to another look, or to a `watch`.
    constexpr action look_again() noexcept
    {
        stage_ = stage::looking_again;
        return to_read(layout().eta);
    }

    constexpr action send_command(stage next, std::uint16_t word) noexcept
    {
        stage_ = next;
        return to_reset(layout().cmd, word);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::low) {
            return send_command(stage::high, detail::fault_reset_bit);
        }
        if (stage_ == stage::high) {
            return send_command(stage::low_again, 0);
        }
        if (stage_ == stage::undoing) {
            return end(reason().kind);
        }
        stage_ = stage::checking;
        is_looked_at_ = false;
        return look();
    }

    constexpr action go_without(errc error) noexcept
    {
        bool const was_sent = error != errc::unit_lost and error != errc::too_many_ordered;
        bool const may_be_high = stage_ == stage::low_again or (stage_ == stage::high and was_sent);
        return may_be_high ? undo(kind_for(error), error) : end(error);
    }

    /// Ends, but not with bit 7 high. 0000 also stops, so it needs no place and passes by a loss. The first outcome counts.
    constexpr action undo(outcome_kind kind, errc error = errc::none) noexcept
    {
        static_cast<void>(end(kind, error));
        stage_ = stage::undoing;
        return to_stop(layout().cmd, 0);
    }

    /// The limit is over. Only a drive that was read in fault since the reset ends it so; its LFT is read for that.
    constexpr action end_late() noexcept
    {
        if (stage_ == stage::low_again or stage_ == stage::undoing) {
            return undo(outcome_kind::state_timeout);
        }
        if (not is_looked_at_ or not cia402::is_in_fault(reason().state)) {
            return end(stage_ <= stage::looking_again ? outcome_kind::aborted : outcome_kind::state_timeout);
        }
        stage_ = stage::reading_fault;
        return to_read(layout().lft);
    }

    stage stage_{stage::looking};
    bool is_looked_at_{false}; ///< a status was read; after the reset: since the reset
};

/// Clears a fault whose cause is gone. Where it is not, the outcome is `in_fault` with its LFT. `aborted`: the limit was
/// over before the drive showed a state; nothing was written. `state_timeout`: it was over after the reset was sent, and
/// before the drive showed a state.
class reset_fault : public procedure_runner<reset_procedure> {
public:
    /// Resets the fault of this drive, within the limit.
    template <device_type Device>
    explicit constexpr reset_fault(station<Device> const& its_drive, duration its_limit = milliseconds(2'000)) noexcept
        : procedure_runner{its_drive.unit(), its_limit, drive_check<Device>::layout}
    {}
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

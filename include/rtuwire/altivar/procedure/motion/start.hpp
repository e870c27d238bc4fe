// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Starts a drive. It checks first that the drive would stop by itself: see check_supervision. Then it reads ETA and
// writes CMD, again and again until operation is enabled. The link may be lost for good between any two frames.
// Whichever frames arrived, the motor turns neither in a direction nor faster than was ordered before or is ordered
// now: the reference, whose sign is the direction, is sent in one write before the command that enables. That command
// is sent only to a drive whose reference and control word are still the ones written last, and "done" is said only of
// one that holds them in operation. A drive that falls back on the way, for example because STOP was pressed, is not
// enabled again; the commands sent are withdrawn.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/motion/order_procedure.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/cia402/next_command.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Where a start is; in a word, which small processors reach where they do not reach a byte.
/// Internal.
enum class start_stage : std::uint32_t {
    meeting,   ///< the first status read
    examining, ///< the check whether it may be ordered
    enabling,
    reading_direction, ///< of a drive that already runs
    comparing,         ///< with the reference of a drive that already runs
    redirecting,       ///< the reference of a drive that already runs is written
    writing_reference, ///< the reference is written
    reading_reference, ///< and read back, where it is no neighbour of the control word
    checking,          ///< the control word is read back, and with it a reference that is its neighbour
    examining_profile, ///< CHCF: the command to run was sent, which runs in the I/O profile whatever was forgotten
    enabled,           ///< the command to run was sent
    reading_highest,   ///< of a drive that limits the reference
    reading_lowest,
    reading_fault,
    aborting,
};

/// The commands that a start has sent, and how often a request was not answered since.
/// Internal.
class sent_commands {
public:
    constexpr sent_commands() noexcept {} // not defaulted: GCC would first set all to 0 by a call of memset

    constexpr void note(cia402::command sent) noexcept
    {
        last_ = sent;
        is_taken_ = false;
        is_any_ = true;
        may_run_ = may_run_ or sent == cia402::command::enable_operation;
        explained_ = explained_ < rank_by(sent) ? rank_by(sent) : explained_;
    }
    /// The drive answered, and confirmed the command.
    constexpr void note_response() noexcept { misses_ = 0; }
    constexpr void note_taken() noexcept { is_taken_ = true; }
    /// A command that was not answered may have to be sent again.
    constexpr void forget_unless_taken() noexcept { last_ = is_taken_ ? last_ : cia402::command::none; }

    /// A request failed: whether the start has to end. A drive that may already run has to be stopped soon.
    constexpr bool must_end(errc error) noexcept
    {
        ++misses_;
        bool const is_final = is_exception(error) or error == errc::unit_lost or error == errc::too_many_ordered;
        return is_final or not is_any_ or misses_ > (may_run_ ? 1U : 3U);
    }

    [[nodiscard]] constexpr cia402::command last() const noexcept { return last_; }
    [[nodiscard]] constexpr bool is_any() const noexcept { return is_any_; }
    /// The command to run was sent, answered or not.
    [[nodiscard]] constexpr bool may_run() const noexcept { return may_run_; }
    /// The rank of the highest state to which these commands, or the drive itself, can have led.
    [[nodiscard]] constexpr int explained() const noexcept { return explained_; }

private:
    static constexpr int rank_by(cia402::command sent) noexcept
    {
        return detail::enable_rank(sent == cia402::command::enable_operation ? cia402::state::operation_enabled
                                   : sent == cia402::command::switch_on      ? cia402::state::switched_on
                                                                             : cia402::state::ready_to_switch_on);
    }

    int explained_{detail::enable_rank(cia402::state::switch_on_disabled)};
    cia402::command last_{cia402::command::none};
    bool is_any_{false};
    bool is_taken_{false};
    bool may_run_{false};
    std::uint32_t misses_{0};
};

/// Decides a start, word by word. "Undo" withdraws the commands, by 0000 where the motor cannot turn yet and on the
/// ramp where it may, and then ends so. Before the first command, "undo" and "read ETA" end it at once.
///
/// | stage             | word read                 | confirmed  | no response | refused       | limit over          |
/// |-------------------|---------------------------|------------|-------------|---------------|---------------------|
/// | meeting           | a status                  |            | end: silent | end: refused  | end: aborted        |
/// | examining         | the check; then a status  |            | as in a     | as in a check | end: aborted        |
/// |                   |                           |            | check       |               |                     |
/// | enabling          | a status                  | read ETA   | read ETA    | undo: refused | undo: state_timeout |
/// | reading_direction | runs: write the reference |            | read ETA    | undo: refused | undo: state_timeout |
/// |                   | so, but above HSP: read   |            |             |               |                     |
/// |                   | its reference             |            |             |               |                     |
/// |                   | another: overwritten      |            |             |               |                     |
/// | comparing         | slower: write the         |            | read ETA    | undo: refused | undo: state_timeout |
/// |                   | reference                 |            |             |               |                     |
/// |                   | else undo: above_hsp      |            |             |               |                     |
/// | redirecting       |                           | read both  | read ETA    | undo: refused | undo: state_timeout |
/// | writing_reference |                           | read both  | read ETA    | undo: refused | undo: state_timeout |
/// | reading_reference | as written: read CMD      |            | read ETA    | undo: refused | undo: state_timeout |
/// |                   | another: undo:            |            |             |               |                     |
/// |                   | overwritten               |            |             |               |                     |
/// | checking          | as ever: write 000F, or   |            | read ETA    | undo: refused | undo: state_timeout |
/// |                   | end: see "enabled"        |            |             |               |                     |
/// |                   | another: undo:            |            |             |               |                     |
/// |                   | overwritten               |            |             |               |                     |
/// | enabled           | a status                  | read CHCF  | read ETA    | undo: refused | undo: state_timeout |
/// | examining_profile | 1, 2: read ETA            |            | read ETA    | undo: refused | undo: state_timeout |
/// |                   | else undo:                |            |             |               |                     |
/// |                   | not_drive_profile         |            |             |               |                     |
/// | reading_highest   | read LSP                  |            | read ETA    | read both     | undo: state_timeout |
/// | reading_lowest    | read both                 |            | read ETA    | read both     | undo: state_timeout |
/// | reading_fault     | undo: in_fault            |            | read ETA    | undo: refused | undo: in_fault, 0   |
///
/// | status               | meeting             | enabling                 | enabled                              |
/// |----------------------|---------------------|--------------------------|--------------------------------------|
/// | 2 switch on disabled | write 0006          | undo: fell_back          | undo: fell_back                      |
/// | 3 ready to switch on | write 0007          | write 0007, then wait    | undo: fell_back                      |
/// | 4 switched on        | write 0007          | write 0007, reference    | wait                                 |
/// | 5 operation enabled  | read CMD            | read CMD                 | read both; then                      |
/// |                      |                     |                          | end: succeeded, or reference_limited |
/// |                      |                     |                          | limited, by what was not read: HSP   |
/// | 1, 6, or no state    | wait                | undo: fell_back          | undo: fell_back                      |
/// | 7, 8 fault           | read LFT            | read LFT                 | read LFT                             |
/// | in local control     | end: local_control  | undo: local_control      | undo: local_control                  |
/// | STOP key, newly      | ordered here: end:  | undo: stop_key           | undo: stop_key                       |
/// |                      | stop_key            |                          |                                      |
///
/// A fault and the key end the meeting at once, local control behind the check.
/// "Both" are the reference, then the control word; by one request where they are neighbours (CMD, LFR), which goes on
/// as "checking". CHCF is read there only where the check found the drive profile in it. 000F that could not be sent
/// for 0.5 s begins again with ETA, once. A reference without a confirmation may be that of a running motor. "As ever"
/// is the word written here last (0007, or 000F), or what was read of a drive that already runs. A state below the one
/// read last has fallen back, also below the one met before the check; one above it, and above those to which the
/// commands sent lead, ends as "another" does. Four requests in a row without a response are `silent`, and two once
/// the motor may run, counted from the first command on; before it only the first read of the meeting or of a check, where
/// it was repeated in vain.
/// Internal.
class start_procedure : public order_procedure {
    using stage = start_stage;

public:
    constexpr start_procedure(drive_layout const& layout, reference_write reference, run_direction direction,
                              supervision_procedure const& check) noexcept
        : order_procedure{layout, reference.in(direction)},
          is_contradictory_{direction == run_direction::reverse and reference.is_reverse()}, check_{check}
    {}

    /// Its check is made in its place, of these parts.
    constexpr start_procedure(drive_layout const& layout, reference_write reference, run_direction direction,
                              auto const&... of_check) noexcept
        : order_procedure{layout, reference.in(direction)},
          is_contradictory_{direction == run_direction::reverse and reference.is_reverse()}, check_{layout, of_check...}
    {}

    [[nodiscard]] constexpr start_procedure anew() const noexcept
    {
        start_procedure same{layout(), wanted(), run_direction::forward, check_.anew()}; // it has its sign already
        same.is_contradictory_ = is_contradictory_;
        return same;
    }

    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return check_.report(); }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return check_.drive_timeout(); }

    constexpr action step(event what) noexcept
    {
        if (stage_ == stage::aborting) {
            return come_to_rest(what);
        }
        if (is_contradictory_) {
            return end(outcome_kind::contradictory);
        }
        if (stage_ == stage::examining and what.what() != event::kind::late) {
            return go_on_checking(what.word(), what);
        }
        switch (what.what()) {
        case event::kind::begun: note_ordered(what.word() != 0); return to_read(layout().eta);
        case event::kind::pause_over: return read_status();
        case event::kind::word_read:
            return stage_ == stage::meeting ? meet(what) : on_response(what.word(), what.second());
        case event::kind::written: return after_write();
        case event::kind::failed: return go_on(what.error());
        case event::kind::late: break;
        }
        if (stage_ == stage::reading_fault) {
            return abort(outcome_kind::in_fault); // its code was not read
        }
        bool const was_checked = stage_ != stage::meeting and stage_ != stage::examining;
        return abort(was_checked ? outcome_kind::state_timeout : outcome_kind::aborted, check_.reason().error);
    }

private:
    constexpr reference_limits const& limits() const noexcept { return report().limits; }

    constexpr action read_status() noexcept { return once(to_read(layout().eta)); }

    /// An earlier stop by the STOP key is shown until the drive runs, so it counts only where this client had the motor
    /// running. Another press meanwhile shows nothing new: then the drive falls back, or does not follow in time.
    constexpr action meet(event what) noexcept
    {
        stage_ = stage::examining;
        last_ = cia402::decode(what.word());
        outcome_kind const found = first_look(what.word(), last_);
        if (found == outcome_kind::in_fault) {
            return judge(what.word());
        }
        if (found == outcome_kind::stop_key) {
            static_cast<void>(note(what.word()));
            return abort(found);
        }
        return go_on_checking(what.word(), {event::kind::begun});
    }

    /// Whether the motor did not turn when the drive was met; in a quick stop it is about to stand.
    constexpr bool is_at_rest() const noexcept { return last_ != cia402::state::operation_enabled; }

    /// `status` is a status word once the check has ended.
    constexpr action go_on_checking(std::uint16_t status, event what) noexcept
    {
        action const next = examine(check_, what, is_at_rest());
        if (not is_ready(check_)) {
            return what_of(next) == action_kind::end ? abort(reason().kind, reason().error) : next;
        }
        stage_ = stage::enabling;
        return judge(as_met(status));
    }

    constexpr action on_response(std::uint16_t word, std::uint16_t second) noexcept
    {
        sent_.note_response();
        switch (stage_) {
        case stage::reading_fault: note_code(word); return abort(outcome_kind::in_fault);
        case stage::reading_direction: return redirect(word);
        case stage::comparing: return slow_down(word);
        case stage::reading_reference: return check_reference(word);
        case stage::checking: return check(word, has_neighbour() ? second : told_.word);
        case stage::examining_profile: return confirm_profile(word);
        case stage::reading_highest: kept_.highest = word; return read_limit(stage::reading_lowest, layout().lsp);
        case stage::reading_lowest: kept_.lowest = word; return read_back();
        case stage::meeting:
        case stage::examining:
        case stage::enabling:
        case stage::redirecting:
        case stage::writing_reference:
        case stage::enabled:
        case stage::aborting: break;
        }
        return judge(word);
    }

    constexpr action judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            stage_ = stage::reading_fault;
            return to_read(layout().lft);
        }
        if ((status & remote_bit) == 0) {
            return abort(outcome_kind::local_control);
        }
        int const rank = detail::enable_rank(at), before = detail::enable_rank(last_);
        if (is_key_pressed(status)) {
            return abort(outcome_kind::stop_key);
        }
        if (rank < before) {
            return abort(outcome_kind::fell_back);
        }
        if (rank > before and rank > sent_.explained() and last_ != cia402::state::unknown) {
            return abort(outcome_kind::overwritten); // no word from here explains it
        }
        last_ = at;
        return at == cia402::state::operation_enabled ? run(status) : next_step(at);
    }

    constexpr action next_step(cia402::state at) noexcept
    {
        if (sent_.last() == cia402::command::enable_operation) {
            static_cast<void>(take_power()); // it accepted the command to run, and shows it later: that is no rest
            return to_pause(status_period);
        }
        bool const is_ready = at == cia402::state::switched_on;
        // The control word that is read back before enabling must be the one written here.
        cia402::command const next = is_ready and sent_.last() != cia402::command::switch_on
                                         ? cia402::command::switch_on
                                         : detail::next_command_to_enable(at);
        if (next == cia402::command::none or next == sent_.last()) {
            return to_pause(status_period);
        }
        if (not is_ready or next != cia402::command::enable_operation) {
            return send_command(next, 0);
        }
        told_.word = limits().signed_for_drive(wanted());
        return write_reference(stage::writing_reference);
    }

    [[gnu::noinline]] constexpr action write_reference(stage next) noexcept
    {
        stage_ = next;
        return once(to_enable(told_.address, told_.word));
    }

    /// Whether one request reads the control word and the reference.
    constexpr bool has_neighbour() const noexcept { return told_.address == layout().cmd + 1; }

    /// Reads the reference back, and the control word last: it shows a loss of power as well.
    [[gnu::noinline]] constexpr action read_back() noexcept
    {
        stage_ = has_neighbour() ? stage::checking : stage::reading_reference;
        return once(has_neighbour() ? to_read_two(layout().cmd) : to_read(told_.address));
    }

    constexpr action check_reference(std::uint16_t standing) noexcept
    {
        if (standing != told_.word) {
            return abort(outcome_kind::overwritten);
        }
        stage_ = stage::checking;
        return once(to_read(layout().cmd));
    }

    constexpr action send_command(cia402::command next, std::uint16_t direction) noexcept
    {
        sent_.note(next);
        control_ = static_cast<std::uint16_t>(cia402::word_of(next) | direction);
        return once(to_enable(layout().cmd, control_));
    }

    /// Checks both before enabling, and before it is done. Another value: another master wrote it, or the drive was
    /// switched off.
    constexpr action check(std::uint16_t control, std::uint16_t standing) noexcept
    {
        if (control != control_ or standing != told_.word) {
            return abort(outcome_kind::overwritten);
        }
        if (shown_ == outcome_kind::reference_limited) {
            note_limit(kept_.kept_for(told_)); // 0 where it was guessed
        }
        if (shown_ != outcome_kind::pending) {
            return end(shown_);
        }
        stage_ = stage::enabled;
        action const next = send_command(cia402::command::enable_operation, control & reverse_bit);
        // The control word that was read longer ago is read once more.
        return std::exchange(has_tried_, true) ? next : in_presence(next);
    }

    constexpr action confirm_profile(std::uint16_t profile) noexcept
    {
        stage_ = stage::enabled;
        note_meaning(is_drive_profile(profile) ? control_word() : detail::other_meaning);
        return is_drive_profile(profile) ? read_status() : abort(outcome_kind::not_drive_profile);
    }

    /// In operation: after the reference was written, or before that if the drive was already running.
    constexpr action run(std::uint16_t status) noexcept
    {
        if (stage_ != stage::enabled) {
            told_.word = wanted().keeping(status).word;
            shown_ = outcome_kind::pending;
            stage_ = stage::reading_direction;
            return once(to_read(layout().cmd));
        }
        bool const shows_limit = (status & reference_limited_bit) != 0;
        bool const is_other = shows_limit or limits().is_guessed(told_, wanted());
        shown_ = is_other ? outcome_kind::reference_limited : outcome_kind::succeeded;
        kept_ = limits();
        bool const is_known = kept_.highest != reference_limits::unread or layout().hsp == 0;
        return shows_limit and not is_known ? read_limit(stage::reading_highest, layout().hsp) : read_back();
    }

    [[gnu::noinline]] constexpr action read_limit(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return once(to_read(address));
    }

    /// Writes a new reference to a drive that runs, in one write; its direction bit stays. Where its control word is none
    /// that runs it, somebody has stopped it since its status was read.
    constexpr action redirect(std::uint16_t control) noexcept
    {
        constexpr std::uint16_t run = cia402::word_of(cia402::command::enable_operation);
        if ((control & run) != run and (control & layout().direct_control) == 0) {
            return abort(outcome_kind::overwritten);
        }
        control_ = control;
        told_.word = told_.under(control).word;
        told_.word = limits().signed_for_drive(told_);
        if (limits().judge(told_, false) == outcome_kind::succeeded) {
            return write_reference(stage::redirecting);
        }
        stage_ = stage::comparing;
        return once(to_read(told_.address));
    }

    /// The drive's reference: slowing down is never refused.
    constexpr action slow_down(std::uint16_t standing) noexcept
    {
        if (told_.is_within(standing)) {
            return write_reference(stage::redirecting);
        }
        note_limit(limits().highest);
        return abort(outcome_kind::above_hsp);
    }

    constexpr action after_write() noexcept
    {
        note_redirection();
        sent_.note_response();
        sent_.note_taken();
        if (stage_ == stage::writing_reference or stage_ == stage::redirecting) {
            return read_back();
        }
        if (stage_ == stage::enabled and report().words == word_meaning::cia402 and tells_meaning()) {
            stage_ = stage::examining_profile;
            return once(to_read(chcf()));
        }
        return read_status();
    }

    /// A request without a response may have arrived or not, and the drive may have lost its power behind it. So the start
    /// begins again, with the check where the motor does not run yet, else with a status read. A command that was confirmed is
    /// not sent again: a drive that does not follow it is read until the limit.
    constexpr action go_on(errc error) noexcept
    {
        if (is_exception(error) and (stage_ == stage::reading_highest or stage_ == stage::reading_lowest)) {
            kept_ = {}; // it goes on without
            return read_back();
        }
        if (not is_exception(error)) {
            note_redirection();
        }
        if (sent_.must_end(error)) {
            return abort(kind_for(error), error);
        }
        sent_.forget_unless_taken();
        if (not sent_.may_run() and is_at_rest()) {
            stage_ = stage::examining;
            action const next = examine_anew(check_, error);
            if (not is_ready(check_)) {
                return next;
            }
        }
        stage_ = stage::enabling;
        return read_status();
    }

    /// A motor that ran may now run by the reference from here.
    constexpr void note_redirection() noexcept
    {
        if (stage_ == stage::redirecting) {
            sent_.note(cia402::command::enable_operation);
        }
    }

    /// Ends, but withdraws the commands sent: a motor that may run stops on its ramp.
    constexpr action abort(outcome_kind kind, errc error = errc::none) noexcept
    {
        if (not sent_.is_any()) {
            return finish(kind, error);
        }
        bool const may_run = sent_.may_run() or reason().state == cia402::state::operation_enabled;
        stage_ = stage::aborting;
        return take_back(kind, error, may_run ? stop_by::ramp : stop_by::freewheel);
    }

    reference_write told_{wanted().address, wanted().word, wanted().is_speed}; ///< as this drive has to be told it
    reference_limits kept_{};                                                  ///< of a drive that limits the reference
    std::uint16_t control_{0};                                                 ///< the control word that it has to hold
    outcome_kind shown_{outcome_kind::pending}; ///< by its status, once it runs as ordered
    cia402::state last_{cia402::state::unknown};
    stage stage_{stage::meeting};
    sent_commands sent_{};
    detail::in_word<bool> has_tried_{false}; ///< the command to run was due
    detail::in_word<bool> is_contradictory_;
    supervision_procedure check_;
};

/// Starts a drive at a reference. `station`, then 1500_rpm or 50_Hz, then the direction; a negative reference is in
/// reverse, and one together with `run_direction::reverse` is refused. A reference of 0 in reverse, or for a motor that
/// turns in reverse, is sent as 0.1 Hz in reverse, so that the motor does not turn forward at LSP. It settles once
/// operation is enabled and the drive holds command and reference as they were written, else as `overwritten`, without
/// waiting for the ramp; a start that fails settles when its commands are withdrawn, up to 30 s after its limit. Where the
/// program paused so long before its last response that the drive has stopped by itself, it ends as `silent`, `unit_lost`.
/// Destroying it stops nothing: once the command to run was sent the motor runs on, until a stop or
/// its drive's own time-out, which any request restarts; before, the drive stays in the state that it was brought to.
///
/// A drive that would not stop by itself, or that another source commands, is refused before anything is written, with
/// the outcomes of `check_supervision`; `supervision()` names the register. A reference above HSP, or below LSP of a motor at
/// rest, is refused as soon as these are read, as `above_hsp` or `below_lsp`, unless the options say `beyond_limits::limit`: the
/// motor then turns at the limit, `reference_limited`, and `reason().limit` is that. docs/driving.md
/// lists the check's reads; the report of an earlier check may be given instead. Where that was none of this client, a stop coasts: see `stop`.
class start : public procedure_runner<start_procedure> {
public:
    /// Checks the drive, then starts it. `its_limit` counts from the first `advance`, the check included. A lost
    /// response costs `response_timeout` and `late_response`, 1.2 s by default, and the check anew, and 1 s more at the first
    /// read of it, which is repeated: at 19 200 bit/s 3 s last for two, or for one such.
    template <device_type Device>
    constexpr start(station<Device> const& its_drive, std::type_identity_t<reference<Device>> const& at,
                    run_direction direction = run_direction::forward, duration its_limit = milliseconds(3'000),
                    supervision_options const& its_options = {}) noexcept
        : procedure_runner{its_drive.unit(), its_limit,   drive_check<Device>::layout, at.write(),
                           direction,        its_options, at.write().is_speed}
    {}

    /// The same without the check's reads: `found` is the report of a `check_supervision` of this drive that ended as
    /// `succeeded`. It has to be as new as the drive's settings: what anyone has set since, or a power cycle has brought
    /// back, is not seen. `again()` goes by the same report, so check anew before it.
    template <device_type Device>
    constexpr start(station<Device> const& drive, std::type_identity_t<reference<Device>> const& at,
                    run_direction direction, duration limit, supervision_report const& found,
                    beyond_limits beyond = beyond_limits::refuse) noexcept
        : procedure_runner{drive.unit(), limit, drive_check<Device>::layout, at.write(), direction, found, beyond}
    {}

    /// What was found before the first order.
    [[nodiscard]] constexpr supervision_report const& supervision() const noexcept { return told().report(); }

    /// Whether the motor runs as ordered, or at the nearest limit: from the success on, until this client stops, loses or
    /// orders the unit anew, or finds that it answered nothing for longer than the drive's own time-out; or until a
    /// conversation that commands it reads a motor without power, or a fault. It needs no visit,
    /// and asks the client that it visited last, which must still be there. Unknown here: a motor that somebody else
    /// stopped, or that a `watch` saw at rest.
    [[nodiscard]] constexpr bool running() const noexcept { return has_done_its_order(); }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Direct control of an ATV28: one control word runs it, without the states of the drive profile, so there is no step
// between a motor at rest and one that turns. The reference is written and read back before that word.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/altivar/device/atv28.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/motion/order_procedure.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/cia402/next_command.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv28 {

/// Control words with bit 15, outside the states of the drive profile: those that run have bits 1 and 3 set, and so
/// have those that stop. The reference has a sign: 880A, which runs in reverse, is never sent.
/// Internal.
inline constexpr std::uint16_t direct_run = 0x800A, direct_ramp_stop = 0x900A, direct_dc_stop = 0xA00A,
                               direct_fast_stop = 0xC00A;

/// How a direct word stops the motor.
enum class direct_stop_by : std::uint8_t { ramp, dc_injection, fast_stop };

/// The layout with one of these words where `stop` has its DC injection: all three keep the power, so they are sent
/// only after a status read that found the drive running.
/// Internal.
template <std::uint16_t Word>
inline constexpr drive_layout stopping_by = [] {
    drive_layout same = device::layout;
    same.dc_injection = Word;
    return same;
}();

/// Internal.
[[nodiscard]] constexpr drive_layout const& layout_stopping_by(direct_stop_by how) noexcept
{
    switch (how) {
    case direct_stop_by::ramp: return stopping_by<direct_ramp_stop>;
    case direct_stop_by::fast_stop: return stopping_by<direct_fast_stop>;
    case direct_stop_by::dc_injection: break;
    }
    return stopping_by<direct_dc_stop>;
}

/// Stops a running drive by the ramp, the DC injection or the fast stop of its direct control. It reads the status
/// before it writes; where the read fails it becomes the ramp of the drive profile and sets `reason().is_other_stop`.
/// At standstill the drive is brought to "switch on disabled"; at its limit all three become that ramp, too. An ordinary
/// `stop` sends its word first: prefer it where time matters.
class direct_stop : public procedure_runner<ordered_stop_procedure> {
public:
    /// Stops this drive, within `limit`.
    constexpr direct_stop(station<device> const& drive, direct_stop_by how,
                          duration limit = milliseconds(30'000)) noexcept
        : procedure_runner{drive.unit(), limit, layout_stopping_by(how), stop_by::dc_injection}
    {}
};

/// Decides a direct start, word by word.
///
/// "Undo" writes 0000 until the word to run was sent, and then stops on the ramp; after that it ends so.
///
/// | stage             | word read              | confirmed     | no response  | refused       | limit over          |
/// |-------------------|------------------------|---------------|--------------|---------------|---------------------|
/// | meeting           | a status               |               | end: silent  | end: refused  | end: aborted        |
/// | examining         | the check, a status    |               | end: silent  | as in a check | end: aborted        |
/// | clearing          |                        | the reference | undo: silent | undo: refused | undo: state_timeout |
/// | writing_reference |                        | read it back  | undo: silent | undo: refused | undo: state_timeout |
/// | reading_reference | the same: read ETA     |               | undo: silent | undo: refused | undo: state_timeout |
/// |                   | else undo: not_taken   |               |              |               |                     |
/// | looking_again     | a status               |               | undo: silent | undo: refused | undo: state_timeout |
/// | reading_command   | 0000: write 800A       |               | undo: silent | undo: refused | undo: state_timeout |
/// |                   | else undo: overwritten |               |              |               |                     |
/// | running           |                        | read it back  | undo: silent | undo: refused | undo: state_timeout |
/// | confirming        | a status               |               | undo: silent | undo: refused | undo: state_timeout |
/// | reading_fault     | undo: in_fault         |               | undo: silent | undo: refused | undo: in_fault, 0   |
///
/// | status               | meeting                    | looking_again       | confirming                           |
/// |----------------------|----------------------------|---------------------|--------------------------------------|
/// | 2 switch on disabled | write 0000                 | read CMD            | wait                                 |
/// | 3, 4                 | write 0000                 | undo: overwritten   | wait                                 |
/// | 1, or no state       | end: aborted               | undo: overwritten   | undo: fell_back                      |
/// | 5 operation enabled  | end: refused_while_running | undo: overwritten   | end: succeeded, or reference_limited |
/// | 6 quick stop active  | end: refused_while_running | undo: overwritten   | undo: fell_back                      |
/// | 7, 8 fault           | read LFT                   | read LFT            | read LFT                             |
/// | in local control     | end: local_control         | undo: local_control | undo: local_control                  |
/// | STOP key, newly      | ordered here: end: stop_key | undo: stop_key     | undo: stop_key                       |
///
/// A fault and the key end the meeting at once, local control behind the check.
/// A wait ends with another read of ETA. While confirming, a state below the one read last has fallen back. In
/// looking_again, another state than 2 was commanded by somebody else. In reading_fault "undo" writes nothing unless the
/// word to run was sent. What shows a loss of power is read last before that word (CMD, 00F0 then), and first after it (the
/// reference, which goes on to confirming then): 800A runs whatever was forgotten.
/// Internal.
class direct_start_procedure : public order_procedure {
public:
    constexpr direct_start_procedure(reference_write reference, supervision_procedure const& check) noexcept
        : order_procedure{device::layout, reference}, check_{check}
    {}

    /// Its check is made in its place, of these parts.
    constexpr direct_start_procedure(reference_write reference, auto const&... of_check) noexcept
        : order_procedure{device::layout, reference}, check_{device::layout, of_check...}
    {}

    [[nodiscard]] constexpr direct_start_procedure anew() const noexcept { return {wanted(), check_.anew()}; }

    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return check_.report(); }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return check_.drive_timeout(); }

    constexpr action step(event what) noexcept
    {
        if (stage_ == stage::aborting) {
            return come_to_rest(what);
        }
        if (stage_ == stage::examining and what.what() != event::kind::late) {
            return clear_behind(examine(check_, what, true), what.word());
        }
        switch (what.what()) {
        case event::kind::begun: note_ordered(what.word() != 0); return read(stage::meeting, layout().eta);
        case event::kind::word_read: return stage_ == stage::meeting ? meet(what) : on_response(what.word());
        case event::kind::written: return after_write();
        case event::kind::pause_over: return read(stage::confirming, layout().eta);
        case event::kind::failed: return look_again_or_abort(what.error());
        case event::kind::late: break;
        }
        if (stage_ == stage::reading_fault) {
            return trip(0); // its code was not read
        }
        bool const was_checked = stage_ != stage::meeting and stage_ != stage::examining;
        return abort(was_checked ? outcome_kind::state_timeout : outcome_kind::aborted, check_.reason().error);
    }

private:
    enum class stage : std::uint8_t {
        meeting,   ///< the first status read
        examining, ///< the check whether it may be ordered
        looking,
        clearing,          ///< the control word is written 0000
        writing_reference, ///< the reference is written
        reading_reference, ///< and read back
        looking_again,
        reading_command, ///< CMD must still hold the 0000 written before
        running,
        confirming,
        reading_fault,
        aborting,
    };

    constexpr action read(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return once(to_read(address));
    }

    constexpr action write(stage next, std::uint16_t address, std::uint16_t word) noexcept
    {
        stage_ = next;
        return once(to_enable(address, word));
    }

    constexpr action meet(event what) noexcept
    {
        stage_ = stage::examining;
        cia402::state const at = note(what.word());
        outcome_kind const found = first_look(what.word(), at);
        if (found == outcome_kind::in_fault) {
            return judge(what.word());
        }
        if (cia402::has_power(at)) {
            return end_running(); // whoever stops it meanwhile
        }
        if (found == outcome_kind::stop_key) {
            return abort(found);
        }
        return clear_behind(examine(check_, {event::kind::begun}, true), what.word());
    }

    /// `status` is a status word once the check has ended.
    constexpr action clear_behind(action next, std::uint16_t status) noexcept
    {
        if (not is_ready(check_)) {
            return next;
        }
        stage_ = stage::looking;
        told_ = report().limits.signed_for_drive(wanted());
        return judge(as_met(status));
    }

    constexpr action after_write() noexcept
    {
        switch (stage_) {
        case stage::clearing: return write(stage::writing_reference, wanted().address, told_);
        case stage::writing_reference:
        case stage::running: return read(stage::reading_reference, wanted().address);
        case stage::meeting:
        case stage::examining:
        case stage::looking:
        case stage::reading_reference:
        case stage::reading_command:
        case stage::looking_again:
        case stage::confirming:
        case stage::reading_fault:
        case stage::aborting: break;
        }
        return read(stage::confirming, layout().eta);
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        switch (stage_) {
        case stage::reading_reference:
            return word == told_ ? read(may_run_ ? stage::confirming : stage::looking_again, layout().eta)
                                 : abort(outcome_kind::not_taken);
        case stage::reading_command: return word == 0 ? run() : abort(outcome_kind::overwritten);
        case stage::reading_fault: return trip(word);
        case stage::meeting:
        case stage::examining:
        case stage::looking:
        case stage::clearing:
        case stage::writing_reference:
        case stage::looking_again:
        case stage::running:
        case stage::confirming:
        case stage::aborting: break;
        }
        return judge(word);
    }

    constexpr action judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            return read(stage::reading_fault, layout().lft);
        }
        if ((status & remote_bit) == 0) {
            return abort(outcome_kind::local_control);
        }
        if (is_key_pressed(status)) {
            return abort(outcome_kind::stop_key);
        }
        if (stage_ == stage::confirming) {
            return confirm(at, status);
        }
        if (stage_ == stage::looking) {
            return stands(at) ? write(stage::clearing, layout().cmd, 0) : end_running();
        }
        if (at != cia402::state::switch_on_disabled) {
            return abort(outcome_kind::overwritten);
        }
        return read(stage::reading_command, layout().cmd);
    }

    /// CMD still held the 0000 written here: nobody commands it, and it had its power all the time.
    constexpr action run() noexcept
    {
        rank_ = detail::enable_rank(cia402::state::switch_on_disabled);
        action const next = write(stage::running, layout().cmd, direct_run);
        return std::exchange(may_run_, true) ? next : in_presence(next);
    }

    /// The word to run that could not be sent for so long that CMD may be another one: it is read once more.
    constexpr action look_again_or_abort(errc error) noexcept
    {
        bool const is_late = stage_ == stage::running and error == errc::bus_jam and not std::exchange(was_late_, true);
        return is_late ? read(stage::reading_command, layout().cmd) : abort(kind_for(error), error);
    }

    constexpr action confirm(cia402::state at, std::uint16_t status) noexcept
    {
        if (at != cia402::state::operation_enabled) {
            bool const has_fallen = detail::enable_rank(at) < rank_;
            rank_ = detail::enable_rank(at);
            if (has_fallen) {
                return abort(outcome_kind::fell_back);
            }
            static_cast<void>(take_power()); // the word to run stands: it may run at any moment
            return to_pause(status_period);
        }
        return end((status & reference_limited_bit) != 0 ? outcome_kind::reference_limited : outcome_kind::succeeded);
    }

    constexpr action trip(std::uint16_t code) noexcept
    {
        note_code(code);
        return abort(outcome_kind::in_fault);
    }

    /// Ends, but withdraws the commands sent.
    constexpr action abort(outcome_kind kind, errc error = errc::none) noexcept
    {
        bool const is_before_all = stage_ == stage::meeting or stage_ == stage::examining or stage_ == stage::looking;
        bool const has_told = not is_before_all and (stage_ != stage::reading_fault or may_run_);
        if (not has_told) {
            return finish(kind, error);
        }
        stage_ = stage::aborting;
        return take_back(kind, error, may_run_ ? stop_by::ramp : stop_by::freewheel);
    }

    std::uint16_t told_{wanted().word}; ///< as this drive has to be told it
    stage stage_{stage::meeting};
    int rank_{0}; ///< of the state that was read last, once the word to run was sent
    bool may_run_{false};
    bool was_late_{false};
    supervision_procedure check_;
};

/// Starts a drive at rest by direct control, at 50_Hz or 1500_rpm; a negative reference is in reverse, so that one
/// sign holds the direction (880A is never sent). No request is repeated: one lost frame ends the start, and the
/// commands sent are withdrawn. A drive that already runs is refused: `change_reference` is for that. The drive is
/// first checked as by a `start`.
class direct_start : public procedure_runner<direct_start_procedure> {
public:
    /// Checks this drive, and starts it within `limit`.
    constexpr direct_start(station<device> const& drive, reference<device> const& at,
                           duration limit = milliseconds(3'000), supervision_options const& options = {}) noexcept
        : procedure_runner{drive.unit(), limit, at.write(), options, at.write().is_speed}
    {}
    /// Starts it with what a `check_supervision` found before, within `limit`.
    constexpr direct_start(station<device> const& drive, reference<device> const& at, duration limit,
                           supervision_report const& found, beyond_limits beyond = beyond_limits::refuse) noexcept
        : procedure_runner{drive.unit(), limit, at.write(), found, beyond}
    {}

    /// What was found before the order.
    [[nodiscard]] constexpr supervision_report const& supervision() const noexcept { return told().report(); }

    /// Whether the motor runs as ordered, or at the nearest limit: from the success on, until this client stops, loses or
    /// orders the unit anew, or a conversation that commands it reads a motor without power, or a fault. It needs no visit,
    /// and asks the client that it visited last, which must still be there. Unknown here: a motor that somebody else
    /// stopped, or that a `watch` saw at rest.
    [[nodiscard]] constexpr bool running() const noexcept { return has_done_its_order(); }
};

} // namespace altivar::atv28
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Stops a drive, in one of the ways that it supports. None of them replaces an emergency stop: they reach
// the motor over a line that can fail.
//
// The control word that stops is sent before anything is read, and again after every status read until the state
// confirms it: neither a lost frame nor an exception ends a stop, only its limit does. Only halt and DC injection read
// the status first, because their words may start a drive that is "ready"; where that read fails or shows a motor without
// power, which may be a late answer, or the drive has no such stop, they become the ramp.
// A drive at rest is brought to "switch on disabled", where no late or foreign word can start it.
//
// No word rests on the type that its user declares: only 0000 stops all Altivars that have their control word at 8501.
// The others go there once this client has read what they mean (client/orders.hpp).
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How the motor comes to rest. Of one that the drive does not have the ramp takes the place, and the outcome says so.
enum class stop_by : std::uint8_t {
    ramp,         ///< disable operation
    freewheel,    ///< disable voltage: no torque at once, the motor coasts
    quick_stop,   ///< the fast ramp
    halt,         ///< in the way that STT sets; stays in operation enabled with the halt bit set
    dc_injection, ///< an ATV28 has it; others have halt
};

/// How a stop begins that is no freewheel, of a drive whose control words this client has not read to mean what they do in
/// the drive profile.
enum class stop_begin : std::uint8_t {
    at_once,    ///< with 0000, the motor coasts; where they were read, but long ago, as `look_first`
    look_first, ///< with one read of CHCF, 100 ms at most; then with the word asked for, or with 0000 where that fails
};

} // namespace altivar

namespace detail {

/// What a stop asks: it reads one of these, or has its word confirmed.
enum class stop_asks : std::uint8_t { status, fault, control, frequency, word };

/// How long a read may wait for its turn while no word was sent to the drive yet.
inline constexpr duration longest_wait_of_a_stop{milliseconds(1'000)};

[[nodiscard]] constexpr bool has_stop(altivar::drive_layout const& layout, altivar::stop_by mode) noexcept
{
    return not(mode == altivar::stop_by::dc_injection and layout.dc_injection == 0) and
           not(mode == altivar::stop_by::halt and layout.halt == 0);
}

/// Whether a stop reads first, and needs power for its word.
[[nodiscard]] constexpr bool is_in_place(altivar::stop_by mode) noexcept
{
    return mode == altivar::stop_by::halt or mode == altivar::stop_by::dc_injection;
}

/// The output frequency, as it was read again and again; in 0.1 Hz, without its sign.
class seen_frequency {
public:
    constexpr void note(std::uint16_t frequency) noexcept
    {
        before_ = last_;
        last_ = magnitude(frequency);
        is_compared_ = first_ != none;
        first_ = is_compared_ ? first_ : last_;
    }

    /// The first word was confirmed: what was read before tells nothing of how it is obeyed.
    constexpr void note_first_word() noexcept
    {
        first_ = none;
        is_compared_ = false;
    }

    /// Whether it was 0 at the last read; at the last two; lower than at the read before.
    [[nodiscard]] constexpr bool is_zero() const noexcept { return last_ == 0; }
    [[nodiscard]] constexpr bool stands() const noexcept { return last_ == 0 and before_ == 0; }
    [[nodiscard]] constexpr bool is_slowing() const noexcept { return before_ != none and last_ < before_; }

    /// Whether it was read at least twice since the first word, and is as high as at first.
    [[nodiscard]] constexpr bool is_as_before() const noexcept { return is_compared_ and last_ >= first_; }

private:
    static constexpr std::uint16_t none = 0xFFFF;

    static constexpr std::uint16_t magnitude(std::uint16_t frequency) noexcept
    {
        bool const is_negative = (frequency & 0x8000) != 0;
        return is_negative ? static_cast<std::uint16_t>(0U - frequency) : frequency;
    }

    std::uint16_t first_{none};
    std::uint16_t before_{none};
    std::uint16_t last_{none};
    bool is_compared_{false};
};

} // namespace detail

namespace altivar {

/// Decides a stop, word by word. Its word is that of the ramp, the quick stop or the freewheel until the motor stands,
/// then 0000; "in place" are halt and DC injection, which read first and whose word needs power.
///
/// | read of         | answer                           | next                                                       |
/// |-----------------|----------------------------------|------------------------------------------------------------|
/// | begin           |                                  | write the word; in place: read ETA                         |
/// | begin           | no such stop of the drive        | write 0007                                                 |
/// | ETA             | 1, 2                             | end: succeeded                                             |
/// |                 | 3, 4                             | write 0000; after that: wait                               |
/// |                 | 5, 6                             | look at RFR                                                |
/// |                 | 7, 8                             | read LFT                                                   |
/// |                 | no state                         | wait; in place, first look: write 0007                     |
/// |                 | in local control                 | end: local_control                                         |
/// |                 | all but 5, 6, no word sent yet   | in place: write 0007                                       |
/// | RFR             | 0 for the second time            | write 0000; halted in 5: end: succeeded                    |
/// |                 | other                            | wait; in place: read CMD or write the word in 5            |
/// | CMD             | one that runs                    | write it with the halt bit                                 |
/// |                 | other                            | write 0007                                                 |
/// | LFT             | any                              | end: in_fault                                              |
/// | a written word  | confirmed                        | read ETA                                                   |
/// | anything        | no response, or refused          | wait; in place, without a word yet: write 0007             |
/// | a wait          | over                             | write the word; in place: read ETA                         |
/// | anything        | limit over, DC injection         | write 0007, where it stands 0000; then as below            |
/// |                 | limit over, no word confirmed    | end: silent or refused; in place, no word yet: write 0007  |
/// |                 | limit over, as fast as before    | end: state_timeout                                         |
/// |                 | limit over                       | end: unconfirmed                                           |
///
/// RFR is read with ETA where it stands behind that, and LFT where it stands before it: by two registers at once, for which no
/// late answer to another question of a procedure is taken. A unit answers in its order: behind the answer to a word of this stop
/// comes none to what was asked before it, so nothing ends on what was read earlier. In local control, 1, 2, 7 and 8 count as
/// they are. To a drive that is not confirmed, each of these words is sent as
/// 0000.
/// Internal.
class stop_procedure : public procedure {
public:
    constexpr stop_procedure(drive_layout const& layout, stop_by mode) noexcept
        : procedure{layout}, ordered_{mode}, mode_{mode}
    {}

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return begin();
        case event::kind::pause_over: return detail::is_in_place(mode_) ? read_status() : stop_again();
        case event::kind::word_read: return on_response(what);
        case event::kind::written: return after_write();
        case event::kind::failed: return go_on(what.error());
        case event::kind::late: break;
        }
        // A stop that has only read until now sends the word that needs no status read; so does one whose word keeps the
        // power of a motor that stands, for nothing else would end that.
        if (has_said_ and mode_ != stop_by::dc_injection) {
            return end_unconfirmed();
        }
        has_word_ = false;
        return stop_blind();
    }

    /// Whether its word keeps the power of a motor, and would give it back where another stop has taken it away.
    [[nodiscard]] constexpr bool keeps_power() const noexcept { return has_word_ and detail::is_in_place(mode_); }

    /// Ends a stop that asks for further actions after its limit.
    constexpr action give_up() noexcept { return end_unconfirmed(); }

protected:
    /// The one that was ordered, and what has become of it.
    [[nodiscard]] constexpr stop_by ordered() const noexcept { return ordered_; }
    [[nodiscard]] constexpr stop_by mode() const noexcept { return mode_; }

    /// Of a stop that was made before its kind is known.
    constexpr void plan(stop_by mode) noexcept { mode_ = mode; }

    /// Whether the word of this stop is what was asked last, and the drive has confirmed none yet.
    [[nodiscard]] constexpr bool has_only_said_it() const noexcept { return asked_ == asked::word and not was_taken_; }

    /// Nothing could be read, or the drive has no such stop: the word that needs no status read.
    constexpr action stop_blind() noexcept
    {
        if (detail::is_in_place(mode_)) {
            note_other_stop();
            return ramp();
        }
        return stop_again();
    }

private:
    using asked = detail::stop_asks;

    constexpr action begin() noexcept
    {
        if (not detail::has_stop(layout(), mode_)) {
            return stop_blind();
        }
        return looks_first() ? read_status() : stop_again();
    }

    constexpr action ramp() noexcept
    {
        mode_ = stop_by::ramp;
        return stop_again();
    }

    /// Whether the control word of this stop is not known yet.
    constexpr bool looks_first() const noexcept { return detail::is_in_place(mode_) and not has_word_; }

    constexpr action read_status() noexcept { return ask(asked::status, look()); }

    constexpr action ask(asked what, action read) noexcept
    {
        asked_ = what;
        return looks_first() ? within(read, detail::longest_wait_of_a_stop) : read;
    }

    constexpr action stop_again() noexcept
    {
        has_said_ = true;
        asked_ = asked::word;
        return to_stop(layout().cmd, word());
    }

    constexpr action send_command(std::uint16_t word_of_this_stop) noexcept
    {
        has_word_ = true;
        word_ = word_of_this_stop;
        return stop_again();
    }

    /// The control word that stops now. A drive at rest needs no torque; only a freewheel may end a quick stop.
    constexpr std::uint16_t word() const noexcept
    {
        if (stands_) {
            return 0;
        }
        if (has_word_) {
            return word_;
        }
        if (mode_ == stop_by::freewheel) {
            return cia402::word_of(cia402::command::disable_voltage);
        }
        bool const is_quick = mode_ == stop_by::quick_stop or reason().state == cia402::state::quick_stop_active;
        return cia402::word_of(is_quick ? cia402::command::quick_stop : cia402::command::switch_on);
    }

    constexpr action on_response(event what) noexcept
    {
        switch (asked_) {
        case asked::status:
            return has_fault_before() ? judge(what.second(), what.word()) : judge(what.word(), what.second());
        case asked::fault: return end_in_fault(what.word());
        case asked::control: return halt(what.word());
        case asked::frequency:
        case asked::word: break;
        }
        return measure(what.word());
    }

    /// `neighbour` is the word that was read with it.
    constexpr action judge(std::uint16_t status, std::uint16_t neighbour) noexcept
    {
        cia402::state const at = cia402::decode(status);
        bool const is_remote = (status & remote_bit) != 0;
        bool const is_running = at == cia402::state::operation_enabled or at == cia402::state::quick_stop_active;
        if (looks_first() and not(is_running and is_remote)) { // what was read may be older than this stop
            return cia402::is_at_rest(at) ? ramp() : stop_blind();
        }
        static_cast<void>(note(status));
        is_seen_ = true;
        if (cia402::is_in_fault(at)) {
            return has_fault_before() ? end_in_fault(neighbour) : ask(asked::fault, to_read(layout().lft));
        }
        if (at == cia402::state::switch_on_disabled or at == cia402::state::not_ready_to_switch_on) {
            return end(outcome_kind::succeeded);
        }
        if (not is_remote) {
            return end(outcome_kind::local_control);
        }
        if (cia402::has_power(at)) {
            return has_frequency_behind() ? measure(neighbour) : ask(asked::frequency, to_read(layout().rfr));
        }
        return at == cia402::state::unknown ? become_ramp_and_go_on() : leave_ready();
    }

    /// The control word that runs the motor, with the halt bit; of another one the drive is being stopped already.
    constexpr action halt(std::uint16_t control) noexcept
    {
        constexpr std::uint16_t run = cia402::word_of(cia402::command::enable_operation);
        return (control & run) == run ? send_command(static_cast<std::uint16_t>(control | layout().halt))
                                      : become_ramp_and_go_on();
    }

    /// "Ready to switch on" and "switched on" have no power, but one control word may give it.
    constexpr action leave_ready() noexcept
    {
        return std::exchange(stands_, true) ? to_pause(status_period) : stop_again();
    }

    constexpr action after_write() noexcept
    {
        if (not std::exchange(was_taken_, true)) {
            frequency_.note_first_word();
        }
        is_seen_ = false;
        return read_status();
    }

    /// The output frequency in operation, or in a quick stop.
    constexpr action measure(std::uint16_t frequency) noexcept
    {
        frequency_.note(frequency);
        bool const is_operating = reason().state == cia402::state::operation_enabled;
        if (looks_first() and mode_ == stop_by::dc_injection and frequency_.is_zero()) {
            return become_ramp_and_go_on(); // the drive may remove the power now, and the injection would restore it
        }
        if (looks_first() and is_operating) {
            return mode_ == stop_by::halt ? ask(asked::control, to_read(layout().cmd))
                                          : send_command(layout().dc_injection);
        }
        if (not frequency_.stands()) {
            stands_ = false;
            // A word that keeps the power is sent again only directly after a read that found the drive running.
            bool const is_due = detail::is_in_place(mode_) and is_operating and not frequency_.is_slowing();
            return is_due ? stop_again() : to_pause(status_period);
        }
        if (mode_ == stop_by::halt and is_operating) {
            return end(outcome_kind::succeeded);
        }
        stands_ = true;
        return stop_again();
    }

    /// A read or write that failed does not end a stop. Without a response, halt and DC injection are given up: only
    /// stops that need no status read may then be sent.
    constexpr action go_on(errc error) noexcept
    {
        error_ = error;
        is_seen_ = is_seen_ and is_exception(error);
        if (detail::is_in_place(mode_) and not is_exception(error)) {
            has_word_ = false;
        }
        return become_ramp_and_go_on();
    }

    constexpr action become_ramp_and_go_on() noexcept { return looks_first() ? stop_blind() : to_pause(status_period); }

    /// The limit is over, and no standstill was read.
    constexpr action end_unconfirmed() noexcept
    {
        if (not was_taken_) {
            return end(error_ != errc::none ? error_ : errc::timed_out);
        }
        bool const obeys_not = is_seen_ and cia402::has_power(reason().state) and frequency_.is_as_before();
        return end(obeys_not ? outcome_kind::state_timeout : outcome_kind::unconfirmed, error_);
    }

    // Small processors reach bytes with short instructions only where they are near.
    stop_by ordered_;
    stop_by mode_; ///< it may have become another one than was ordered
    asked asked_{asked::status};
    errc error_{errc::none}; ///< the last one
    bool has_word_{false};
    bool has_said_{false};  ///< any control word was sent
    bool was_taken_{false}; ///< the drive confirmed a word
    bool is_seen_{false};   ///< and its state was read after that, and nothing was lost since
    bool stands_{false};
    std::uint16_t word_{0};
    detail::seen_frequency frequency_{};
};

/// Decides a stop that is ordered of a drive of which nothing but its declared type may be known.
///
/// | stage     | what happens                     | next                                                      |
/// |-----------|----------------------------------|-----------------------------------------------------------|
/// | usual     | begin, not confirmed             | write the word; in place: write 0007                      |
/// |           | exception 02 to the first word   | elsewhere: write 0000 where the other family has its word |
/// |           | any other                        | as `stop_procedure`                                       |
/// | elsewhere | confirmed, refused, no response  | end: other_family                                         |
/// |           | limit over                       | write it again                                            |
///
/// Its runner looks before it begins, where `looks_first`.
/// Internal.
class ordered_stop_procedure : public stop_procedure {
public:
    static constexpr bool is_stop = true;

    constexpr ordered_stop_procedure(drive_layout const& layout, stop_by mode,
                                     stop_begin begin = stop_begin::at_once) noexcept
        : stop_procedure{layout, mode}, begin_{begin}
    {}

    /// Whether only 0000 is known to stop the drive: in an I/O profile the words of the other stops may run it.
    [[nodiscard]] constexpr bool may_run_on_a_stop() const noexcept
    {
        return not is_known() and may_have_io_profile(layout());
    }

    /// Whether CHCF is read before it begins: where the user asked for that, or it was read before and may have changed.
    [[nodiscard]] constexpr bool looks_first(bool was_known) const noexcept
    {
        return is_doubtful() and layout().safeguards.chcf != 0 and (was_known or begin_ == stop_begin::look_first);
    }

    [[nodiscard]] constexpr ordered_stop_procedure anew() const noexcept { return {layout(), ordered(), begin_}; }

    constexpr action step(event what) noexcept
    {
        switch (stage_) {
        case stage::elsewhere:
            return what.what() == event::kind::late ? go_elsewhere() : end(outcome_kind::other_family, what.error());
        case stage::usual: break;
        }
        if (what.what() == event::kind::begun and is_doubtful()) {
            return stop_blind(); // nothing that a halt could read of the status tells what its word means
        }
        bool const has_no_such_word = what.what() == event::kind::failed and what.error() == errc::illegal_data_address;
        return has_no_such_word and has_only_said_it() and layout().other_cmd != 0 ? go_elsewhere()
                                                                                   : stop_procedure::step(what);
    }

private:
    enum class stage : std::uint8_t { usual, elsewhere };

    constexpr bool is_doubtful() const noexcept
    {
        return mode() != stop_by::freewheel and detail::has_stop(layout(), mode()) and may_run_on_a_stop();
    }

    /// No drive of the declared family is there: 0000 takes the power of one of the other, or is refused as well.
    constexpr action go_elsewhere() noexcept
    {
        stage_ = stage::elsewhere;
        if (mode() != stop_by::freewheel) {
            note_other_stop();
        }
        return once(to_stop(layout().other_cmd, 0));
    }

    stop_begin begin_;
    stage stage_{stage::usual};
};

/// Stops a drive; settles when it is in "switch on disabled", or for `halt` when the motor stands. A long ramp needs
/// a long limit. At the limit it ends as `unconfirmed` (the word was confirmed or the motor slows down),
/// `state_timeout` (confirmed, and the motor is as fast as before), `refused` or `silent` (never confirmed). A DC
/// injection, which would go on, becomes the ramp there.
///
/// A drive at 8501 (all but the ATV28) is sent 0000, "disable voltage", whatever stop was ordered, until a conversation of
/// this client has read there that its words are those of the drive profile: its motor coasts, and `reason().is_other_stop`
/// is set. A `start`, a `cyclic` and a `check_supervision` read it, so the stop of a motor that they ran is the one ordered,
/// until the unit was lost or its CHCF was written. Where the drive may have been without power since, as it was not asked for
/// 0.5 s or a request to it had no response, the stop looks first: one read of CHCF, 100 ms at most, and 0000 where that fails.
/// The reason: an ATV320 in its I/O profile runs by the words of the other stops, whatever type it was declared to be.
/// `stop_begin::look_first` looks also where nothing was read before.
///
/// `other_family`: the drive has no such control word, exception 02. 0000 was then sent once to where the other family has
/// it; it was taken where `error` is `none`. The unit then gets no request for 31 s, except a stop.
class stop : public procedure_runner<ordered_stop_procedure> {
public:
    /// `its_limit` counts from the first `advance`; a stop whose word was never sent goes on beyond it. `begin` counts for a
    /// drive that is not confirmed.
    template <device_type Device>
    explicit constexpr stop(station<Device> const& its_drive, stop_by its_mode = stop_by::ramp,
                            duration its_limit = milliseconds(30'000), stop_begin begin = stop_begin::at_once) noexcept
        : procedure_runner{its_drive.unit(), its_limit, drive_check<Device>::layout, its_mode, begin}
    {}

    /// For a stop of all, of which this is a part: where a drive of the declared type has its control word, and where one of the
    /// other family has it; whether only 0000 is known to stop it, as far as this client has read.
    [[nodiscard]] constexpr drive_layout const& layout() const noexcept { return told().layout(); }
    [[nodiscard]] constexpr bool may_run_on_a_stop() noexcept
    {
        tell_known();
        return told().may_run_on_a_stop();
    }
    using procedure_conversation::count_old_readings;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

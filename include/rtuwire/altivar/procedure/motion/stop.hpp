// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Stops a drive, in one of the ways that it supports. None of them replaces an emergency stop: they reach
// the motor over a line that can fail.
//
// The control word that stops is sent before anything is read, and again after every status read until the state
// confirms it: neither a lost frame nor an exception ends a stop, only its limit does. Only halt and DC injection read
// the status first, because their words may start a drive that is "ready"; where that read fails they become the ramp.
// A drive at rest is brought to "switch on disabled", where no late or foreign word can start it.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// How the motor comes to rest.
enum class stop_by : std::uint8_t {
    ramp,         ///< disable operation
    freewheel,    ///< disable voltage: no torque at once, the motor coasts
    quick_stop,   ///< the fast ramp
    halt,         ///< in the way that STT sets; stays in operation enabled with the halt bit set
    dc_injection, ///< ATV28 only
};

namespace detail {

/// What a stop reads.
enum class stop_read : std::uint8_t { status, fault, control, frequency };

/// How long a read may wait for its turn while no word was sent to the drive yet.
inline constexpr duration longest_wait_of_a_stop{milliseconds(1'000)};

[[nodiscard]] constexpr bool has_stop(drive_layout const& layout, stop_by mode) noexcept
{
    return not(mode == stop_by::dc_injection and layout.dc_injection == 0) and
           not(mode == stop_by::halt and layout.halt == 0);
}

/// Whether a stop reads first, and needs power for its word.
[[nodiscard]] constexpr bool is_in_place(stop_by mode) noexcept
{
    return mode == stop_by::halt or mode == stop_by::dc_injection;
}

/// Whether only 0000 is known to stop a drive: in an I/O profile the words of the other stops may run it.
[[nodiscard]] constexpr bool may_run_on_a_stop(drive_layout const& layout, word_meaning known) noexcept
{
    return known == word_meaning::unknown and layout.chcf != 0;
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

/// Decides a stop, word by word. Its word is that of the ramp, the quick stop or the freewheel until the motor stands,
/// then 0000; "in place" are halt and DC injection, which read first and whose word needs power.
///
/// | read of         | answer                           | next                                                       |
/// |-----------------|----------------------------------|------------------------------------------------------------|
/// | begin           |                                  | write the word; in place: read ETA                         |
/// | ETA             | 1, 2                             | end: succeeded                                             |
/// |                 | 3, 4                             | write 0000; after that: wait                               |
/// |                 | 5, 6                             | read RFR                                                   |
/// |                 | 7, 8                             | read LFT                                                   |
/// |                 | no state                         | wait; in place, first look: write 0007                     |
/// |                 | in local control                 | end: local_control                                         |
/// | RFR             | 0 for the second time            | write 0000; halted in 5: end: succeeded                    |
/// |                 | other                            | wait; in place: read CMD or write the word in 5            |
/// | CMD             | any                              | write it with the halt bit                                 |
/// | LFT             | any                              | end: in_fault                                              |
/// | a written word  | confirmed                        | read ETA                                                   |
/// | anything        | no response, or refused          | wait; in place, without a word yet: write 0007             |
/// | a wait          | over                             | write the word; in place: read ETA                         |
/// | anything        | limit over, no word confirmed    | end: silent or refused; in place, no word yet: write 0007  |
/// |                 | limit over, as fast as before    | end: state_timeout                                         |
/// |                 | limit over                       | end: unconfirmed                                           |
///
/// In local control, 1, 2, 7 and 8 count as they are. Of a drive that may run on the words of other stops, every stop is
/// one with the word 0000: none is in place.
/// Internal.
class stop_procedure : public procedure {
public:
    static constexpr bool is_stop = true;

    constexpr stop_procedure(drive_layout const& layout, stop_by mode, word_meaning known) noexcept
        : procedure{layout}, ordered_{mode}, mode_{mode}, known_{known}
    {}

    [[nodiscard]] constexpr stop_procedure anew() const noexcept { return {layout(), ordered_, known_}; }

    constexpr action step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return begin();
        case event::kind::pause_over: return detail::is_in_place(mode_) ? read_status() : stop_again();
        case event::kind::word_read: return on_response(what.word);
        case event::kind::written: return after_write();
        case event::kind::failed: return go_on(what.error);
        case event::kind::late: break;
        }
        // A stop that has only read until now sends the word that needs no status read.
        return has_said_ ? end_unconfirmed() : become_ramp_and_go_on();
    }

    /// Ends a stop that asks for further actions after its limit.
    constexpr action give_up() noexcept { return end_unconfirmed(); }

private:
    using asked = detail::stop_read;

    constexpr action begin() noexcept
    {
        if (not detail::has_stop(layout(), mode_)) {
            return end(outcome_kind::unsupported);
        }
        if (detail::is_in_place(mode_) and detail::may_run_on_a_stop(layout(), known_)) {
            mode_ = stop_by::ramp; // nothing that it could read tells what the halt's word means
        }
        return looks_first() ? read_status() : stop_again();
    }

    /// Whether the control word of this stop is not known yet.
    constexpr bool looks_first() const noexcept { return detail::is_in_place(mode_) and not has_word_; }

    constexpr action read_status() noexcept { return ask(asked::status, layout().eta); }

    constexpr action ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        action next = to_read(address);
        next.length = looks_first() ? detail::longest_wait_of_a_stop : duration{};
        return next;
    }

    constexpr action stop_again() noexcept
    {
        has_said_ = true;
        return to_stop(layout().cmd, word());
    }

    constexpr action send_command(std::uint16_t word_of_this_stop) noexcept
    {
        has_word_ = true;
        word_ = word_of_this_stop;
        return stop_again();
    }

    /// The control word that stops now. A drive at rest needs no torque; only a freewheel may end a quick stop.
    constexpr std::uint16_t word() noexcept
    {
        if (stands_) {
            return 0;
        }
        if (has_word_) {
            return word_;
        }
        if (mode_ == stop_by::freewheel or detail::may_run_on_a_stop(layout(), known_)) {
            if (mode_ != stop_by::freewheel) {
                note_other_stop();
            }
            return cia402::word_of(cia402::command::disable_voltage);
        }
        bool const is_quick = mode_ == stop_by::quick_stop or reason().state == cia402::state::quick_stop_active;
        return cia402::word_of(is_quick ? cia402::command::quick_stop : cia402::command::switch_on);
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        switch (asked_) {
        case asked::status: return judge(word);
        case asked::fault: return end_in_fault(word);
        case asked::control: return send_command(static_cast<std::uint16_t>(word | layout().halt));
        case asked::frequency: break;
        }
        return measure(word);
    }

    constexpr action judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        is_seen_ = true;
        if (cia402::is_in_fault(at)) {
            return ask(asked::fault, layout().lft);
        }
        if (at == cia402::state::switch_on_disabled or at == cia402::state::not_ready_to_switch_on) {
            return end(outcome_kind::succeeded);
        }
        if ((status & remote_bit) == 0) {
            return end(outcome_kind::local_control);
        }
        if (cia402::has_power(at)) {
            return ask(asked::frequency, layout().rfr);
        }
        return at == cia402::state::unknown ? become_ramp_and_go_on() : leave_ready();
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
            return mode_ == stop_by::halt ? ask(asked::control, layout().cmd) : send_command(layout().dc_injection);
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

    constexpr action become_ramp_and_go_on() noexcept
    {
        if (looks_first()) {
            mode_ = stop_by::ramp;
            note_other_stop();
            return stop_again();
        }
        return to_pause(status_period);
    }

    /// The limit is over, and no standstill was read.
    constexpr action end_unconfirmed() noexcept
    {
        if (not was_taken_) {
            return end(error_ != errc::none ? error_ : errc::timed_out);
        }
        bool const obeys_not = is_seen_ and cia402::has_power(reason().state) and frequency_.is_as_before();
        return end(obeys_not ? outcome_kind::state_timeout : outcome_kind::unconfirmed, error_);
    }

    detail::seen_frequency frequency_{};
    std::uint16_t word_{0};
    stop_by ordered_;
    stop_by mode_; ///< it may have become another one than was ordered
    word_meaning known_;
    asked asked_{asked::status};
    errc error_{errc::none}; ///< the last one
    bool has_word_{false};
    bool has_said_{false};  ///< any control word was sent
    bool was_taken_{false}; ///< the drive confirmed a word
    bool is_seen_{false};   ///< and its state was read after that, and nothing was lost since
    bool stands_{false};
};

/// Stops a drive; settles when it is in "switch on disabled", or for `halt` when the motor stands. A long ramp needs
/// a long limit. At the limit it ends as `unconfirmed` (the word was confirmed or the motor slows down),
/// `state_timeout` (confirmed, and the motor is as fast as before), `refused` or `silent` (never confirmed).
///
/// An ATV320 is sent 0000, "disable voltage", first, whatever stop was ordered, unless `known` states that its words
/// have the meanings of the drive profile (CHCF is not IO, and DOTD is the ramp): with CHCF = IO the other words would
/// run it. `reason().is_other_stop` is then set.
class stop : public procedure_runner<stop_procedure> {
public:
    /// `its_limit` counts from the first `advance`; a stop whose word was never sent goes on beyond it. `known` says what
    /// an ATV320's words mean; the others have no choice.
    template <device_type Device>
    explicit constexpr stop(station<Device> const& its_drive, stop_by its_mode = stop_by::ramp,
                            duration its_limit = milliseconds(30'000),
                            word_meaning known = word_meaning::unknown) noexcept
        : procedure_runner{its_drive.unit(), stop_procedure{drive_check<Device>::layout, its_mode, known}, its_limit}
    {}
};

} // namespace rtuwire::altivar

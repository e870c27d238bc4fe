// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Direct control of an ATV28: one word runs it, past the states of the drive profile, so there is no step between a
// motor that stands and one that turns. The reference is written and read back before it.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/altivar/order_script.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/altivar/release_link.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar::atv28 {

/// How a direct word stops the motor.
enum class direct_stop_by : std::uint8_t { ramp, dc_injection, fast_stop };

/// The drive with one of these words where `stop` has its DC injection: all three keep the power, so they go only behind
/// a look that found it running.
template <std::uint16_t Word>
inline constexpr drive_profile stopping_by = [] {
    drive_profile same = device::profile;
    same.dc_injection = Word;
    return same;
}();

[[nodiscard]] constexpr drive_profile const& profile_stopping_by(direct_stop_by how) noexcept
{
    switch (how) {
    case direct_stop_by::ramp: return stopping_by<direct_ramp_stop>;
    case direct_stop_by::fast_stop: return stopping_by<direct_fast_stop>;
    case direct_stop_by::dc_injection: break;
    }
    return stopping_by<direct_dc_stop>;
}

/// Stops a drive that runs by the ramp, the DC injection or the fast stop of its direct control. It looks before it
/// writes; where the look fails it becomes the ramp of the drive profile, `reason().is_other_stop` tells. At standstill
/// the drive is brought to "switch on disabled". An ordinary `stop` says its word first: take that where it counts.
class direct_stop : public drive_talk<stop_script> {
public:
    constexpr direct_stop(station<device> const& drive, direct_stop_by how,
                          duration limit = milliseconds(30'000)) noexcept
        : drive_talk{drive.unit(),
                     stop_script{profile_stopping_by(how), stop_by::dc_injection,
                                 word_meaning::drive_profile},
                     limit}
    {}
};

/// Decides a direct start, word by word.
class direct_start_script : public order_script {
public:
    constexpr direct_start_script(reference_write reference, supervision_script const& check) noexcept
        : order_script{device::profile, check}, reference_{reference}
    {}

    constexpr wish step(event const& what) noexcept
    {
        if (stage_ == stage::withdrawing) {
            return come_to_rest(what);
        }
        if (stage_ == stage::examining and what.what != event::kind::late) {
            return clear_behind(examine(what), what.word);
        }
        switch (what.what) {
        case event::kind::begun: return read(stage::meeting, profile().eta);
        case event::kind::word_read: return stage_ == stage::meeting ? meet(what) : heard(what.word);
        case event::kind::written: return after_write();
        case event::kind::pause_over: return read(stage::confirming, profile().eta);
        case event::kind::failed: return withdraw(ending_for(what.error), what.error);
        case event::kind::late: break;
        }
        return withdraw(ending::stuck);
    }

private:
    enum class stage : std::uint8_t {
        meeting,   ///< the first look
        examining, ///< whether it may be ordered
        looking,
        clearing,          ///< the control word is written 0000
        referring,         ///< the reference is written
        reading_reference, ///< and read back
        reading_command,   ///< the 0000 of before still has to stand
        looking_again,
        running,
        confirming,
        reading_fault,
        withdrawing,
    };

    constexpr wish read(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return once(to_read(address));
    }

    constexpr wish write(stage next, std::uint16_t address, std::uint16_t word) noexcept
    {
        stage_ = next;
        return once(to_enable(address, word));
    }

    constexpr wish meet(event const& what) noexcept
    {
        stage_ = stage::examining;
        static_cast<void>(is_key_pressed(what.word));
        return clear_behind(examine({event::kind::begun}), what.word);
    }

    /// `status` is a status word where the check has come to its end.
    constexpr wish clear_behind(wish const& next, std::uint16_t status) noexcept
    {
        if (not is_ready()) {
            return next;
        }
        stage_ = stage::looking;
        return judge(status);
    }

    constexpr wish after_write() noexcept
    {
        switch (stage_) {
        case stage::clearing: return write(stage::referring, reference_.address, reference_.word);
        case stage::referring: return read(stage::reading_reference, reference_.address);
        case stage::running:
        case stage::meeting:
        case stage::examining:
        case stage::looking:
        case stage::reading_reference:
        case stage::reading_command:
        case stage::looking_again:
        case stage::confirming:
        case stage::reading_fault:
        case stage::withdrawing: break;
        }
        return read(stage::confirming, profile().eta);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        switch (stage_) {
        case stage::reading_reference:
            return word == reference_.word ? read(stage::reading_command, profile().cmd)
                                           : withdraw(ending::not_taken);
        case stage::reading_command:
            // Another word: somebody else's, or that of a drive that was switched off and on.
            return word == 0 ? read(stage::looking_again, profile().eta) : withdraw(ending::stuck);
        case stage::reading_fault: return trip(word);
        case stage::meeting:
        case stage::examining:
        case stage::looking:
        case stage::clearing:
        case stage::referring:
        case stage::looking_again:
        case stage::running:
        case stage::confirming:
        case stage::withdrawing: break;
        }
        return judge(word);
    }

    constexpr wish judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            return read(stage::reading_fault, profile().lft);
        }
        if ((status & remote_bit) == 0) {
            return withdraw(ending::local_control);
        }
        if (stage_ == stage::confirming) {
            return confirm(at, status);
        }
        if (is_key_pressed(status)) {
            return withdraw(ending::stuck);
        }
        if (stage_ == stage::looking) {
            return cia402::has_power(at) ? end(ending::refused_while_running)
                                         : write(stage::clearing, profile().cmd, 0);
        }
        if (at != cia402::state::switch_on_disabled) {
            return withdraw(ending::stuck);
        }
        may_run_ = true;
        return write(stage::running, profile().cmd, direct_run);
    }

    constexpr wish confirm(cia402::state at, std::uint16_t status) noexcept
    {
        if (at != cia402::state::operation_enabled) {
            return to_pause(look_period);
        }
        return end((status & reference_limited_bit) != 0 ? ending::reference_limited
                                                         : ending::succeeded);
    }

    constexpr wish trip(std::uint16_t code) noexcept
    {
        note_code(code);
        return withdraw(ending::in_fault);
    }

    /// Ends, but takes back what the drive was told.
    constexpr wish withdraw(ending how, errc error = errc::none) noexcept
    {
        bool const is_before_all = stage_ == stage::meeting or stage_ == stage::examining or
                                   stage_ == stage::looking;
        bool const has_told = not is_before_all and (stage_ != stage::reading_fault or may_run_);
        if (not has_told) {
            return finish(how, error);
        }
        stage_ = stage::withdrawing;
        return take_back(how, error, may_run_ ? stop_by::ramp : stop_by::freewheel,
                         word_meaning::drive_profile);
    }

    reference_write reference_;
    stage stage_{stage::meeting};
    bool may_run_{false};
};

/// Starts a drive that stands by direct control, at 50_Hz or 1500_rpm; a negative reference is in reverse, so that one
/// sign holds the direction (880A is never sent). Nothing is asked twice: a line that loses one frame ends it, and what
/// was given is taken back. A drive that runs already is refused: `change_reference` is for that. Before all that it is
/// checked as by a `start`.
class direct_start : public drive_talk<direct_start_script> {
public:
    constexpr direct_start(station<device> const& drive, reference<device> const& at,
                           duration limit = milliseconds(3'000),
                           supervision_options const& options = {}) noexcept
        : drive_talk{
              drive.unit(),
              direct_start_script{at.write(), supervision_script{device::profile, options}},
              limit}
    {}
    constexpr direct_start(station<device> const& drive, reference<device> const& at, duration limit,
                           supervision_report const& found) noexcept
        : drive_talk{drive.unit(),
                     direct_start_script{at.write(), supervision_script{device::profile, found}},
                     limit}
    {}

    /// What was found before the order.
    [[nodiscard]] constexpr supervision_report const& supervision() const noexcept
    {
        return told().report();
    }

    /// Whether the motor runs as asked, or at the limit nearest to it.
    [[nodiscard]] constexpr bool running() const noexcept
    {
        return succeeded() or reason().how == ending::reference_limited;
    }
};

} // namespace rtuwire::altivar::atv28

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Starts a drive. It checks first that the drive would stop by itself (altivar/supervision.hpp). Then: read ETA, write
// CMD, and again until operation is enabled. Between any two of its frames the drive may be alone for ever, so whatever
// came through, the motor turns neither in a direction nor faster than was asked before or is asked now: the reference,
// which holds the direction as its sign, goes in one write before the command that enables. That command goes only to a
// drive whose control word still is the one written last. A drive that falls back on the way, say because somebody
// pressed STOP, is not pushed up again; what was given is taken back.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/altivar/order_script.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/cia402/way.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a start, word by word.
class start_script : public order_script {
public:
    constexpr start_script(drive_profile const& profile, reference_write reference, heading way,
                           supervision_script const& check) noexcept
        : order_script{profile, check},
          reference_{way == heading::reverse ? reference.reversed() : reference},
          is_contradictory_{way == heading::reverse and reference.is_reverse()}
    {}

    constexpr wish step(event const& what) noexcept
    {
        if (stage_ == stage::withdrawing) {
            return come_to_rest(what);
        }
        if (is_contradictory_) {
            return end(ending::contradictory);
        }
        if (stage_ == stage::examining and what.what != event::kind::late) {
            return climb_behind(examine(what), what.word);
        }
        switch (what.what) {
        case event::kind::begun: return to_read(profile().eta);
        case event::kind::pause_over: return look();
        case event::kind::word_read: return stage_ == stage::meeting ? meet(what) : heard(what.word);
        case event::kind::written: return after_write();
        case event::kind::failed: return go_on(what.error);
        case event::kind::late: break;
        }
        return withdraw(ending::stuck);
    }

private:
    enum class stage : std::uint8_t {
        meeting,   ///< the first look
        examining, ///< whether it may be ordered
        climbing,
        reading_direction, ///< of a drive that runs already
        redirecting,       ///< its reference is written
        referring,         ///< the reference is written
        checking,          ///< the control word is read back
        enabled,           ///< the command to run was given
        reading_fault,
        withdrawing,
    };

    constexpr wish look() noexcept { return once(to_read(profile().eta)); }

    /// Of a drive that was stopped by its key before, it is shown until it runs: what is pressed from here on counts.
    constexpr wish meet(event const& what) noexcept
    {
        stage_ = stage::examining;
        static_cast<void>(is_key_pressed(what.word));
        return climb_behind(examine({event::kind::begun}), what.word);
    }

    /// `status` is a status word where the check has come to its end.
    constexpr wish climb_behind(wish const& next, std::uint16_t status) noexcept
    {
        if (not is_ready()) {
            return next;
        }
        stage_ = stage::climbing;
        return judge(status);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        misses_ = 0;
        switch (stage_) {
        case stage::reading_fault: return trip(word);
        case stage::reading_direction: return redirect(word);
        case stage::checking: return enable(word);
        case stage::meeting:
        case stage::examining:
        case stage::climbing:
        case stage::redirecting:
        case stage::referring:
        case stage::enabled:
        case stage::withdrawing: break;
        }
        return judge(word);
    }

    constexpr wish judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            stage_ = stage::reading_fault;
            return to_read(profile().lft);
        }
        if ((status & remote_bit) == 0) {
            return withdraw(ending::local_control);
        }
        int const height = cia402::height_of(at);
        if ((has_commanded_ and height < height_) or is_key_pressed(status)) {
            return withdraw(ending::stuck);
        }
        height_ = height;
        return at == cia402::state::operation_enabled ? run(status) : climb(at);
    }

    constexpr wish climb(cia402::state at) noexcept
    {
        if (given_ == cia402::command::enable_operation) {
            return to_pause(look_period); // it took the command to run, and shows it later
        }
        bool const is_ready = at == cia402::state::switched_on;
        // The word that is read back before enabling has to be ours.
        cia402::command const next = is_ready and given_ != cia402::command::switch_on
                                         ? cia402::command::switch_on
                                         : cia402::toward_running(at);
        if (next == cia402::command::none or next == given_) {
            return to_pause(look_period);
        }
        return is_ready and next == cia402::command::enable_operation
                   ? write_reference(stage::referring, reference_)
                   : give(next, 0);
    }

    constexpr wish write_reference(stage next, reference_write what) noexcept
    {
        stage_ = next;
        return once(to_enable(what.address, what.word));
    }

    constexpr wish give(cia402::command next, std::uint16_t direction) noexcept
    {
        given_ = next;
        is_taken_ = false;
        has_commanded_ = true;
        may_run_ = may_run_ or next == cia402::command::enable_operation;
        return once(to_enable(profile().cmd, static_cast<std::uint16_t>(cia402::word_of(next) | direction)));
    }

    /// The control word before enabling: another one was written by somebody else, or the drive was switched off.
    constexpr wish enable(std::uint16_t control) noexcept
    {
        if (control != cia402::word_of(cia402::command::switch_on)) {
            return withdraw(ending::stuck);
        }
        stage_ = stage::enabled;
        return give(cia402::command::enable_operation, 0);
    }

    /// In operation: with our reference, or before it where the drive was running already.
    constexpr wish run(std::uint16_t status) noexcept
    {
        if (stage_ != stage::enabled) {
            stage_ = stage::reading_direction;
            return once(to_read(profile().cmd));
        }
        return end((status & reference_limited_bit) != 0 ? ending::reference_limited
                                                         : ending::succeeded);
    }

    /// Gives a drive that runs another reference, in one write; its direction bit stays.
    constexpr wish redirect(std::uint16_t control) noexcept
    {
        direction_ = control & reverse_bit;
        return write_reference(stage::redirecting, reference_.under(control));
    }

    constexpr wish after_write() noexcept
    {
        misses_ = 0;
        is_taken_ = true;
        if (stage_ == stage::referring) {
            stage_ = stage::checking;
            return once(to_read(profile().cmd));
        }
        if (stage_ == stage::redirecting) {
            stage_ = stage::enabled;
            return give(cia402::command::enable_operation, direction_);
        }
        return look();
    }

    constexpr wish trip(std::uint16_t code) noexcept
    {
        note_code(code);
        return withdraw(ending::in_fault);
    }

    /// What was not answered may have come through or not: the way begins anew, with a look. A word that was answered is
    /// not given again: a drive that does not follow it fell back meanwhile.
    constexpr wish go_on(errc error) noexcept
    {
        // One that may run already has to be stopped soon.
        std::uint8_t const most_misses = may_run_ ? 1 : 3;
        ++misses_;
        if (is_exception(error) or is_final(error) or not has_commanded_ or misses_ > most_misses) {
            return withdraw(ending_for(error), error);
        }
        stage_ = stage::climbing;
        given_ = is_taken_ ? given_ : cia402::command::none;
        return look();
    }

    static constexpr bool is_final(errc error) noexcept
    {
        return error == errc::unit_lost or error == errc::too_many_ordered;
    }

    /// Ends, but takes back what the drive was told: a motor that may run comes to rest on its ramp.
    constexpr wish withdraw(ending how, errc error = errc::none) noexcept
    {
        if (not has_commanded_) {
            return finish(how, error);
        }
        bool const may_run = may_run_ or reason().state == cia402::state::operation_enabled;
        stage_ = stage::withdrawing;
        return take_back(how, error, may_run ? stop_by::ramp : stop_by::freewheel, report().words);
    }

    reference_write reference_;
    std::uint16_t direction_{0};
    int height_{0};
    stage stage_{stage::meeting};
    cia402::command given_{cia402::command::none};
    std::uint8_t misses_{0};
    bool has_commanded_{false};
    bool is_taken_{false}; ///< the drive answered the command that was given
    bool may_run_{false};  ///< the command to run was given, answered or not
    bool is_contradictory_;
};

/// Starts a drive at a reference. `station`, then 1500_rpm or 50_Hz, then the direction; a negative reference is in
/// reverse, and one together with `heading::reverse` is refused. It settles once operation is enabled, without
/// waiting for the ramp; a start that fails settles when what it gave is taken back, up to 30 s behind its limit.
///
/// A drive that would not stop by itself, or that something else commands, is refused before anything is written, with the
/// endings of `check_supervision`; `supervision()` tells the register. The check takes about nine reads; who has made it
/// already gives its report instead.
class start : public drive_talk<start_script> {
public:
    template <device_type Device>
    constexpr start(station<Device> const& drive, std::type_identity_t<reference<Device>> const& at,
                    heading way = heading::forward, duration limit = milliseconds(3'000),
                    supervision_options const& options = {}) noexcept
        : drive_talk{drive.unit(),
                     start_script{Device::profile, at.write(), way,
                                  supervision_script{Device::profile, options}},
                     limit}
    {}
    template <device_type Device>
    constexpr start(station<Device> const& drive, std::type_identity_t<reference<Device>> const& at,
                    heading way, duration limit, supervision_report const& found) noexcept
        : drive_talk{drive.unit(),
                     start_script{Device::profile, at.write(), way,
                                  supervision_script{Device::profile, found}},
                     limit}
    {}

    /// What was found before the first order.
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

} // namespace rtuwire::altivar

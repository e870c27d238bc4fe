// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One request of a client, from its start to its outcome: silence before it, the octets that leave, the answer,
// repetitions, time limits. Knows no conversation. client/phase.hpp tells its states, client/quarantine.hpp how
// long a unit that did not answer in time is asked nothing new.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/client/client_state.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/client/line_end.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/quarantine.hpp>
#include <rtuwire/client/request_steps.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/answer.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a client does for its request under way; the base of `basic_client`, which says who asks.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class transaction : public request_steps<Statistics, Line, Options, Debts, Front> {
    using end_of_line = line_end<Statistics, Line, Options, Debts, Front>;
    using steps = request_steps<Statistics, Line, Options, Debts, Front>;
    using client_state::attempts_;
    using client_state::deadline_;
    using client_state::echo_;
    using client_state::is_woken_;
    using client_state::phase_;
    using client_state::trouble_;
    using end_of_line::framer;
    using end_of_line::quarantine_;
    using end_of_line::question;
    using end_of_line::statistics_;
    using phase = client_phase;
    using steps::attempt_failed;
    using steps::limit_sending;
    using steps::note_sent;
    using steps::settle;
    using steps::turn_around;
    using steps::unit;
    using steps::wait_for_silence;

public:
    using steps::steps;

    /// Takes octets that had arrived by `now`, in any chunking. Outside of waiting for an answer they
    /// are noise: dropped, but the line was not silent. An answer that is handed over before `advance` has
    /// seen the time-out is in time.
    constexpr void receive(byte_view const& octets, instant now) noexcept
    {
        if (octets.empty()) {
            return;
        }
        bool const is_start = framer().is_quiet();
        hear(octets.size(), now);
        std::size_t taken = 0;
        while (taken < octets.size() and take(octets[taken], now)) {
            ++taken;
        }
        if (taken < octets.size()) {
            this->count_stray(octets.subspan(taken), is_start and taken == 0);
            be_disturbed(now);
        }
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        hear(1, now);
        if (phase_ != phase::awaiting) {
            be_disturbed(now);
        } else if (this->may_skip()) {
            this->skip_noise();
        } else {
            framer().spoil();
        }
    }

    /// Takes note that the last stop bit of what `poll_transmit` gave has left at `at`, or will by then.
    constexpr void sent(instant at) noexcept
    {
        if (not is_leaving(phase_)) {
            framer().note_activity(at);
            return;
        }
        framer().restart(at);
        statistics_.note_asked(at);
        this->skip_left_ = options().skip_noise;
        if (unit() == 0) {
            return turn_around(at);
        }
        phase_ = phase::awaiting;
        deadline_ = at + note_sent(at);
        if (trouble_ == errc::cancelled or trouble_ == errc::echoed) {
            settle(trouble_, at);
        }
    }

    /// Lets time pass. Whether a unit may be asked again from here on.
    [[gnu::always_inline]] constexpr bool advance(instant now) noexcept
    {
        is_woken_ = false;
        framer().advance(now);
        if (phase_ == phase::awaiting) {
            take_frame(now);
        }
        if (phase_ == phase::handed_out) {
            limit_sending(now);
            phase_ = phase::transmitting;
        } else if (is_under_way(phase_) and reached(now, deadline_)) {
            time_is_over(now);
        }
        return quarantine_.advance(now);
    }

    /// Gives up what is under way, whoever asked it; its outcome is `cancelled`. A write may have taken effect
    /// all the same. What is leaving leaves whole, and a broadcast gets its turnaround; the outcome comes then.
    constexpr void cancel(instant now) noexcept
    {
        if (is_leaving(phase_) or phase_ == phase::turnaround) {
            trouble_ = errc::cancelled;
        } else if (phase_ != phase::idle and phase_ != phase::settled) {
            settle(errc::cancelled, now);
        }
    }

    /// The octets to send now, each request and repetition once; empty when there is nothing. They are the
    /// client's own, and unchanged until `sent`.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        statistics_.note(attempts_.is_first() ? line_event::request : line_event::repetition,
                         unit());
        phase_ = phase::handed_out;
        echo_.begin();
        return question();
    }

    /// When the next pass has something to do.
    constexpr void add_to(earliest& next) const noexcept
    {
        framer().add_to(next);
        quarantine_.add_to(next);
        if (is_woken_ or is_under_way(phase_)) {
            // Where it is woken, a time that has come already.
            bool const is_past = is_woken_ and phase_ == phase::waiting;
            next.add(is_past ? deadline_ - attempts_.response_timeout() : deadline_);
        }
    }

    /// Whether a question is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

protected:
    using end_of_line::options;

    /// Whether the line would let the request leave, or its outcome is there: only its asker is missing.
    constexpr bool awaits_asker() const noexcept
    {
        return phase_ == phase::settled or
               (phase_ == phase::waiting and framer().is_quiet() and not quarantine_.covers(unit()));
    }

    /// Gives up a request that waits for its asker.
    constexpr void drop(instant now) noexcept
    {
        if (phase_ == phase::waiting) {
            settle(errc::cancelled, now);
        }
    }

    constexpr client_phase phase_now() const noexcept { return phase_; }

    /// Takes a question: copies its frame to the front of the memory. Errors: `frame_too_short`,
    /// `frame_too_long`; `buffer_too_small` where the question and its answer do not fit together.
    constexpr errc start(request const& asked, instant now, patience const& with) noexcept
    {
        if (errc const wrong = this->keep(asked.frame()); wrong != errc::none) {
            return wrong;
        }
        this->may_be_stale_ = not asked.may_be_repeated();
        is_woken_ = false;
        attempts_.begin(with, asked.may_be_repeated() and unit() != 0);
        wait_for_silence(now);
        if (framer().is_quiet()) {
            get_ready(now);
        }
        return errc::none;
    }

    /// Lets the request leave.
    constexpr void get_ready(instant now) noexcept
    {
        phase_ = phase::ready;
        limit_sending(now);
    }

    /// A word that stops wants the line. What is under way is not repeated; where it may be cut, it is given up, unless
    /// its answer has begun to arrive.
    constexpr void make_way(bool may_cut, instant now) noexcept
    {
        attempts_.end_retries();
        bool const has_not_left =
            phase_ == phase::waiting or phase_ == phase::ready or phase_ == phase::pausing;
        bool const is_arriving = phase_ == phase::awaiting and not framer().is_quiet();
        if (has_not_left or (may_cut and not is_arriving)) {
            cancel(now);
        }
    }

    /// Whether the request was given up and nobody was told yet.
    constexpr bool was_cut() const noexcept
    {
        return phase_ == phase::settled and trouble_ == errc::cancelled;
    }

    /// Whether the request that ended left more than once, as far as it was not given up.
    constexpr bool was_repeated() const noexcept
    {
        return not attempts_.is_first() and trouble_ != errc::cancelled;
    }

    /// How it ended for its unit: one that left is not answered, also where it was given up before.
    constexpr errc heard_of_unit() const noexcept
    {
        return trouble_ == errc::cancelled and attempts_.unanswered() != 0 ? errc::timed_out : trouble_;
    }

    /// Ends what is settled.
    [[gnu::always_inline]] constexpr result<response> take_outcome() noexcept
    {
        phase_ = phase::idle;
        return trouble_ != errc::none ? result<response>{trouble_}
                                      : response{unit() == 0 ? byte_view{} : framer().frame().pdu()};
    }

    /// The next pass has something to do at once.
    [[gnu::always_inline]] constexpr void wake(instant now) noexcept
    {
        is_woken_ = true;
        if (not is_under_way(phase_)) {
            deadline_ = now;
        }
    }

private:
    /// Octets arrived by `now`: what the silence before them ended is taken first. Once for both ways of arriving,
    /// 32 bytes less on a Cortex-M0+.
    [[gnu::noinline]] constexpr void hear(std::size_t octets, instant now) noexcept
    {
        if (framer().hear(octets, now) and phase_ == phase::awaiting) {
            take_frame(now);
        }
    }

    /// Takes an octet of an echo, of an answer or before it; false where none is expected. Inlined, because it is done
    /// for each octet.
    [[gnu::always_inline]] constexpr bool take(std::byte octet, instant now) noexcept
    {
        bool const is_echo_due =
            echo_.is_open() and
            (options().has_echo or is_leaving(phase_) or echo_.is_half(this->size_));
        if (is_echo_due and take_echo(octet, now)) {
            return true;
        }
        if (phase_ != phase::awaiting) {
            return false;
        }
        // What comes before a unit's first octet is left out, as far as that is wanted.
        if (this->may_skip() and to_u8(octet) != unit()) {
            this->skip_noise();
        } else if (framer().take(octet)) {
            take_frame(now);
        }
        return true;
    }

    /// Holds an octet against the one that was sent. Whether it is accounted for: on a line that echoes it
    /// always is, elsewhere where it is the same.
    [[gnu::always_inline]] constexpr bool take_echo(std::byte octet, instant now) noexcept
    {
        bool const is_same = echo_.take(octet, question());
        if (options().has_echo) {
            if (not is_same) {
                statistics_.note(line_event::collision, unit());
                trouble_ = trouble_ == errc::none ? errc::collision : trouble_;
            }
            return true;
        }
        if (is_same and not echo_.is_open()) {
            statistics_.note(line_event::mismatch, unit());
            trouble_ = errc::echoed;
            if (phase_ == phase::awaiting) {
                settle(errc::echoed, now);
            }
        }
        return is_same;
    }

    /// The line was not silent when a request was to leave.
    [[gnu::noinline]] constexpr void be_disturbed(instant now) noexcept
    {
        if (phase_ != phase::ready) {
            return;
        }
        if (this->may_be_stale_) {
            settle(errc::bus_jam, now);
        } else {
            wait_for_silence(now);
        }
    }

    constexpr void take_frame(instant now) noexcept
    {
        if (not framer().poll_end() or trouble_ == errc::collision) {
            return;
        }
        errc wrong = framer().verdict();
        if (wrong == errc::none) {
            wrong = check_answer(question(), framer().frame());
        }
        if (wrong == errc::none and not framer().has_told_size()) {
            wrong = errc::wrong_length;
        }
        line_event const event = event_of(wrong);
        note_frame(statistics_, event, wrong, unit(), now);
        bool const is_answer = event == line_event::reply or event == line_event::exception;
        bool const is_damaged = event == line_event::crc and framer().claims(question()) and
                                framer().has_told_size();
        // A damaged one may be what another unit owes, where one does: nothing in its octets is to be relied on.
        if (is_answer or (is_damaged and quarantine_.is_empty())) {
            attempts_.note_answered();
        }
        if (attempts_.may_pause(wrong)) {
            deadline_ = now + attempts_.take_pause();
            phase_ = phase::pausing;
            trouble_ = errc::none;
        } else if (is_answer or wrong == errc::echoed) {
            settle(wrong, now);
        } else if (event != line_event::foreign and wrong != errc::frame_too_short) {
            // A damaged answer of our unit is worth an early repetition. Anything else may be noise
            // before the answer or an answer to an older question, so the timer runs on.
            trouble_ = wrong;
            if (is_damaged) {
                attempt_failed(now);
            }
        }
    }

    constexpr void time_is_over(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            if (trouble_ == errc::none) {
                trouble_ = framer().is_quiet() ? errc::timed_out : errc::bus_jam;
                statistics_.note(framer().is_quiet() ? line_event::timeout : line_event::jam,
                                 unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else {
            if (phase_ != phase::turnaround) {
                trouble_ = phase_ == phase::waiting ? errc::bus_jam : errc::transmit_stalled;
            }
            if (is_leaving(phase_) and unit() == 0) {
                turn_around(now); // it may have left just now
            } else {
                settle(trouble_, now);
            }
        }
    }
};

} // namespace rtuwire

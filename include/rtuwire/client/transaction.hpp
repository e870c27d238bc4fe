// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One request of a client, from its start to its outcome: silence before it, the bytes to send, the response,
// repetitions, time limits. Knows no conversation. client/phase.hpp lists its phases, client/quarantine.hpp says how
// long a unit that did not respond in time gets no new request.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/client_state.hpp>
#include <rtuwire/client/line_end.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/quarantine.hpp>
#include <rtuwire/client/request_steps.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Runs a client's request under way; the base of `basic_client`, which decides whose it is.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class transaction : public request_steps<Statistics, Line, Options, Debts, Front> {
    using end_of_line = line_end<Statistics, Line, Options, Debts, Front>;
    using steps = request_steps<Statistics, Line, Options, Debts, Front>;
    using client_state::deadline_;
    using client_state::echo_;
    using client_state::error_;
    using client_state::is_woken_;
    using client_state::phase_;
    using client_state::retries_;
    using end_of_line::framer;
    using end_of_line::quarantine_;
    using end_of_line::request;
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

    /// Takes bytes that had arrived by `now`, in any chunking. While no response is awaited they are noise: dropped,
    /// but the line was not silent. A response that is passed in before `advance` has seen the time-out is in time.
    constexpr void receive(byte_view const& bytes, instant now) noexcept
    {
        if (bytes.empty()) {
            return;
        }
        bool const is_start = framer().is_quiet();
        begin_chunk(bytes.size(), now);
        std::size_t taken = 0;
        while (taken < bytes.size() and take(bytes[taken], now)) {
            ++taken;
        }
        if (taken < bytes.size()) {
            this->count_stray(bytes.subspan(taken), is_start and taken == 0);
            on_line_activity(now);
        }
    }

    /// Reports a receive error (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        begin_chunk(1, now);
        if (phase_ != phase::awaiting) {
            on_line_activity(now);
        } else if (this->may_skip()) {
            this->drop_leading_noise();
        } else {
            framer().spoil();
        }
    }

    /// Notes that the last stop bit of what `poll_transmit` returned has left at `at`, or will have left by then.
    constexpr void sent(instant at) noexcept
    {
        if (not is_leaving(phase_)) {
            framer().note_activity(at);
            return;
        }
        framer().restart(at);
        statistics_.note_asked(at);
        this->skip_left_ = options().max_leading_noise;
        if (unit() == 0) {
            return turn_around(at);
        }
        phase_ = phase::awaiting;
        deadline_ = at + note_sent(at);
        if (error_ == errc::cancelled or error_ == errc::line_echo) {
            settle(error_, at);
        }
    }

    /// Lets time pass. Returns whether a unit may be asked again from here on.
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
            on_timeout(now);
        }
        return quarantine_.advance(now);
    }

    /// Gives up the request under way, of whichever conversation; its outcome is `cancelled`. A write may have taken
    /// effect all the same. A frame that is leaving leaves whole, and a broadcast gets its turnaround; the outcome
    /// comes then.
    constexpr void cancel(instant now) noexcept
    {
        if (is_leaving(phase_) or phase_ == phase::turnaround) {
            error_ = errc::cancelled;
        } else if (phase_ != phase::idle and phase_ != phase::settled) {
            settle(errc::cancelled, now);
        }
    }

    /// The bytes to send now, each request and repetition once; empty when there is nothing to send. They are the
    /// client's own, and unchanged until `sent`.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        statistics_.note(retries_.is_first() ? line_event::request : line_event::repetition, unit());
        phase_ = phase::handed_out;
        echo_.begin();
        return request();
    }

    /// When the next pass has something to do.
    constexpr void add_to(earliest& next) const noexcept
    {
        framer().add_to(next);
        quarantine_.add_to(next);
        if (is_woken_ or is_under_way(phase_)) {
            // After `wake`, a time that has come already.
            bool const is_past = is_woken_ and phase_ == phase::waiting;
            next.add(is_past ? deadline_ - retries_.response_timeout() : deadline_);
        }
    }

    /// Whether a request is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

protected:
    using end_of_line::options;

    /// Whether only the asker is missing: the line would let the request leave, or its outcome is there.
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

    /// Takes a request: copies its frame to the front of the memory. Errors: `frame_too_short`,
    /// `frame_too_long`; `buffer_too_small` where the request and its response do not fit together.
    constexpr errc start(request_frame const& asked, instant now, retry_policy const& with) noexcept
    {
        if (errc const wrong = this->keep(asked.frame()); wrong != errc::none) {
            return wrong;
        }
        this->must_send_now_ = not asked.may_be_repeated();
        is_woken_ = false;
        retries_.begin(with, asked.may_be_repeated() and unit() != 0);
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

    /// A stop request needs the line. The request under way is not repeated; where it may be cut, it is given up,
    /// unless its response has begun to arrive.
    constexpr void make_way(bool may_cut, instant now) noexcept
    {
        retries_.end_retries();
        bool const has_not_left = phase_ == phase::waiting or phase_ == phase::ready or phase_ == phase::pausing;
        bool const is_arriving = phase_ == phase::awaiting and not framer().is_quiet();
        if (has_not_left or (may_cut and not is_arriving)) {
            cancel(now);
        }
    }

    /// Whether the request was given up and its asker was not told yet.
    constexpr bool was_cut() const noexcept { return phase_ == phase::settled and error_ == errc::cancelled; }

    /// Whether the request that ended left more than once, and was not given up.
    constexpr bool was_repeated() const noexcept { return not retries_.is_first() and error_ != errc::cancelled; }

    /// How the request ended for its unit: one that left and was given up without a response counts as timed out.
    constexpr errc heard_of_unit() const noexcept
    {
        return error_ == errc::cancelled and retries_.unanswered() != 0 ? errc::timed_out : error_;
    }

    /// Takes the outcome of a settled request.
    [[gnu::always_inline]] constexpr result<response> take_outcome() noexcept
    {
        phase_ = phase::idle;
        return error_ != errc::none ? result<response>{error_}
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
    /// Bytes arrived by `now`: first takes the frame that the silence before them ended. One function for both ways of
    /// arriving, 32 bytes less on a Cortex-M0+.
    [[gnu::noinline]] constexpr void begin_chunk(std::size_t bytes, instant now) noexcept
    {
        if (framer().begin_chunk(bytes, now) and phase_ == phase::awaiting) {
            take_frame(now);
        }
    }

    /// Takes a byte of an echo, of a response or before it; returns false where none is expected. Inlined, because it
    /// runs for each byte.
    [[gnu::always_inline]] constexpr bool take(std::byte byte, instant now) noexcept
    {
        bool const is_echo_due =
            echo_.is_open() and (options().has_line_echo or is_leaving(phase_) or echo_.is_half(this->size_));
        if (is_echo_due and take_echo(byte, now)) {
            return true;
        }
        if (phase_ != phase::awaiting) {
            return false;
        }
        // Bytes before the unit's address are skipped, as far as `max_leading_noise` allows.
        if (this->may_skip() and to_u8(byte) != unit()) {
            this->drop_leading_noise();
        } else if (framer().push(byte)) {
            take_frame(now);
        }
        return true;
    }

    /// Compares a byte with the one that was sent. Returns whether it is accounted for: on a line that echoes it
    /// always is, elsewhere where it is the same.
    [[gnu::always_inline]] constexpr bool take_echo(std::byte byte, instant now) noexcept
    {
        bool const is_same = echo_.take(byte, request());
        if (options().has_line_echo) {
            if (not is_same) {
                statistics_.note(line_event::collision, unit());
                error_ = error_ == errc::none ? errc::collision : error_;
            }
            return true;
        }
        if (is_same and not echo_.is_open()) {
            statistics_.note(line_event::mismatch, unit());
            error_ = errc::line_echo;
            if (phase_ == phase::awaiting) {
                settle(errc::line_echo, now);
            }
        }
        return is_same;
    }

    /// The line was not silent when a request was to leave.
    [[gnu::noinline]] constexpr void on_line_activity(instant now) noexcept
    {
        if (phase_ != phase::ready) {
            return;
        }
        if (this->must_send_now_) {
            settle(errc::bus_jam, now);
        } else {
            wait_for_silence(now);
        }
    }

    constexpr void take_frame(instant now) noexcept
    {
        if (not framer().poll_end() or error_ == errc::collision) {
            return;
        }
        errc wrong = framer().verdict();
        if (wrong == errc::none) {
            wrong = check_response(request(), framer().frame());
        }
        if (wrong == errc::none and not framer().matches_size_hint()) {
            wrong = errc::wrong_length;
        }
        line_event const event = event_of(wrong);
        note_frame(statistics_, event, wrong, unit(), now);
        bool const is_response = event == line_event::reply or event == line_event::exception;
        bool const is_damaged =
            event == line_event::crc and framer().looks_addressed_to(request()) and framer().matches_size_hint();
        // While another unit's response is outstanding, a damaged one may be that: none of its bytes can be relied on.
        if (is_response or (is_damaged and quarantine_.is_empty())) {
            retries_.note_response();
        }
        if (retries_.may_pause(wrong)) {
            deadline_ = now + retries_.take_pause();
            phase_ = phase::pausing;
            error_ = errc::none;
        } else if (is_response or wrong == errc::line_echo) {
            settle(wrong, now);
        } else if (event != line_event::foreign and wrong != errc::frame_too_short) {
            // A damaged response of our unit is worth an early repetition. Anything else may be noise
            // before the response or a response to an older request, so the timer runs on.
            error_ = wrong;
            if (is_damaged) {
                attempt_failed(now);
            }
        }
    }

    constexpr void on_timeout(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            if (error_ == errc::none) {
                error_ = framer().is_quiet() ? errc::timed_out : errc::bus_jam;
                statistics_.note(framer().is_quiet() ? line_event::timeout : line_event::jam, unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else {
            if (phase_ != phase::turnaround) {
                error_ = phase_ == phase::waiting ? errc::bus_jam : errc::transmit_stalled;
            }
            if (is_leaving(phase_) and unit() == 0) {
                turn_around(now); // it may have left just now
            } else {
                settle(error_, now);
            }
        }
    }
};

} // namespace rtuwire

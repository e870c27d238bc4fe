// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows
// of functions only what wire/answer.hpp says.
//
//   phase         leaves it
//   idle          start -> waiting
//   waiting       t3.5 of silence, quarantine over -> ready; none in time -> settled (bus_jam)
//   ready         poll_transmit -> transmitting; octets -> waiting, or settled where the question
//                 may not wait; too late -> settled
//   transmitting  sent -> awaiting, or turnaround after a broadcast; too late -> settled
//   awaiting      the answer -> settled; time over or our answer damaged -> waiting, or settled;
//                 exception 05 or 06 -> pausing, or settled
//   pausing       time over -> waiting
//   turnaround    time over -> settled
//   settled       poll_outcome -> idle
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/client/attempts.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/client/echo.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/quarantine.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/answer.hpp>

namespace rtuwire {

/// Asks one question at a time. In each pass call `receive` with what arrived, `sent` when the last
/// stop bit has left, `advance`; then take the outcome and `start` the next, or let `converse` do
/// both; then send what `poll_transmit` gives. Sleep no longer than `poll_deadline` says.
template <typename Statistics> class basic_client {
public:
    explicit constexpr basic_client(line_timing const& timing,
                                    client_options const& options = {}) noexcept
        : framer_{direction::response, timing}, options_{options}
    {}

    /// Takes octets that had arrived by `now`, in any chunking. Outside of waiting for an answer they
    /// are noise: dropped, but the line was not silent.
    constexpr void receive(byte_view octets, instant now) noexcept
    {
        octets = take_echo(octets, now);
        while (not octets.empty() and phase_ == phase::awaiting) {
            octets = skip_noise(octets, now);
            octets = octets.subspan(framer_.receive(octets, now));
            take_frame(now);
        }
        if (not octets.empty()) {
            note_noise(octets, now);
        }
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            framer_.receive_error(now);
        } else {
            note_noise({}, now);
        }
    }

    /// Takes note that the last stop bit of what `poll_transmit` gave has left at `now`.
    constexpr void sent(instant now) noexcept
    {
        framer_.note_activity(now);
        if (phase_ != phase::transmitting) {
            return;
        }
        framer_.restart(now);
        bool const is_broadcast = unit() == 0;
        phase_ = is_broadcast ? phase::turnaround : phase::awaiting;
        skip_left_ = options_.skip_noise;
        sent_at_ = now;
        deadline_ = now + (is_broadcast ? options_.turnaround
                                        : attempts_.response_timeout() +
                                              framer_.line().characters(answer_size(question_)));
    }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        framer_.advance(now);
        quarantine_.advance(now);
        if (phase_ == phase::awaiting) {
            take_frame(now);
        }
        get_ready(now);
        if (reached(now, deadline_)) {
            time_is_over(now);
            get_ready(now);
        }
    }

    /// Asks a question. Errors: `busy` while another is not settled and its outcome taken,
    /// `frame_too_short`, `frame_too_long`; nothing is changed then.
    constexpr result<void> start(request question, instant now) noexcept
    {
        return start(question, now,
                     {.response_timeout = options_.response_timeout, .retries = options_.retries});
    }

    /// The same, with patience for this question's unit.
    constexpr result<void> start(request question, instant now, patience with) noexcept
    {
        if (phase_ != phase::idle) {
            return errc::busy;
        }
        if (question.frame().size() < min_adu_size) {
            return errc::frame_too_short;
        }
        if (question.frame().size() > max_adu_size) {
            return errc::frame_too_long;
        }
        question_ = question.frame();
        may_be_stale_ = not question.may_be_repeated();
        attempts_.begin(with, question.may_be_repeated());
        trouble_ = errc::none;
        wait_for_silence(now);
        advance(now);
        return {};
    }

    /// Gives up. The outcome is `cancelled`; a write may have taken effect all the same.
    constexpr void cancel(instant now) noexcept
    {
        if (phase_ == phase::idle or phase_ == phase::settled) {
            return;
        }
        bool const was_sent = phase_ == phase::transmitting or phase_ == phase::awaiting;
        settle(errc::cancelled, now, was_sent or attempts_.has_failed());
    }

    /// The octets to send now, each request and repetition once; empty when there is nothing. They are
    /// the asker's own.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        statistics_.note(attempts_.is_first() ? line_event::request : line_event::repetition,
                         unit());
        phase_ = phase::transmitting;
        echo_.expect(options_.has_echo ? question_ : byte_view{});
        return question_;
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        auto const own = has_deadline() ? deadline{deadline_} : deadline{};
        return earlier(earlier(framer_.poll_deadline(), quarantine_.end()), own);
    }

    /// What came of the question, once. The answer is valid until the next request is sent. The error
    /// is an exception of the unit, or why no answer was accepted: `timed_out` when there was none.
    [[nodiscard]] constexpr std::optional<result<response>> poll_outcome() noexcept
    {
        if (phase_ != phase::settled) {
            return std::nullopt;
        }
        phase_ = phase::idle;
        return trouble_ != errc::none ? result<response>{trouble_}
                                      : result<response>{response{answer_}};
    }

    /// What was counted.
    [[nodiscard]] constexpr Statistics& statistics() noexcept { return statistics_; }
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept { return statistics_; }

    /// Whether a question is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

    /// Whether the line has fallen silent since the last octet.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer_.is_quiet(); }

    /// Whether a question of this conversation would be ready to leave at once.
    template <conversation Talk>
    [[nodiscard]] constexpr bool is_free_for(Talk const& talk) const noexcept
    {
        if constexpr (prompt_conversation<Talk>) {
            return is_quiet() and not quarantine_.covers(talk.unit().octet());
        } else {
            return true;
        }
    }

    /// Hands an outcome to the conversation and asks its next question. One conversation at a time:
    /// the outcome goes to whoever comes first.
    template <conversation Talk> constexpr void converse(Talk& talk, instant now) noexcept
    {
        if (auto const outcome = poll_outcome()) {
            talk.accept(*outcome);
        }
        advance_talk(talk, now);
        if (is_busy() or not is_free_for(talk)) {
            return;
        }
        if (auto const question = talk.next()) {
            auto const started = start(*question, now);
            if (not started) {
                talk.accept(started.error());
            }
        }
    }

private:
    enum class phase : std::uint8_t {
        idle,
        waiting,
        ready,
        transmitting,
        awaiting,
        pausing,
        turnaround,
        settled,
    };

    constexpr bool has_deadline() const noexcept
    {
        return phase_ != phase::idle and phase_ != phase::settled;
    }

    /// Lets the request leave, once the line allows it.
    constexpr void get_ready(instant now) noexcept
    {
        if (phase_ != phase::waiting or not framer_.is_quiet() or must_wait_for_late_answer()) {
            return;
        }
        phase_ = phase::ready;
        deadline_ =
            now + attempts_.response_timeout() + framer_.line().characters(question_.size());
    }

    /// What is left of octets without the echo of what was sent.
    constexpr byte_view take_echo(byte_view octets, instant now) noexcept
    {
        std::size_t const count = echo_.take(octets);
        if (count > 0) {
            framer_.note_activity(now);
            if (echo_.is_wrong()) {
                trouble_ = errc::collision;
                statistics_.note(line_event::collision, unit());
            }
        }
        return octets.subspan(count);
    }

    /// Leaves out what comes before a unit's first octet, as far as that is wanted.
    constexpr byte_view skip_noise(byte_view octets, instant now) noexcept
    {
        while (skip_left_ > 0 and not octets.empty() and framer_.is_at_start() and
               to_u8(octets[0]) != unit()) {
            octets = octets.subspan(1);
            --skip_left_;
            framer_.note_activity(now);
            statistics_.note(line_event::noise, unit());
        }
        return octets;
    }

    constexpr void note_noise(byte_view octets, instant now) noexcept
    {
        std::uint8_t const owing = framer_.is_quiet() ? quarantine_.unit() : std::uint8_t{0};
        rtuwire::note_noise(statistics_, octets, owing);
        framer_.note_activity(now);
        if (phase_ != phase::ready) {
            return;
        }
        if (may_be_stale_) {
            settle(errc::bus_jam, now, attempts_.has_failed());
        } else {
            phase_ = phase::waiting;
        }
    }

    constexpr void take_frame(instant now) noexcept
    {
        auto const frame = framer_.poll_frame();
        if (not frame or trouble_ == errc::collision) {
            return;
        }
        errc const wrong = *frame ? check_answer(question_, **frame) : frame->error();
        if (wrong == errc::none) {
            answer_ = (*frame)->pdu;
        }
        note_frame(statistics_, wrong, unit(), now - sent_at_);
        if (attempts_.may_pause(wrong)) {
            deadline_ = now + attempts_.take_pause();
            phase_ = phase::pausing;
        } else if (wrong == errc::none or is_refusal(wrong)) {
            settle(wrong, now, attempts_.has_failed());
        } else if (wrong != errc::wrong_unit) {
            take_trouble(wrong, now);
        }
    }

    /// A damaged answer of our unit is worth an early repetition. Anything else may be noise before the
    /// answer or an answer to an older question, so the timer runs on.
    constexpr void take_trouble(errc wrong, instant now) noexcept
    {
        if (wrong == errc::frame_too_short) {
            return;
        }
        trouble_ = wrong;
        if (event_of(wrong) == line_event::crc and framer_.claimed_unit() == unit()) {
            attempt_failed(now);
        }
    }

    constexpr void time_is_over(instant now) noexcept
    {
        switch (phase_) {
        case phase::waiting: settle(errc::bus_jam, now, attempts_.has_failed()); break;
        case phase::ready: settle(errc::transmit_stalled, now, attempts_.has_failed()); break;
        case phase::transmitting: settle(errc::transmit_stalled, now, true); break;
        case phase::awaiting:
            if (trouble_ == errc::none) {
                trouble_ = framer_.is_quiet() ? errc::timed_out : errc::bus_jam;
                statistics_.note(framer_.is_quiet() ? line_event::timeout : line_event::jam,
                                 unit());
            }
            attempt_failed(now);
            break;
        case phase::pausing: wait_for_silence(now); break;
        case phase::turnaround:
            answer_ = {};
            settle(trouble_, now, false);
            break;
        case phase::idle:
        case phase::settled: break;
        }
    }

    constexpr void attempt_failed(instant now) noexcept
    {
        if (not attempts_.take_retry()) {
            settle(trouble_, now, true);
            return;
        }
        trouble_ = errc::none;
        wait_for_silence(now);
    }

    constexpr void wait_for_silence(instant now) noexcept
    {
        phase_ = phase::waiting;
        echo_.forget();
        deadline_ =
            (must_wait_for_late_answer() ? *quarantine_.end() : now) + attempts_.response_timeout();
    }

    /// Ends the transaction. Where an answer may still be on its way, its unit is asked nothing new
    /// for a while.
    constexpr void settle(errc error, instant now, bool answer_is_owed) noexcept
    {
        trouble_ = error;
        phase_ = phase::settled;
        echo_.forget();
        if (answer_is_owed) {
            quarantine_.begin(unit(), now + options_.late_answer);
        }
    }

    /// Who is asked.
    constexpr std::uint8_t unit() const noexcept { return to_u8(question_[0]); }

    constexpr bool must_wait_for_late_answer() const noexcept
    {
        return not attempts_.has_failed() and quarantine_.covers(unit());
    }

    [[no_unique_address]] Statistics statistics_{};
    framer framer_;
    echo_check echo_{};
    client_options options_;
    attempts attempts_{};
    byte_view question_{};
    byte_view answer_{};
    instant deadline_{};
    quarantine quarantine_{};
    instant sent_at_{};
    std::uint8_t skip_left_{0};
    phase phase_{phase::idle};
    errc trouble_{errc::none};
    bool may_be_stale_{false}; ///< the question must leave at once or not at all
};

/// A client that counts nothing.
using client = basic_client<no_statistics>;

} // namespace rtuwire

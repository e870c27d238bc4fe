// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows
// of functions only what wire/answer.hpp says. client/phase.hpp tells its states.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/client/attempts.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/client/echo.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/phase.hpp>
#include <rtuwire/client/quarantine.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/fixed.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/answer.hpp>

namespace rtuwire {

/// Asks one question at a time. In each pass call `receive` with what arrived, `sent` when the last
/// stop bit has left, `advance`; then take the outcome and `start` the next, or let `converse` do
/// both; then send what `poll_transmit` gives. Sleep no longer than `poll_deadline` says.
template <typename Statistics, typename Line = held<line_timing>,
          typename Options = held<client_options>>
class basic_client {
public:
    explicit constexpr basic_client(line_timing const& timing,
                                    client_options const& options = {}) noexcept
        : options_{options}, framer_{timing}
    {}

    /// With a line and options that are fixed: all zero, so that a `constinit` one needs no flash.
    constexpr basic_client() noexcept = default;

    /// Takes octets that had arrived by `now`, in any chunking. Outside of waiting for an answer they
    /// are noise: dropped, but the line was not silent.
    constexpr void receive(byte_view const& octets, instant now) noexcept
    {
        if (octets.empty()) {
            return;
        }
        std::uint8_t const owing = framer_.is_quiet() ? quarantine_.unit() : std::uint8_t{0};
        if (framer_.hear(octets.size(), now) and phase_ == phase::awaiting) {
            take_frame(now);
        }
        std::size_t taken = 0;
        while (taken < octets.size() and take(octets[taken], now)) {
            ++taken;
        }
        if (taken < octets.size()) {
            note_noise(statistics_, octets.subspan(taken), taken == 0 ? owing : std::uint8_t{0});
            be_disturbed(now);
        }
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            framer_.receive_error(now);
        } else {
            framer_.note_activity(now);
            be_disturbed(now);
        }
    }

    /// Takes note that the last stop bit of what `poll_transmit` gave has left at `at`, or will by then.
    constexpr void sent(instant at) noexcept
    {
        framer_.note_activity(at);
        if (phase_ != phase::transmitting) {
            return;
        }
        framer_.restart(at);
        statistics_.note_asked(at);
        bool const is_broadcast = unit() == 0;
        phase_ = is_broadcast ? phase::turnaround : phase::awaiting;
        skip_left_ = options().skip_noise;
        deadline_ = at + (is_broadcast ? options().turnaround : answer_time());
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
        client_options const& all = options();
        return start(question, now,
                     {.response_timeout = all.response_timeout, .retries = all.retries});
    }

    /// The same, with patience for this question's unit.
    constexpr result<void> start(request question, instant now, patience const& with) noexcept
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
        settle(errc::cancelled, now);
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
        echo_.expect(options().has_echo ? question_.size() : 0);
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
        if (trouble_ != errc::none) {
            return trouble_;
        }
        return response{unit() == 0 ? byte_view{} : framer_.frame().pdu()};
    }

    /// What was counted.
    [[nodiscard]] constexpr Statistics& statistics() noexcept { return statistics_; }
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept { return statistics_; }

    /// Whether a question is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

    /// Whether the line has fallen silent since the last octet.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer_.is_quiet(); }

    /// The times of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return framer_.line(); }

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
    using phase = client_phase;

    constexpr client_options const& options() const noexcept { return options_.get(); }

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

    /// Takes an octet of an echo, of an answer or before it; false where none is expected.
    constexpr bool take(std::byte octet, instant now) noexcept
    {
        if (echo_.is_due()) {
            if (not echo_.take(octet, question_)) {
                trouble_ = errc::collision;
                statistics_.note(line_event::collision, unit());
            }
            return true;
        }
        if (phase_ != phase::awaiting) {
            return false;
        }
        // What comes before a unit's first octet is left out, as far as that is wanted.
        if (skip_left_ > 0 and framer_.is_at_start() and to_u8(octet) != unit()) {
            --skip_left_;
            statistics_.note(line_event::noise, unit());
        } else if (framer_.take(octet)) {
            take_frame(now);
        }
        return true;
    }

    /// The line was not silent when a request was to leave.
    constexpr void be_disturbed(instant now) noexcept
    {
        if (phase_ != phase::ready) {
            return;
        }
        if (may_be_stale_) {
            settle(errc::bus_jam, now);
        } else {
            phase_ = phase::waiting;
        }
    }

    constexpr void take_frame(instant now) noexcept
    {
        if (not framer_.poll_end() or trouble_ == errc::collision) {
            return;
        }
        errc wrong = framer_.verdict();
        if (wrong == errc::none) {
            wrong = check_answer(question_, framer_.frame());
        }
        line_event const event = event_of(wrong);
        note_frame(statistics_, event, wrong, unit(), now);
        if (attempts_.may_pause(wrong)) {
            deadline_ = now + attempts_.take_pause();
            phase_ = phase::pausing;
        } else if (event == line_event::reply or event == line_event::exception) {
            settle(wrong, now);
        } else if (event != line_event::foreign and wrong != errc::frame_too_short) {
            // A damaged answer of our unit is worth an early repetition. Anything else may be noise
            // before the answer or an answer to an older question, so the timer runs on.
            trouble_ = wrong;
            if (event == line_event::crc and framer_.claims(unit())) {
                attempt_failed(now);
            }
        }
    }

    constexpr void time_is_over(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            if (trouble_ == errc::none) {
                trouble_ = framer_.is_quiet() ? errc::timed_out : errc::bus_jam;
                statistics_.note(framer_.is_quiet() ? line_event::timeout : line_event::jam,
                                 unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else if (has_deadline()) {
            settle(phase_ == phase::waiting      ? errc::bus_jam
                   : phase_ == phase::turnaround ? trouble_
                                                 : errc::transmit_stalled,
                   now);
        }
    }

    constexpr void attempt_failed(instant now) noexcept
    {
        if (not attempts_.take_retry()) {
            settle(trouble_, now);
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
    constexpr void settle(errc error, instant now) noexcept
    {
        bool const is_answered = error == errc::none or is_exception(error);
        bool const was_sent = phase_ == phase::transmitting or phase_ == phase::awaiting;
        if (attempts_.has_failed() or (was_sent and not is_answered)) {
            quarantine_.begin(unit(), now + options().late_answer);
        }
        trouble_ = error;
        phase_ = phase::settled;
        echo_.forget();
    }

    /// From the end of the question to that of its answer, at most.
    constexpr duration answer_time() const noexcept
    {
        return attempts_.response_timeout() + framer_.line().characters(answer_size(question_));
    }

    /// Who is asked.
    constexpr std::uint8_t unit() const noexcept { return to_u8(question_[0]); }

    constexpr bool must_wait_for_late_answer() const noexcept
    {
        return not attempts_.has_failed() and quarantine_.covers(unit());
    }

    // Small first, as in the framer.
    phase phase_{phase::idle};
    errc trouble_{errc::none};
    std::uint8_t skip_left_{0};
    bool may_be_stale_{false}; ///< the question must leave at once or not at all
    attempts attempts_{};
    echo_check echo_{};
    quarantine quarantine_{};
    instant deadline_{};
    byte_view question_{};
    [[no_unique_address]] Options options_{};
    [[no_unique_address]] Statistics statistics_{};
    framer<direction::response, Line> framer_{};
};

/// A client that counts nothing.
using client = basic_client<no_statistics>;

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time, its repetitions and time limits. Owns
// neither the wire nor a clock; knows of functions only what wire/answer.hpp says.
//
//   phase         leaves it
//   idle          start -> waiting
//   waiting       t3.5 of silence, quarantine over -> ready; none in time -> settled (bus_jam)
//   ready         poll_transmit -> transmitting; octets -> waiting, or settled where the question
//                 may not wait; too late -> settled
//   transmitting  sent -> awaiting, or turnaround after a broadcast; too late -> settled
//   awaiting      the answer -> settled; time over or our answer damaged -> waiting, or settled
//   turnaround    time over -> settled
//   settled       poll_outcome -> idle
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/answer.hpp>

namespace rtuwire {

/// How patient a client is with one unit.
struct patience {
    /// From the end of a request to the start of its answer; the time the answer itself takes on the
    /// line comes on top.
    duration response_timeout{milliseconds(1000)};
    /// How often a request is repeated after silence or a damaged answer; never after an exception,
    /// and never for a broadcast.
    std::uint8_t retries{2};
};

/// How patient a client is.
struct client_options {
    /// As in `patience`, for every unit that none is given for.
    duration response_timeout{milliseconds(1000)};
    /// From the end of a broadcast to the next request; units need it to act (SL 2.4.1).
    duration turnaround{milliseconds(100)};
    /// How long after the end of a transaction an answer that came too late may still arrive. Until
    /// then the unit is asked nothing new, because an answer does not say which question it is to.
    duration late_answer{milliseconds(200)};
    /// As in `patience`.
    std::uint8_t retries{2};
};

/// Asks one question at a time. In each pass call `receive` with what arrived, `sent` when the last
/// stop bit has left, `advance`; then take the outcome and `start` the next, or let `converse` do
/// both; then send what `poll_transmit` gives. Sleep no longer than `poll_deadline` says.
class client {
public:
    explicit constexpr client(line_timing const& line, client_options const& options = {}) noexcept
        : framer_{direction::response, line}, options_{options}
    {}

    /// Takes octets that had arrived by `now`, in any chunking. Outside of waiting for an answer they
    /// are noise: dropped, but the line was not silent.
    constexpr void receive(byte_view octets, instant now) noexcept
    {
        while (not octets.empty() and phase_ == phase::awaiting) {
            octets = octets.subspan(framer_.receive(octets, now));
            take_frame(now);
        }
        if (not octets.empty()) {
            note_noise(now);
        }
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            framer_.receive_error(now);
        } else {
            note_noise(now);
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
        bool const is_broadcast = to_u8(question_[0]) == 0;
        phase_ = is_broadcast ? phase::turnaround : phase::awaiting;
        deadline_ = now + (is_broadcast ? options_.turnaround
                                        : patience_.response_timeout +
                                              framer_.line().characters(answer_size(question_)));
    }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        framer_.advance(now);
        if (is_quarantined_ and reached(now, quarantine_end_)) {
            is_quarantined_ = false;
        }
        if (phase_ == phase::awaiting) {
            take_frame(now);
        }
        get_ready(now);
        if (has_deadline() and reached(now, deadline_)) {
            time_is_over(now);
            get_ready(now);
        }
    }

    /// Asks a question. Errors: `busy` while another is not settled and its outcome taken,
    /// `frame_too_short`, `frame_too_long`; nothing is changed then.
    constexpr result<void> start(request question, instant now) noexcept
    {
        return start(question, now, {options_.response_timeout, options_.retries});
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
        patience_ = with;
        may_be_stale_ = not question.may_be_repeated();
        if (may_be_stale_) {
            patience_.retries = 0;
        }
        retries_left_ = patience_.retries;
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
        settle(errc::cancelled, now, was_sent or has_repeated());
    }

    /// The octets to send now, each request and repetition once; empty when there is nothing. They are
    /// the asker's own.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        phase_ = phase::transmitting;
        return question_;
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        deadline next = framer_.poll_deadline();
        if (has_deadline()) {
            next = earlier(next, deadline_);
        }
        if (is_quarantined_) {
            next = earlier(next, quarantine_end_);
        }
        return next;
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
            return result<response>{trouble_};
        }
        return result<response>{response{answer_}};
    }

    /// Whether a question is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

    /// Whether the line has fallen silent since the last octet.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer_.is_quiet(); }

    /// Whether a question of this conversation would be ready to leave at once.
    template <conversation Talk>
    [[nodiscard]] constexpr bool is_free_for(Talk const& talk) const noexcept
    {
        if constexpr (prompt_conversation<Talk>) {
            std::uint8_t const unit = talk.unit().octet();
            bool const is_owed =
                is_quarantined_ and (quarantined_unit_ == any_unit or quarantined_unit_ == unit);
            return is_quiet() and not is_owed;
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
        deadline_ = now + patience_.response_timeout + framer_.line().characters(question_.size());
    }

    constexpr void note_noise(instant now) noexcept
    {
        framer_.note_activity(now);
        if (phase_ != phase::ready) {
            return;
        }
        if (may_be_stale_) {
            settle(errc::bus_jam, now, has_repeated());
        } else {
            phase_ = phase::waiting;
        }
    }

    constexpr void take_frame(instant now) noexcept
    {
        auto const frame = framer_.poll_frame();
        if (not frame) {
            return;
        }
        errc const wrong = *frame ? check_answer(question_, **frame) : frame->error();
        if (wrong == errc::none) {
            answer_ = (*frame)->pdu;
        }
        if (wrong == errc::none or is_refusal(wrong)) {
            settle(wrong, now, has_repeated());
        } else if (wrong != errc::wrong_unit) {
            take_trouble(wrong, now);
        }
    }

    static constexpr bool is_refusal(errc error) noexcept
    {
        return is_exception(error) or error == errc::unlisted_exception;
    }

    /// A damaged answer of our unit is worth an early repetition. Anything else may be noise before the
    /// answer or an answer to an older question, so the timer runs on.
    constexpr void take_trouble(errc wrong, instant now) noexcept
    {
        if (wrong == errc::frame_too_short) {
            return;
        }
        trouble_ = wrong;
        bool const is_damaged = wrong == errc::crc_mismatch or wrong == errc::uart_error;
        if (is_damaged and framer_.claimed_unit() == to_u8(question_[0])) {
            attempt_failed(now);
        }
    }

    constexpr void time_is_over(instant now) noexcept
    {
        switch (phase_) {
        case phase::waiting: settle(errc::bus_jam, now, has_repeated()); break;
        case phase::ready: settle(errc::transmit_stalled, now, has_repeated()); break;
        case phase::transmitting: settle(errc::transmit_stalled, now, true); break;
        case phase::awaiting:
            if (trouble_ == errc::none) {
                trouble_ = framer_.is_quiet() ? errc::timed_out : errc::bus_jam;
            }
            attempt_failed(now);
            break;
        case phase::turnaround:
            answer_ = {};
            settle(errc::none, now, false);
            break;
        case phase::idle:
        case phase::settled: break;
        }
    }

    constexpr void attempt_failed(instant now) noexcept
    {
        if (retries_left_ == 0) {
            settle(trouble_, now, true);
            return;
        }
        --retries_left_;
        trouble_ = errc::none;
        wait_for_silence(now);
    }

    constexpr void wait_for_silence(instant now) noexcept
    {
        phase_ = phase::waiting;
        deadline_ =
            (must_wait_for_late_answer() ? quarantine_end_ : now) + patience_.response_timeout;
    }

    /// Ends the transaction. Where an answer may still be on its way, its unit is asked nothing new
    /// for a while.
    constexpr void settle(errc error, instant now, bool answer_is_owed) noexcept
    {
        trouble_ = error;
        phase_ = phase::settled;
        if (not answer_is_owed) {
            return;
        }
        auto const unit = to_u8(question_[0]);
        quarantined_unit_ = is_quarantined_ and quarantined_unit_ != unit ? any_unit : unit;
        is_quarantined_ = true;
        quarantine_end_ = now + options_.late_answer;
    }

    constexpr bool has_repeated() const noexcept { return retries_left_ != patience_.retries; }

    constexpr bool must_wait_for_late_answer() const noexcept
    {
        return is_quarantined_ and not has_repeated() and
               (quarantined_unit_ == any_unit or quarantined_unit_ == to_u8(question_[0]));
    }

    /// Stands for several units in `quarantined_unit_`; no unit has it.
    static constexpr std::uint8_t any_unit = 0xFF;

    framer framer_;
    client_options options_;
    patience patience_{};
    byte_view question_{};
    byte_view answer_{};
    instant deadline_{};
    instant quarantine_end_{};
    std::uint8_t quarantined_unit_{0};
    std::uint8_t retries_left_{0};
    phase phase_{phase::idle};
    errc trouble_{errc::none};
    bool is_quarantined_{false};
    bool may_be_stale_{false}; ///< the question must leave at once or not at all
};

} // namespace rtuwire

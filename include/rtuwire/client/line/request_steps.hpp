// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The steps of one request: each enters a phase of client/line/phase.hpp and sets the time that limits it.
// client/line/transaction.hpp decides when they are taken.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/client/line/line_end.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a client's transaction.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class request_steps : public line_end<Statistics, Line, Options, Debts, Front> {
    using end_of_line = line_end<Statistics, Line, Options, Debts, Front>;

public:
    using end_of_line::end_of_line;

protected:
    using phase = client_phase;
    using end_of_line::deadline_;
    using end_of_line::echo_;
    using end_of_line::error_;
    using end_of_line::framer;
    using end_of_line::options;
    using end_of_line::phase_;
    using end_of_line::quarantine_;
    using end_of_line::retries_;
    using end_of_line::statistics_;

    constexpr std::uint8_t unit() const noexcept { return this->asked_unit(); }

    /// The request waits for the line: for others to end no longer than for a response, and for the silence besides; where
    /// it has left already, first for its unit's pause. Not inlined: it is called in several places.
    [[gnu::noinline]] constexpr void wait_for_silence(instant now) noexcept
    {
        leave_begun();
        error_ = errc::none;
        echo_.end();
        deadline_ = now + retries_.pause();
        if (phase_ == phase::awaiting and deadline_ != now) {
            phase_ = phase::pausing;
            return;
        }
        phase_ = phase::waiting;
        // Both fit: see `longest_duration`.
        deadline_ = now + retries_.response_timeout() + framer().line().silence();
    }

    /// The transmitter has the time that the request takes, plus the response time-out.
    [[gnu::noinline]] constexpr void limit_sending(instant now) noexcept
    {
        deadline_ = now + retries_.response_timeout() + this->time_to_send();
    }

    /// A broadcast has left: units need time to act.
    constexpr void turn_around(instant at) noexcept
    {
        phase_ = phase::turnaround;
        deadline_ = at + options().turnaround;
    }

    /// The request left once more. Returns how long its response may take, up to its last byte.
    constexpr duration note_sent(instant at) noexcept
    {
        duration const limit = retries_.response_timeout() + this->time_to_respond();
        retries_.note_sent(at, this->time_to_send(), limit + late_response());
        return limit;
    }

    /// One sending has failed: another one follows, or the transaction ends. Inlined at both its places: 8 bytes less,
    /// and its callers use less stack.
    [[gnu::always_inline]] constexpr void attempt_failed(instant now) noexcept
    {
        if (retries_.take_retry()) {
            wait_for_silence(now);
        } else {
            settle(error_, now);
        }
    }

    /// Ends the transaction. Where responses may still be on their way, its unit gets no new request until none can
    /// be: client/line/quarantine.hpp gives the rule and its reasons.
    constexpr void settle(errc error, instant now) noexcept
    {
        leave_begun();
        error_ = error;
        bool const owes = retries_.unanswered() != 0;
        if (owes or (retries_.pause() != duration{} and unit() != 0)) {
            bool const has_response = not owes or error_ == errc::none or is_exception(error_);
            duration const late = late_response();
            quarantine_.begin(unit(),
                              has_response ? now + retries_.all_that_follow(now, late) : retries_.owed_until(now));
        }
        phase_ = phase::settled;
        deadline_ = now;
        echo_.end();
    }

    /// The time of a phase is over.
    constexpr void on_timeout(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            if (error_ == errc::none) {
                bool const is_silent = framer().is_at_rest(now);
                error_ = is_silent ? errc::timed_out : errc::bus_jam;
                statistics_.note(is_silent ? line_event::timeout : line_event::jam, unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else {
            if (phase_ != phase::turnaround) {
                error_ = phase_ == phase::waiting ? errc::bus_jam : errc::transmit_stalled;
            }
            if (is_leaving(phase_)) { // it may have left just now
                if (unit() == 0) {
                    return turn_around(now);
                }
                static_cast<void>(note_sent(now));
            }
            settle(error_, now);
        }
    }

    /// What has come of an echo and of a response is traced; neither is awaited any longer. What silence would not have
    /// ended is dropped: nothing else would end it in time.
    [[gnu::always_inline]] constexpr void leave_begun() noexcept
    {
        if constexpr (is_traced<Statistics>) {
            pass_begun_echo();
            byte_view const begun = phase_ == phase::awaiting ? framer().begun() : byte_view{};
            if (not begun.empty()) {
                statistics_.pass_stray(begun, true, to_u8(begun[0]) == unit());
            }
        }
        if constexpr (has_system) {
            framer().drop_unended();
        }
    }

    /// Traces bytes that were taken for the beginning of an echo: on another line than one that echoes, they are none.
    constexpr void pass_begun_echo() noexcept requires is_traced<Statistics>
    {
        pass_echo(outside_frame(echo_.taken()));
    }

    /// Of so many bytes that came back, those that belong to no frame that may be a response.
    constexpr std::size_t outside_frame(std::size_t taken) const noexcept
    {
        std::size_t const inside = phase_ == phase::awaiting and not this->expects_echo() ? framer().begun().size() : 0;
        return inside < taken ? taken - inside : 0;
    }

    /// Traces the request that has left.
    constexpr void pass_request(instant at) noexcept requires is_traced<Statistics>
    {
        statistics_.pass_own(this->request(), frame_role::request, at);
    }

    constexpr void pass_echo(std::size_t taken) noexcept requires is_traced<Statistics>
    {
        byte_view const bytes = this->request().first(taken);
        if (this->expects_echo() or taken == this->size_) {
            statistics_.pass_echo(bytes, frame_role::request);
        } else {
            statistics_.pass(bytes, frame_role::unknown, frame_verdict::stray);
        }
    }

private:
    /// Constructed anew: GCC would read a constant's copy from memory.
    constexpr duration late_response() const noexcept { return options().late_response; }
};

} // namespace rtuwire

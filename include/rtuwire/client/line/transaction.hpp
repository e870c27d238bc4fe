// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One request of a client, from its start to its outcome: silence before it, the bytes to send, the response,
// repetitions, time limits. Knows no conversation. client/line/phase.hpp lists its phases, client/line/quarantine.hpp
// says how long a unit that did not respond in time gets no new request.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/line/reception.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Runs a client's request under way; the base of `basic_client`, which decides whose it is.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class transaction : public reception<Statistics, Line, Options, Debts, Front> {
    using receiver = reception<Statistics, Line, Options, Debts, Front>;
    using phase = client_phase;
    using receiver::deadline_;
    using receiver::echo_;
    using receiver::error_;
    using receiver::framer;
    using receiver::is_woken_;
    using receiver::limit_sending;
    using receiver::note_sent;
    using receiver::on_timeout;
    using receiver::phase_;
    using receiver::quarantine_;
    using receiver::request;
    using receiver::retries_;
    using receiver::settle;
    using receiver::statistics_;
    using receiver::take_frame;
    using receiver::turn_around;
    using receiver::unit;
    using receiver::wait_for_silence;

public:
    using receiver::receiver;

    /// Notes that the last stop bit of what `poll_transmit` returned has left at `at`, or will have left by then.
    constexpr void sent(instant at) noexcept
    {
        if (not is_leaving(phase_)) {
            framer().note_activity(at);
            return;
        }
        framer().restart(at);
        statistics_.note_asked(at);
        if constexpr (is_traced<Statistics>) {
            this->pass_request(at);
        }
        this->noise_.begin(options().max_leading_noise);
        if (unit() == 0) {
            return turn_around(at);
        }
        phase_ = phase::awaiting;
        deadline_ = at + note_sent(at);
        if (error_ == errc::cancelled or error_ == errc::line_echo) {
            settle(error_, at);
        }
    }

    /// Lets time pass. Returns whether a unit may be asked again from here on. `at` is `within_reach` of the latest call.
    [[gnu::always_inline]] constexpr bool advance(instant now, instant at) noexcept
    {
        is_woken_ = false;
        framer().advance(now);
        retries_.advance(now, at);
        if (phase_ == phase::awaiting) {
            take_frame(now);
        }
        if (phase_ == phase::handed_out) {
            limit_sending(now);
            phase_ = phase::transmitting;
        } else if (is_under_way(phase_) and reached(at, deadline_)) {
            on_timeout(now);
        }
        return quarantine_.advance(at);
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
    constexpr void add_to(earliest& next, bool is_reserved) const noexcept
    {
        // A stop for which the line is reserved may cut the request as soon as the line is silent.
        framer().add_to(next, phase_ == phase::awaiting and not is_reserved);
        quarantine_.add_to(next);
        if (is_woken_ or is_under_way(phase_)) {
            // After `wake`, a time that has come already: a request that waits then has seen the line fall silent.
            bool const is_past = is_woken_ and phase_ == phase::waiting;
            next.add(is_past ? framer().last_activity() : deadline_);
        }
    }

    /// Whether a request is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }

protected:
    using receiver::options;

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
};

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The steps of one request: each enters a phase of client/phase.hpp and sets the time that limits it. When they are
// taken is told in client/transaction.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/client/line_end.hpp>
#include <rtuwire/client/phase.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
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
    using client_state::attempts_;
    using client_state::deadline_;
    using client_state::echo_;
    using client_state::phase_;
    using client_state::trouble_;
    using end_of_line::options;
    using end_of_line::quarantine_;

    constexpr std::uint8_t unit() const noexcept { return this->asked_unit(); }

    /// The request waits for the line. Not inlined: several ways lead here.
    [[gnu::noinline]] constexpr void wait_for_silence(instant now) noexcept
    {
        phase_ = phase::waiting;
        trouble_ = errc::none;
        echo_.end();
        deadline_ = now + attempts_.response_timeout();
    }

    /// The transmitter has as long as the request takes, and the response time-out.
    [[gnu::noinline]] constexpr void limit_sending(instant now) noexcept
    {
        deadline_ = now + attempts_.response_timeout() + this->time_to_send();
    }

    /// A broadcast has left: units need time to act.
    constexpr void turn_around(instant at) noexcept
    {
        phase_ = phase::turnaround;
        deadline_ = at + options().turnaround;
    }

    /// The request left once more. How long its answer may take, up to its last octet.
    constexpr duration note_sent(instant at) noexcept
    {
        duration const limit = attempts_.response_timeout() + this->time_to_answer();
        attempts_.note_sent(at, limit + late_answer());
        return limit;
    }

    /// One sending has failed: another one follows, or the end. Inlined at both its places: 8 bytes less, and its
    /// callers' stack.
    [[gnu::always_inline]] constexpr void attempt_failed(instant now) noexcept
    {
        if (attempts_.take_retry()) {
            wait_for_silence(now);
        } else {
            settle(trouble_, now);
        }
    }

    /// Ends the transaction. Where answers may still be on their way, its unit is asked nothing new until none
    /// can be: the rule and its reasons stand in client/quarantine.hpp.
    constexpr void settle(errc error, instant now) noexcept
    {
        trouble_ = error;
        if (is_leaving(phase_)) {
            static_cast<void>(note_sent(now));
        }
        if (attempts_.unanswered() != 0) {
            bool const is_answered = trouble_ == errc::none or is_exception(trouble_);
            duration const late = late_answer();
            quarantine_.begin(unit(), is_answered ? now + attempts_.all_that_follow(now, late)
                                                  : attempts_.owed_until(now));
        }
        phase_ = phase::settled;
        deadline_ = now;
        echo_.end();
    }

private:
    /// Made anew: GCC would read a constant's copy from memory.
    constexpr duration late_answer() const noexcept
    {
        return duration{options().late_answer.microseconds};
    }
};

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whose turn it is to use the line, and who takes the outcome of a request: what client/turns.hpp knows, put into
// practice on a line.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The turns of conversations on a line; `LineDuty` runs one request at a time and knows none of them
/// (client/line/transaction.hpp).
template <typename LineDuty, typename Orders> class turn_desk : public LineDuty {
    using duty = LineDuty;

public:
    using duty::duty;

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_asked_by(asker const& who) const noexcept { return turns_.is_own(who); }

protected:
    using duty::is_held_back_;
    using duty::turns_;

    /// A conversation visits. Returns whether the outcome is there and its own. A request is dropped where the next in
    /// turn finds its asker missing twice, or where the asker itself has given it up.
    constexpr bool comes_by(asker& who, bool wants_turn, instant now) noexcept
    {
        client_phase const at = duty::phase_now();
        bool const is_own = is_asked_by(who);
        if (at == client_phase::idle or not(is_own or wants_turn)) {
            return false;
        }
        standing place = standing::is_last;
        if (not is_own) {
            place = turns_.visit(who);
        } else if (at == client_phase::settled) {
            return true;
        } else if (at == client_phase::waiting) {
            turns_.renew(who);
        }
        if (duty::awaits_asker()) {
            if (is_own) {
                duty::get_ready(now);
            } else {
                replace_asker(place, now);
            }
        }
        return false;
    }

    /// The outcome of the request. A missing response is noted, whatever becomes of the asker: a request that is not
    /// waited for has also fed its unit's watchdog.
    constexpr result<response> take_outcome(instant now) noexcept
    {
        orders_.note_outcome(duty::asked_unit(), duty::heard_of_unit(), duty::was_repeated(), now);
        return duty::take_outcome();
    }

    /// Whether it is this conversation's turn to ask. While others wait, or for a request that is made at the
    /// last moment, the line has to be silent first.
    constexpr bool may_ask(asker& who, bool is_prompt, instant now) noexcept
    {
        if (duty::phase_now() != client_phase::idle) {
            return false;
        }
        bool const is_quiet = duty::is_quiet();
        if constexpr (Orders::is_kept) {
            if (reservation_.is_held() and not reservation_.misses_holder(turns_, who)) {
                if (is_quiet) {
                    duty::wake(now);
                }
                return false;
            }
            reservation_.end();
        }
        if (not turns_.others_wait() and (is_quiet or not is_prompt)) {
            return true;
        }
        standing const at = turns_.visit(who);
        bool const may = is_quiet and turns_.take(at);
        if (is_quiet and not may) {
            duty::wake(now);
        }
        return may;
    }

    /// Whether a request that stops a unit may be sent: it waits for silence, and for the stop of another unit for which
    /// the line is reserved, but not for its turn.
    constexpr bool may_stop(asker& who, std::uint8_t unit, instant now) noexcept
    {
        if (not is_free()) {
            return false;
        }
        if (reservation_.is_held_for_another(unit) and not reservation_.misses_holder(turns_, who)) {
            duty::wake(now);
            return false;
        }
        reservation_.use();
        return true;
    }

    /// Whether a request would leave in this pass.
    constexpr bool is_free() const noexcept { return duty::phase_now() == client_phase::idle and duty::is_quiet(); }

    /// A conversation's unit gets no request now. The one that asked last has had its turn; others get one later.
    constexpr turn_result hold_back(asker const& who) noexcept
    {
        if (not turns_.is_last(who)) {
            is_held_back_ = true;
        }
        return turn_result::passed;
    }

    [[no_unique_address]] Orders orders_{};
    [[no_unique_address]] std::conditional_t<Orders::is_kept, reservation, no_reservation> reservation_{};

private:
    /// Only the asker is missing, and another conversation visits: whether that one takes its place. Inlined: smaller.
    [[gnu::always_inline]] constexpr void replace_asker(standing place, instant now) noexcept
    {
        duty::wake(now);
        bool const takes_over = place == standing::is_next and turns_.misses_asker();
        if (takes_over or place == standing::is_last) {
            duty::drop(now);
            static_cast<void>(take_outcome(now));
        }
    }
};

} // namespace rtuwire

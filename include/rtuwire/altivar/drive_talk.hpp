// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a script as a conversation with one unit: single reads and writes, pauses, and a time limit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/script.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The conversation of a script. It ends by its limit, counted from the first `advance`; or a script's grace later,
/// or at the end of the one question that is then under way or still has to be asked to leave the drive safe.
template <typename Script> class drive_talk : public commander {
public:
    constexpr drive_talk(unit_id unit, Script const& script, duration limit) noexcept
        : script_{script}, limit_{limit}, unit_{unit}
    {}

    /// Lets time pass: starts the clock, ends pauses, and the whole at its limit.
    constexpr void advance(instant now) noexcept
    {
        now_ = now;
        if (not has_begun_) {
            has_begun_ = true;
            late_at_ = now + limit_;
            if constexpr (Script::is_stop) {
                this->note_stop();
            } else if constexpr (Script::is_order) {
                this->note_order_to_run();
            } else {
                this->note_order();
            }
            take(script_.step({event::kind::begun}));
        }
        if (settled() or is_asking_) {
            return;
        }
        // No limit ends a stop whose word has not left once.
        bool const has_to_say = Script::is_stop and wish_.does == effect::stopping and not has_said_stop_;
        if (not is_late_ and reached(now, late_at_) and not has_to_say) {
            is_late_ = was_warned_ or Script::grace.microseconds == 0;
            was_warned_ = true;
            late_at_ = now + Script::grace;
            if (is_late_ or not script_.takes_back()) { // else it has its grace for that
                take(script_.step({event::kind::late}));
            }
        } else if (has_length() and reached(now, pause_end_)) {
            bool const is_pause = wish_.what == wish::kind::pause;
            take(script_.step(is_pause ? event{event::kind::pause_over}
                                       : event{event::kind::failed, 0, errc::bus_jam}));
        }
    }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

    /// For the client: what the next question does to the motor, and how a loss is told.
    [[nodiscard]] constexpr effect intent() const noexcept { return this->effect_now(wish_.does); }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return script_.drive_timeout(); }
    [[nodiscard]] static constexpr std::uint8_t tolerated_misses() noexcept { return 1; }

    constexpr void note_loss() noexcept
    {
        has_lost_ = has_begun_ and not settled();
        heed_loss();
    }

    constexpr std::optional<request> next() noexcept
    {
        if (not has_question()) {
            return std::nullopt;
        }
        is_asking_ = true;
        has_said_stop_ = has_said_stop_ or wish_.does == effect::stopping;
        return request{frame_, wish_.again};
    }

    /// Whether there is something to ask.
    [[nodiscard]] constexpr bool has_question() const noexcept
    {
        return has_begun_ and (wish_.what == wish::kind::read or wish_.what == wish::kind::write);
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_asking_ = false;
        if (settled()) {
            return;
        }
        take(outcome.error() == errc::overruled ? script_.yield() : script_.step(heard(outcome)));
        heed_loss();
    }

    /// When `advance` has something to do; nothing while a question is under way.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (settled() or is_asking_ or not has_begun_) {
            return {};
        }
        earliest next;
        if (not is_late_) {
            next.add(late_at_);
        }
        if (has_length()) {
            next.add(pause_end_);
        }
        return next;
    }

    /// Whether the ending is there.
    [[nodiscard]] constexpr bool settled() const noexcept
    {
        return has_begun_ and wish_.what == wish::kind::end;
    }

    /// How it ended; `pending` until it is settled.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept
    {
        return settled() ? script_.reason() : altivar::reason{};
    }

    /// Whether it ended as wished.
    [[nodiscard]] constexpr bool succeeded() const noexcept
    {
        return reason().how == ending::succeeded;
    }

protected:
    [[nodiscard]] constexpr Script const& told() const noexcept { return script_; }

private:
    /// The unit was lost: what the script was about to ask, but for a word that stops, would wait until it has stopped by
    /// itself.
    constexpr void heed_loss() noexcept
    {
        if (not has_lost_ or is_asking_) {
            return;
        }
        has_lost_ = false;
        if (not settled() and wish_.does != effect::stopping) {
            take(script_.step({event::kind::failed, 0, errc::unit_lost}));
        }
    }

    /// Whether it is a pause, or a question that may not wait for ever.
    constexpr bool has_length() const noexcept
    {
        return wish_.what == wish::kind::pause or wish_.length.microseconds != 0;
    }

    constexpr event heard(result<response> const& outcome) const noexcept
    {
        if (not outcome) {
            return {event::kind::failed, 0, outcome.error()};
        }
        if (wish_.what == wish::kind::write) {
            return {event::kind::written};
        }
        constexpr std::size_t size_of_one = 4;
        byte_view const pdu = outcome->pdu();
        if (pdu.size() != size_of_one) {
            return {event::kind::failed, 0, errc::wrong_length};
        }
        return {event::kind::word_read, u16_at(pdu, 2)};
    }

    constexpr void take(wish next) noexcept
    {
        // After the limit one question is granted, and no pause.
        bool const is_question = next.what == wish::kind::read or next.what == wish::kind::write;
        if (is_late_ and (next.what == wish::kind::pause or (is_question and was_granted_))) {
            next = script_.give_up();
        }
        was_granted_ = was_granted_ or (is_late_ and is_question);
        if (script_.take_rest()) {
            this->note_rest();
        }
        if (script_.take_fault()) {
            this->note_fault();
        }
        if (Script::is_stop and next.what == wish::kind::end) {
            this->note_stop_over();
        }
        wish_ = next;
        pause_end_ = now_ + next.length;
        if (next.what == wish::kind::read) {
            static_cast<void>(encode_into(frame_, unit_, read_holding_registers{next.address, 1}));
        } else if (next.what == wish::kind::write) {
            static_cast<void>(
                encode_into(frame_, unit_, write_single_register{next.address, next.word}));
        }
    }

    Script script_;
    wish wish_{wish::kind::pause};
    duration limit_;
    instant now_{0};
    instant late_at_{0};
    instant pause_end_{0};
    std::array<std::byte, 8> frame_{};
    unit_id unit_;
    bool has_begun_{false};
    bool is_asking_{false};
    bool has_said_stop_{false};
    bool has_lost_{false};
    bool is_late_{false};
    bool was_warned_{false}; ///< the limit is over, what is left is the script's grace
    bool was_granted_{false};
};

} // namespace rtuwire::altivar

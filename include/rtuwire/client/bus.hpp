// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Many conversations on one line, taking turns question by question. A unit that does not answer is
// asked again only now and then, so that it costs the others no more than a share of the line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client/client.hpp>

namespace rtuwire {

/// How a bus treats units that do not answer.
struct bus_options {
    /// How much of the line's time all silent units together may cost, in percent, 1 to 100.
    std::uint8_t silent_share{10};
    /// After how many questions without an answer a unit counts as silent.
    std::uint8_t silent_after{2};
};

/// How a bus treats one unit.
struct slot_options {
    patience with{};
    /// From the end of a transaction with this unit to the next question to it.
    duration least_idle{};
};

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a
/// client; then `converse` once for every slot in use, in any order; then send what `poll_transmit`
/// gives. Sleep no longer than `poll_deadline` says.
template <std::size_t Slots, typename Statistics = no_statistics> class bus {
    static_assert(Slots > 0 and Slots < 0xFF, "a bus has 1 to 254 slots");

public:
    explicit constexpr bus(line_timing const& line, client_options const& options = {},
                           bus_options const& share = {}) noexcept
        : client_{line, options}, share_{share}
    {
        for (slot& each : slots_) {
            each.options.with.response_timeout = options.response_timeout;
            each.options.with.retries = options.retries;
        }
    }

    /// Sets how one slot's unit is treated. Slots from `Slots` on are ignored.
    constexpr void set(std::size_t index, slot_options const& options) noexcept
    {
        if (index < Slots) {
            slots_[index].options = options;
        }
    }

    constexpr void receive(byte_view octets, instant now) noexcept { client_.receive(octets, now); }
    constexpr void receive_error(instant now) noexcept { client_.receive_error(now); }
    constexpr void sent(instant at) noexcept { client_.sent(at); }
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return client_.line(); }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        now_ = now;
        passed_ = 0;
        for (slot& each : slots_) {
            each.is_resting = each.is_resting and not reached(now, each.not_before);
        }
        is_probe_limited_ = is_probe_limited_ and not reached(now, probe_at_);
        client_.advance(now);
    }

    /// Hands a slot's conversation its outcome, and lets it ask when it is its turn.
    template <conversation Talk>
    constexpr void converse(std::size_t index, Talk& talk, instant now) noexcept
    {
        if (index >= Slots) {
            return;
        }
        deliver(index, talk, now);
        advance_talk(talk, now);
        slot& own = slots_[index];
        own.wake = wake_of(talk);
        if (client_.is_busy() or is_urgent_ or not client_.is_quiet()) {
            return;
        }
        skip_the_absent(index);
        if (index != turn_) {
            return;
        }
        if (is_held_back(own) or not ask(index, talk, own_patience(own), now)) {
            pass_turn();
        }
    }

    /// The same for a conversation that comes before all slots: a broadcast that stops everyone.
    template <conversation Talk> constexpr void converse_first(Talk& talk, instant now) noexcept
    {
        deliver(urgent, talk, now);
        advance_talk(talk, now);
        is_urgent_ = not talk.settled();
        if (is_urgent_ and not client_.is_busy()) {
            static_cast<void>(ask(urgent, talk, slots_[0].options.with, now));
        }
    }

    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return client_.poll_transmit(); }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (client_.is_busy()) {
            return client_.poll_deadline();
        }
        if (passed_ < Slots and has_passed_ and client_.is_quiet()) {
            return now_;
        }
        deadline next = client_.poll_deadline();
        for (slot const& each : slots_) {
            next = earlier(next, each.wake);
        }
        return next;
    }

    /// What was counted, where counting was asked for.
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept
    {
        return client_.statistics();
    }

    /// Whether a slot's unit has not answered for some questions.
    [[nodiscard]] constexpr bool is_silent(std::size_t index) const noexcept
    {
        return index < Slots and is_silent(slots_[index]);
    }

private:
    struct slot {
        slot_options options{};
        instant not_before{};
        deadline wake{};
        bool is_resting{false};
        std::uint8_t failures{0};
    };

    static constexpr std::size_t nobody = 0xFF;
    static constexpr std::size_t urgent = Slots;

    template <typename Talk>
    constexpr void deliver(std::size_t index, Talk& talk, instant now) noexcept
    {
        if (owner_ != index) {
            return;
        }
        auto const outcome = client_.poll_outcome();
        if (not outcome) {
            return;
        }
        owner_ = nobody;
        if (index < Slots) {
            note_health(slots_[index], outcome->error(), now);
        }
        talk.accept(*outcome);
    }

    constexpr void note_health(slot& own, errc error, instant now) noexcept
    {
        bool const is_failure = error != errc::none and not is_exception(error);
        own.failures = not is_failure        ? std::uint8_t{0}
                       : own.failures < 0xFF ? static_cast<std::uint8_t>(own.failures + 1)
                                             : own.failures;
        own.not_before = now + own.options.least_idle;
        own.is_resting = own.options.least_idle.microseconds != 0;
        if (is_silent(own)) {
            // The cost of silence, times what the others get for it.
            std::uint64_t const cost = (now - asked_at_).microseconds;
            std::uint64_t const rest = cost * (100U - share_.silent_share) / share_.silent_share;
            constexpr std::uint64_t longest = 600'000'000;
            probe_at_ =
                now + microseconds(static_cast<std::uint32_t>(rest < longest ? rest : longest));
            is_probe_limited_ = true;
        }
    }

    constexpr bool is_silent(slot const& own) const noexcept
    {
        return own.failures >= share_.silent_after;
    }

    template <typename Talk> static constexpr deadline wake_of(Talk const& talk) noexcept
    {
        if constexpr (timed_conversation<Talk>) {
            return talk.poll_deadline();
        } else {
            return {};
        }
    }

    /// A known-silent unit is asked without repetitions.
    constexpr patience own_patience(slot const& own) const noexcept
    {
        patience with = own.options.with;
        with.retries = is_silent(own) ? std::uint8_t{0} : with.retries;
        return with;
    }

    /// Whether a slot must wait; its wake-up then says until when.
    constexpr bool is_held_back(slot& own) noexcept
    {
        if (own.is_resting) {
            own.wake = earlier(own.wake, own.not_before);
            return true;
        }
        if (is_silent(own) and is_probe_limited_) {
            own.wake = earlier(own.wake, probe_at_);
            return true;
        }
        return false;
    }

    template <typename Talk>
    constexpr bool ask(std::size_t index, Talk& talk, patience with, instant now) noexcept
    {
        auto const question = client_.is_free_for(talk) ? talk.next() : std::nullopt;
        if (not question) {
            return false;
        }
        auto const started = client_.start(*question, now, with);
        if (not started) {
            talk.accept(started.error());
            return false;
        }
        owner_ = index;
        asked_at_ = now;
        if (index < Slots) {
            pass_turn();
            passed_ = 0;
        }
        return true;
    }

    constexpr void pass_turn() noexcept
    {
        turn_ = turn_ + 1 == Slots ? 0 : turn_ + 1;
        waiting_ = nobody;
        has_passed_ = true;
        ++passed_;
    }

    /// A slot that nobody calls `converse` for loses its turn once another came by twice.
    constexpr void skip_the_absent(std::size_t index) noexcept
    {
        if (index == turn_) {
            return;
        }
        if (waiting_ == index) {
            pass_turn();
        } else if (waiting_ == nobody) {
            waiting_ = index;
        }
    }

    basic_client<Statistics> client_;
    bus_options share_;
    std::array<slot, Slots> slots_{};
    instant now_{};
    instant asked_at_{};
    instant probe_at_{};
    std::size_t turn_{0};
    std::size_t owner_{nobody};
    std::size_t waiting_{nobody};
    std::size_t passed_{0};
    bool has_passed_{false};
    bool is_probe_limited_{false};
    bool is_urgent_{false};
};

} // namespace rtuwire

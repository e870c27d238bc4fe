// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that commands motors in the hands of a test: who commands says what the test wants, the clock goes on as the
// test says, and units answer or do not.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "client/hand_clock.hpp"

namespace rtuwire::test {

/// Commands the motor of one unit: one request at a time, with whatever effect is wanted.
struct hand_commander : commander {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};

    effect wanted{effect::none};
    repetition again{repetition::never};
    bool has_request{false};
    bool goes_on{false}; ///< behind its next outcome
    std::uint8_t tolerates{0};
    duration timeout{milliseconds(5'000)}; ///< of its drive
    std::optional<errc> told{};            ///< its last outcome
    unsigned losses{0};                    ///< that it was told of
    frame_bytes frame{};

    explicit hand_commander(unsigned unit, std::uint8_t tolerated = 0)
        : commander{*unit_id::checked(unit)}, tolerates{tolerated}
    {}

    using commander::heed_stop;
    using commander::note_arrangement;
    using commander::note_fault;
    using commander::note_meaning;
    using commander::note_order;
    using commander::note_order_to_run;
    using commander::note_power;
    using commander::note_stop;
    using commander::note_stop_over;
    using commander::unit;
    using commander::was_stopped;

    unsigned of() const { return unit().byte(); }
    effect intent() const { return has_request ? effect_now(wanted) : effect::none; }
    std::optional<request_frame> next()
    {
        if (not has_request) {
            return std::nullopt;
        }
        frame = wanted == effect::none ? read_of(of(), 3'201) : write_of(of(), 8'501, word());
        return request_frame{frame, again};
    }
    void accept(result<response> const& outcome)
    {
        told = outcome.error();
        has_request = false;
    }
    bool settled() const { return not has_request and not goes_on; }
    void note_loss() { ++losses; }
    duration drive_timeout() const { return timeout; }
    bool is_in_force() const { return is_order_in_force(); }
    std::uint8_t tolerated_misses() const { return tolerates; }

private:
    unsigned word() const { return wanted == effect::stopping ? 0 : wanted == effect::resetting ? 128 : 15; }
};

/// Stops everyone: broadcasts, as many as are wanted, and the stops of some units.
struct hand_for_all : commander {
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_all};

    std::array<hand_commander, 1> each;
    bool has_request{false};
    unsigned to{0};             ///< whom its words are for; 0: everyone
    std::optional<errc> told{}; ///< its last outcome
    frame_bytes frame{};
    std::vector<unsigned> unlisted{}; ///< the control words of ordered units that are not its own

    explicit hand_for_all(unsigned unit) : commander{broadcast}, each{hand_commander{unit}} {}

    using commander::note_stop;
    using commander::note_stop_over;

    auto& stops() { return each; }
    effect intent() const { return has_request ? effect::stopping : effect::none; }
    bool is_urgent() const { return has_request; }
    void note_unlisted(std::uint16_t control_word) { unlisted.push_back(control_word); }
    std::uint8_t unit_told() const { return static_cast<std::uint8_t>(to); }
    bool may_cut(std::uint8_t) const { return true; }
    std::optional<request_frame> next()
    {
        if (not has_request) {
            return std::nullopt;
        }
        frame = write_of(to, 8'501, 0);
        return request_frame{frame};
    }
    void accept(result<response> const& outcome)
    {
        told = outcome.error();
        has_request = false;
    }
    bool settled() const { return not has_request; }
};

/// The line, and its times.
template <std::size_t Places> struct command_desk : hand_clock<drive_client<Places>> {
    using base = hand_clock<drive_client<Places>>;
    using base::link;
    using base::now;
    using base::pass;
    using base::time;

    static constexpr client_options options{
        .response_timeout = milliseconds(100), .turnaround = milliseconds(20), .late_response = {}, .retries = 0};

    explicit command_desk(client_options const& with = options, line_timing const& timing = office_line)
        : base{with, timing}
    {}

    /// Comes by and asks nothing.
    template <typename Conversation> void see(Conversation& conversation)
    {
        conversation.has_request = false;
        link.converse(conversation, now());
    }

    /// Wants to say something: whether it leaves at once.
    template <typename Conversation> bool says(Conversation& conversation)
    {
        conversation.has_request = true;
        conversation.told = std::nullopt;
        link.converse(conversation, now());
        return leaves();
    }
    bool says(hand_commander& conversation, effect what)
    {
        conversation.wanted = what;
        return says(conversation);
    }
    bool leaves()
    {
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return false;
        }
        left = frame_bytes{frame.begin(), frame.end()};
        time += office_line.characters(frame.size()).microseconds;
        link.sent(now());
        return true;
    }
    void hear(frame_bytes const& bytes)
    {
        time += 5'000;
        link.receive(bytes, now());
        pass(5'000);
    }

    /// Says it and is answered: `none`; or what it is told instead; nothing where it has to wait.
    std::optional<errc> does(hand_commander& conversation, effect what)
    {
        if (says(conversation, what)) {
            hear(response_to(left));
            link.converse(conversation, now());
        }
        return conversation.told;
    }
    /// Says it and hears nothing. When that was over.
    std::uint64_t misses(hand_commander& conversation, effect what)
    {
        if (not says(conversation, what)) {
            return 0;
        }
        fail(conversation);
        return time;
    }
    template <typename Conversation> void fail(Conversation& conversation)
    {
        pass(200'000);
        link.converse(conversation, now());
    }
    bool is_ordered(unsigned unit) const { return link.motor_orders().is_ordered(static_cast<std::uint8_t>(unit)); }
    bool is_lost(unsigned unit) const { return link.motor_orders().is_lost(static_cast<std::uint8_t>(unit)); }

    /// Orders its motor to run, and its words are answered.
    std::optional<errc> runs(hand_commander& conversation)
    {
        conversation.note_order_to_run();
        return does(conversation, effect::enabling);
    }

    frame_bytes left{}; ///< what was said last
};

} // namespace rtuwire::test

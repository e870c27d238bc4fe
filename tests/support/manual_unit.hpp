// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The other side of a client, played by hand in virtual time: it sees what the client sends and says
// what a unit, noise or nobody would say.
#pragma once

#include "support/asking.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire::test {

inline constexpr line_timing line{19'200, character_format::even_8_1};

/// A client whose line was silent for a second, and its clock, which starts five seconds before it
/// wraps.
template <typename Client> struct basic_manual_unit {
    asking<Client> link;
    instant now{0xFFFF'FFFFU - 5'000'000U};
    unsigned transmissions{0};

    explicit constexpr basic_manual_unit(client_options const& options = {}) : link{line, options}
    {
        link.advance(now);
        pass(milliseconds(1'000));
    }

    /// Lets time pass in one step.
    constexpr void pass(duration length)
    {
        now = now + length;
        link.advance(now);
    }

    /// Lets time pass from deadline to deadline, sending at once whatever the client wants sent.
    constexpr void run(duration length)
    {
        instant const end = now + length;
        while (true) {
            transmit();
            deadline const next = link.poll_deadline();
            if (not next or not reached(end, *next)) {
                break;
            }
            now = reached(now, *next) ? now : *next;
            link.advance(now);
        }
        pass(end - now);
    }

    /// The same for a conversation that comes by in each pass, up to its end.
    template <conversation Conversation> constexpr void run(Conversation& conversation, duration length)
    {
        instant const end = now + length;
        while (true) {
            if (not conversation.settled()) {
                link.converse(conversation, now);
            }
            transmit();
            deadline const next = link.poll_deadline();
            if (not next or not reached(end, *next)) {
                break;
            }
            now = reached(now, *next) ? now : *next;
            link.advance(now);
        }
        pass(end - now);
    }

    /// Whether the client sent a frame; it takes the time it takes.
    constexpr bool transmit()
    {
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return false;
        }
        ++transmissions;
        now = now + line.characters(frame.size());
        link.sent(now);
        return true;
    }

    /// Says bytes, which take their time.
    constexpr void say(byte_view bytes)
    {
        now = now + line.characters(bytes.size());
        link.receive(bytes, now);
        link.advance(now);
    }

    /// Asks, and lets the request leave.
    constexpr bool ask(byte_view request) { return link.start(request_frame{request}, now).has_value() and transmit(); }

    /// The error of the outcome; busy while there is none.
    constexpr errc fault()
    {
        auto const outcome = link.poll_outcome();
        return outcome ? outcome->error() : errc::busy;
    }

    /// Whether there is no outcome.
    constexpr bool none_yet() { return not link.poll_outcome(); }

    /// Whether the outcome is the response that holds this one register.
    constexpr bool has(std::uint16_t value)
    {
        auto const outcome = link.poll_outcome();
        if (not outcome or not *outcome) {
            return false;
        }
        auto const response = (*outcome)->template to<read_holding_registers>();
        return response and response->registers[0] == value;
    }
};

using manual_unit = basic_manual_unit<client>;

inline constexpr auto read_eta = "01 03 0C 81 00 01 D7 72"_hex;
inline constexpr auto read_next = "01 03 0C 82 00 01 27 72"_hex;
inline constexpr auto response_1234 = "01 03 02 12 34 B5 33"_hex;

} // namespace rtuwire::test

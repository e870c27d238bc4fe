// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client's trace says of each kind of frame and of bytes that belong to none.
#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

#include <type_traits>

#include "support/kept_frames.hpp"
#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using test::is;
using test::kept_frames;
using test::line;
using test::read_eta;
using test::read_next;
using test::response_1234;
using role = frame_role;
using verdict = frame_verdict;

namespace {

constexpr auto read_of_2 = "02 03 0C 81 00 01 D7 41"_hex;
constexpr auto response_of_2 = "02 03 02 12 34 F1 33"_hex;
constexpr auto exception_2 = "01 83 02 C0 F1"_hex;
constexpr auto two_registers = "01 03 04 12 34 12 34 B3 F2"_hex;

constexpr client_options impatient{
    .response_timeout = milliseconds(100), .late_response = milliseconds(200), .retries = 0};

using traced_client = client::traced_by<kept_frames>;

struct traced_end {
    kept_frames frames;
    test::basic_manual_unit<traced_client> unit;

    explicit constexpr traced_end(client_options const& options = impatient) : unit{options}
    {
        unit.link.trace_to(frames);
    }
    constexpr bool has(std::size_t index, byte_view bytes, frame_role what, verdict how, bool is_own = false) const
    {
        return frames.has(index, bytes, what, how, is_own);
    }
    /// Bytes arrive, one call for each.
    constexpr void drip(byte_view bytes)
    {
        for (std::byte const each : bytes) {
            unit.now = unit.now + line.characters(1);
            unit.link.receive(each, unit.now);
        }
    }
};

template <typename Engine>
concept can_be_traced = requires(Engine& engine, kept_frames& frames)
{
    engine.trace_to(frames);
};

STATIC_CHECK(std::is_trivially_copyable_v<traced_client> == std::is_trivially_copyable_v<client>);
STATIC_CHECK(not can_be_traced<client>);
STATIC_CHECK(can_be_traced<bus<4>::traced_by<kept_frames>>);
STATIC_CHECK(can_be_traced<host_client::traced_by<kept_frames>>);
STATIC_CHECK(can_be_traced<drive_client<2>::traced_by<kept_frames>>);
STATIC_CHECK(can_be_traced<static_client<line>::traced_by<kept_frames>>);

constexpr bool an_exchange()
{
    traced_end end;
    end.unit.ask(read_eta);
    instant const asked = end.unit.now;
    end.unit.say(response_1234);
    return is(end.has(0, read_eta, role::request, verdict::good, true), "request") and
           is(end.frames.has_at(0, asked), "when it had left") and
           is(end.has(1, response_1234, role::response, verdict::good), "response") and
           is(end.frames.has_at(1, end.unit.now), "when it had come") and is(end.frames.count() == 2, "no more") and
           is(end.unit.has(0x1234), "the outcome");
}
PROOF("a traced client tells its request and the response", an_exchange)

constexpr bool the_end_of_a_frame_that_silence_ended()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.drip("01 03 02 12 34 B5 34"_hex);
    instant const arrived = end.unit.now;
    end.unit.pass(milliseconds(50));
    return end.has(1, "01 03 02 12 34 B5 34"_hex, role::unknown, verdict::damaged) and end.frames.has_at(1, arrived);
}
PROOF("a damaged frame has the time of its last byte, not of the silence behind it",
      the_end_of_a_frame_that_silence_ended)

constexpr bool an_exception()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.say(exception_2);
    return end.has(1, exception_2, role::response, verdict::good) and end.frames.count() == 2;
}
PROOF("an exception is a good response", an_exception)

constexpr bool a_receive_error()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.say("01 03 02"_hex);
    end.unit.link.receive_error(end.unit.now);
    end.unit.pass(milliseconds(50));
    return end.has(1, "01 03 02"_hex, role::unknown, verdict::damaged) and end.frames.count() == 2;
}
PROOF("a frame with a receive error is damaged", a_receive_error)

constexpr bool of_another_unit()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.say(response_of_2);
    end.unit.say(response_1234);
    return is(end.has(1, response_of_2, role::response, verdict::foreign), "foreign") and
           is(end.has(2, response_1234, role::response, verdict::good), "good");
}
PROOF("another unit's response is foreign", of_another_unit)

constexpr bool another_answer()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.say(two_registers);
    return end.has(1, two_registers, role::response, verdict::stray);
}
PROOF("an undamaged response to another question is stray", another_answer)

constexpr bool late_outside()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.run(milliseconds(150));
    end.drip(byte_view{response_1234}.first(2));
    end.unit.say(byte_view{response_1234}.subspan(2));
    end.unit.pass(milliseconds(20));
    end.unit.say("55 AA"_hex);
    return is(end.has(1, "01"_hex, role::response, verdict::late), "its first byte") and
           is(end.has(2, "03"_hex, role::response, verdict::late), "its second byte") and
           is(end.has(3, "02 12 34 B5 33"_hex, role::response, verdict::late), "the rest") and
           is(end.has(4, "55 AA"_hex, role::unknown, verdict::stray), "noise behind it") and end.frames.count() == 5;
}
PROOF("a response after its time-out is late, in the pieces in which it came; what follows silence is stray",
      late_outside)

constexpr bool late_while_another_is_asked()
{
    traced_end end;
    end.unit.ask(read_eta);
    end.unit.run(milliseconds(150));
    static_cast<void>(end.unit.fault());
    end.unit.ask(read_of_2);
    end.unit.say(response_1234);
    end.unit.say(response_of_2);
    return is(end.has(1, read_of_2, role::request, verdict::good, true), "second request") and
           is(end.has(2, response_1234, role::response, verdict::late), "late") and
           is(end.has(3, response_of_2, role::response, verdict::good), "good") and end.unit.has(0x1234);
}
PROOF("a late response is told while another unit is asked", late_while_another_is_asked)

constexpr bool cut_by_the_time_out()
{
    traced_end end{{.response_timeout = milliseconds(20), .retries = 0}};
    end.unit.ask(read_eta);
    end.unit.pass(milliseconds(22));
    end.unit.say("01 03"_hex);
    bool jammed = false;
    for (unsigned i = 0; i < 10 and not jammed; ++i) {
        end.drip("02"_hex);
        end.unit.link.advance(end.unit.now);
        jammed = end.frames.count() > 1;
    }
    std::size_t const cut = end.frames[1].bytes.size();
    end.drip("34"_hex);
    return is(jammed, "cut") and is(end.frames[1].verdict == verdict::late and cut > 2, "what had come of it") and
           is(end.has(2, "34"_hex, role::response, verdict::late), "the rest");
}
PROOF("a response that the time-out cut is late, from its first byte on", cut_by_the_time_out)

constexpr bool given_up()
{
    traced_end end;
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    end.unit.link.cancel(end.unit.now);
    static_cast<void>(end.unit.fault());
    bool const never_left = end.frames.count() == 0;
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    byte_view const frame = end.unit.link.poll_transmit();
    end.unit.pass({});
    end.unit.pass(milliseconds(500)); // `sent` never comes
    return is(never_left, "given up") and
           is(not frame.empty() and end.unit.fault() == errc::transmit_stalled, "stalled") and
           is(end.frames.count() == 0, "nobody knows whether it left");
}
PROOF("a request that did not leave, or of which nobody knows, is not told", given_up)

constexpr bool line_echo()
{
    traced_end end{{.has_line_echo = true}};
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    static_cast<void>(end.unit.link.poll_transmit());
    end.drip(read_eta);
    end.unit.link.sent(end.unit.now);
    end.unit.say(response_1234);
    return is(end.has(0, read_eta, role::request, verdict::echo, true), "echo") and
           is(end.has(1, read_eta, role::request, verdict::good, true), "request") and
           is(end.has(2, response_1234, role::response, verdict::good), "response") and end.frames.count() == 3;
}
PROOF("a line that echoes: the echo in one piece, the request, the response", line_echo)

constexpr bool collided()
{
    traced_end end{{.has_line_echo = true}};
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    static_cast<void>(end.unit.link.poll_transmit());
    end.drip("01 03 8C"_hex);
    end.unit.link.sent(end.unit.now);
    end.unit.say("81 00"_hex);
    end.unit.pass(milliseconds(50));
    return is(end.has(0, "01 03"_hex, role::request, verdict::echo, true), "what came back") and
           is(end.has(1, "8C"_hex, role::unknown, verdict::damaged), "what differs") and
           is(end.has(2, read_eta, role::request, verdict::good, true), "request") and
           is(end.has(3, "81 00"_hex, role::unknown, verdict::damaged), "the rest");
}
PROOF("a collision: the echo up to the byte that differs, and the rest as damaged", collided)

constexpr bool begun_like_an_echo()
{
    traced_end end;
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    static_cast<void>(end.unit.link.poll_transmit());
    end.drip("01 03"_hex);
    end.unit.now = end.unit.now + line.characters(6);
    end.unit.link.sent(end.unit.now);
    end.unit.say(response_1234);
    return is(end.has(0, read_eta, role::request, verdict::good, true), "request") and
           is(end.has(1, "01 03"_hex, role::unknown, verdict::stray), "no echo") and
           is(end.has(2, response_1234, role::response, verdict::good), "response");
}
PROOF("bytes that equal the request's first on a line without echo are stray", begun_like_an_echo)

constexpr bool unexpected_echo()
{
    traced_end end;
    static_cast<void>(end.unit.link.start(request_frame{read_eta}, end.unit.now));
    static_cast<void>(end.unit.link.poll_transmit());
    end.drip(byte_view{read_eta}.first(6));
    end.unit.link.sent(end.unit.now);
    end.drip(byte_view{read_eta}.subspan(6));
    end.unit.pass({});
    return end.has(0, read_eta, role::request, verdict::good, true) and
           end.has(1, read_eta, role::request, verdict::echo, true) and end.unit.fault() == errc::line_echo;
}
PROOF("a request that comes back whole, where no echo is expected, is an echo", unexpected_echo)

constexpr bool leading_noise()
{
    traced_end end{{.max_leading_noise = 2}};
    end.unit.ask(read_eta);
    end.unit.say("FF 01 03 02 12 34 B5 33"_hex);
    return end.has(1, "FF"_hex, role::unknown, verdict::stray) and
           end.has(2, response_1234, role::response, verdict::good) and end.unit.has(0x1234);
}
PROOF("noise that is skipped before a response is stray", leading_noise)

constexpr bool without_a_sink()
{
    test::basic_manual_unit<traced_client> unit{impatient};
    unit.ask(read_eta);
    unit.say(response_1234);
    return unit.has(0x1234);
}
PROOF("a traced client without a sink works as any", without_a_sink)

constexpr bool counts_beside()
{
    kept_frames frames;
    test::basic_manual_unit<basic_client<observed_by<line_statistics>>::traced_by<kept_frames>> unit{impatient};
    unit.link.trace_to(frames);
    unit.ask(read_eta);
    unit.say(response_1234);
    line_statistics const& counted = unit.link.statistics();
    static_assert(std::is_same_v<decltype(unit.link.statistics()), line_statistics&>);
    return frames.count() == 2 and counted.line()[line_event::reply] == 1;
}
PROOF("what a traced client counts is as it was", counts_beside)

} // namespace

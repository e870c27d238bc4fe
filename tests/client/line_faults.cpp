// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Late responses, noise, babble, broadcasts, and being told to stop.
#include <rtuwire/client/client.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using test::line;
using test::manual_unit;
using test::read_eta;
using test::read_next;
using test::response_1234;

namespace {

constexpr auto read_of_2 = "02 03 0C 81 00 01 D7 41"_hex;

constexpr client_options impatient{
    .response_timeout = milliseconds(100), .late_response = milliseconds(200), .retries = 0};

constexpr bool late_response()
{
    manual_unit unit{impatient};
    unit.ask(read_eta);
    unit.run(milliseconds(150));
    bool const silent = unit.fault() == errc::timed_out;
    bool const held =
        unit.link.start(request_frame{read_next}, unit.now).has_value() and unit.link.poll_transmit().empty();
    unit.pass(milliseconds(20));
    unit.say(response_1234);
    bool const dropped = unit.none_yet() and unit.transmissions == 1;
    unit.run(milliseconds(200));
    bool const asked = unit.transmissions == 2;
    unit.say("01 03 02 56 78 87 C6"_hex);
    return silent and held and dropped and asked and unit.has(0x5678);
}
PROOF("a late response never answers the next request to its unit", late_response)

constexpr bool others_need_not_wait()
{
    manual_unit unit{impatient};
    unit.ask(read_eta);
    unit.run(milliseconds(150));
    bool const silent = unit.fault() == errc::timed_out;
    return silent and unit.ask("02 03 0C 81 00 01 D7 41"_hex);
}
PROOF("another unit is asked at once", others_need_not_wait)

constexpr bool ghost_after_repetition()
{
    manual_unit unit{{.response_timeout = milliseconds(100), .late_response = milliseconds(200), .retries = 1}};
    unit.ask(read_eta);
    unit.run(milliseconds(120));
    bool const repeated = unit.transmissions == 2;
    unit.say(response_1234);
    bool const answered = unit.has(0x1234);
    // The unit answers the repetition too.
    static_cast<void>(unit.link.start(request_frame{read_next}, unit.now));
    unit.run(milliseconds(50));
    unit.say(response_1234);
    bool const absorbed = unit.none_yet() and unit.transmissions == 2;
    // It came as late as the first may have come, and 200 ms: some 400 ms after the other.
    unit.run(milliseconds(250));
    bool const held = unit.transmissions == 2;
    unit.run(milliseconds(100));
    return repeated and answered and absorbed and held and unit.transmissions == 3;
}
PROOF("the second response to a repeated request is absorbed", ghost_after_repetition)

constexpr bool idle_noise()
{
    manual_unit unit;
    unit.say(response_1234);
    bool const nothing = unit.none_yet();
    unit.run(milliseconds(10));
    unit.ask(read_eta);
    bool const unaffected = unit.none_yet();
    unit.say("01 03 02 56 78 87 C6"_hex);
    return nothing and unaffected and unit.has(0x5678);
}
PROOF("bytes while idle never answer the next request", idle_noise)

constexpr bool babble()
{
    manual_unit unit{{.response_timeout = milliseconds(100), .retries = 1}};
    unit.ask(read_eta);
    instant const sent = unit.now;
    errc outcome = errc::busy;
    while (outcome == errc::busy and not reached(unit.now, sent + milliseconds(5'000))) {
        unit.say("55"_hex);
        unit.transmit();
        outcome = unit.fault();
    }
    // The time-out, then the wait for a silence that does not come.
    return outcome == errc::bus_jam and unit.transmissions == 1 and reached(sent + milliseconds(250), unit.now);
}
PROOF("a babbling node is reported in time", babble)

constexpr bool broadcasts()
{
    constexpr auto command = "00 06 21 35 00 00 92 29"_hex;
    manual_unit unit{{.turnaround = milliseconds(100)}};
    unit.ask(command);
    unit.pass(milliseconds(50));
    unit.say("00 06 21 35 00 00 92 29"_hex);
    bool const pending = unit.none_yet();
    unit.run(milliseconds(100));
    auto const outcome = unit.link.poll_outcome();
    return pending and outcome and *outcome and (*outcome)->pdu().empty() and unit.transmissions == 1;
}
PROOF("a broadcast succeeds after the turnaround delay, whatever is said", broadcasts)

constexpr bool one_at_a_time()
{
    manual_unit unit;
    unit.ask(read_eta);
    bool const busy = unit.link.start(request_frame{read_next}, unit.now) == errc::busy;
    unit.say(response_1234);
    bool const still = unit.link.start(request_frame{read_next}, unit.now) == errc::busy;
    return busy and still and unit.has(0x1234);
}
PROOF("a second request is refused until the outcome is taken", one_at_a_time)

constexpr bool sizes()
{
    manual_unit unit;
    std::array<std::byte, 257> const bytes{};
    bool const refused =
        unit.link.start(request_frame{byte_view{bytes}.first(3)}, unit.now) == errc::frame_too_short and
        unit.link.start(request_frame{bytes}, unit.now) == errc::frame_too_long;
    return refused and not unit.link.is_busy();
}
PROOF("a request that is no frame is refused and nothing starts", sizes)

constexpr bool cancels()
{
    manual_unit unit{impatient};
    unit.ask(read_eta);
    unit.link.cancel(unit.now);
    bool const cancelled = unit.fault() == errc::cancelled;
    static_cast<void>(unit.link.start(request_frame{read_next}, unit.now));
    unit.run(milliseconds(50));
    unit.say(response_1234);
    bool const not_taken = unit.none_yet() and unit.transmissions == 1;
    unit.link.cancel(unit.now);
    bool const again = unit.fault() == errc::cancelled;
    unit.link.cancel(unit.now);
    return cancelled and not_taken and again and unit.none_yet();
}
PROOF("a cancelled request's answer is not taken for another's", cancels)

constexpr bool stalls()
{
    manual_unit unit{impatient};
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
    bool const wants = not unit.link.poll_transmit().empty();
    unit.pass(milliseconds(0)); // from here on it has its time
    unit.pass(milliseconds(100));
    bool const patient = unit.none_yet();
    unit.pass(milliseconds(5));
    bool const stalled = patient and unit.fault() == errc::transmit_stalled;
    static_cast<void>(unit.link.start(request_frame{read_of_2}, unit.now));
    unit.pass(milliseconds(200));
    return wants and stalled and unit.fault() == errc::transmit_stalled;
}
PROOF("a transmitter that never ends, or never begins, is reported", stalls)

constexpr bool noise_before_sending()
{
    manual_unit unit;
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
    unit.say("00"_hex);
    bool const held = unit.link.poll_transmit().empty();
    unit.pass(line.t3_5());
    return held and not unit.link.poll_transmit().empty();
}
PROOF("noise just before sending holds the request back", noise_before_sending)

/// Asks for two registers, one after the other.
struct two_requests : asker {
    single_request<read_holding_registers> first{unit_id{1}, {0x0C81, 1}};
    single_request<read_holding_registers> second{unit_id{1}, {0x0C82, 1}};
    unsigned outcomes{0};

    constexpr bool settled() const { return second.settled(); }

    constexpr std::optional<request_frame> next() const { return first.settled() ? second.next() : first.next(); }
    constexpr void accept(result<response> const& outcome)
    {
        ++outcomes;
        if (first.settled()) {
            second.accept(outcome);
        } else {
            first.accept(outcome);
        }
    }
};

constexpr bool converses()
{
    manual_unit unit;
    two_requests conversation;
    for (unsigned pass = 0; pass < 2; ++pass) {
        unit.run(milliseconds(10));
        unit.link.converse(conversation, unit.now);
        unit.run(milliseconds(10));
        unit.say(response_1234);
        unit.link.converse(conversation, unit.now);
    }
    return conversation.outcomes == 2 and unit.transmissions == 2 and conversation.second.outcome() and
           not unit.link.is_busy();
}
PROOF("a conversation of two requests is run in order", converses)

constexpr bool unencodable()
{
    single_request conversation{unit_id{1}, read_holding_registers{0, 126}};
    manual_unit unit;
    unit.link.converse(conversation, unit.now);
    return conversation.outcome() == errc::invalid_quantity and not unit.link.is_busy();
}
PROOF("a request that cannot be encoded is never asked", unencodable)

} // namespace

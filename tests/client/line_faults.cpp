// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Late answers, noise, babble, broadcasts, and being told to stop.
#include <rtuwire/client/client.hpp>

#include "support/far_end.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using test::answer_1234;
using test::far_end;
using test::line;
using test::read_eta;
using test::read_next;

namespace {

constexpr auto read_of_2 = "02 03 0C 81 00 01 D7 41"_hex;

constexpr client_options impatient{
    .response_timeout = milliseconds(100), .late_answer = milliseconds(200), .retries = 0};

constexpr bool late_answer()
{
    far_end unit{impatient};
    unit.ask(read_eta);
    unit.run(milliseconds(150));
    bool const silent = unit.fault() == errc::timed_out;
    bool const held = unit.link.start(request{read_next}, unit.now).has_value() and
                      unit.link.poll_transmit().empty();
    unit.pass(milliseconds(20));
    unit.say(answer_1234);
    bool const dropped = unit.fault() == errc::busy and unit.transmissions == 1;
    unit.run(milliseconds(200));
    bool const asked = unit.transmissions == 2;
    unit.say("01 03 02 56 78 87 C6"_hex);
    return silent and held and dropped and asked and unit.has(0x5678);
}
PROOF("a late answer never answers the next question to its unit", late_answer)

constexpr bool others_need_not_wait()
{
    far_end unit{impatient};
    unit.ask(read_eta);
    unit.run(milliseconds(150));
    bool const silent = unit.fault() == errc::timed_out;
    return silent and unit.ask("02 03 0C 81 00 01 D7 41"_hex);
}
PROOF("another unit is asked at once", others_need_not_wait)

constexpr bool ghost_after_repetition()
{
    far_end unit{
        {.response_timeout = milliseconds(100), .late_answer = milliseconds(200), .retries = 1}};
    unit.ask(read_eta);
    unit.run(milliseconds(120));
    bool const repeated = unit.transmissions == 2;
    unit.say(answer_1234);
    bool const answered = unit.has(0x1234);
    // The unit answers the repetition too.
    static_cast<void>(unit.link.start(request{read_next}, unit.now));
    unit.run(milliseconds(50));
    unit.say(answer_1234);
    bool const absorbed = unit.fault() == errc::busy and unit.transmissions == 2;
    // It came as late as the first may have come, and 200 ms: some 400 ms after the other.
    unit.run(milliseconds(250));
    bool const held = unit.transmissions == 2;
    unit.run(milliseconds(100));
    return repeated and answered and absorbed and held and unit.transmissions == 3;
}
PROOF("the second answer to a repeated question is absorbed", ghost_after_repetition)

constexpr bool idle_noise()
{
    far_end unit;
    unit.say(answer_1234);
    bool const nothing = unit.fault() == errc::busy;
    unit.run(milliseconds(10));
    unit.ask(read_eta);
    bool const unaffected = unit.fault() == errc::busy;
    unit.say("01 03 02 56 78 87 C6"_hex);
    return nothing and unaffected and unit.has(0x5678);
}
PROOF("octets while idle never answer the next question", idle_noise)

constexpr bool babble()
{
    far_end unit{{.response_timeout = milliseconds(100), .retries = 1}};
    unit.ask(read_eta);
    instant const sent = unit.now;
    errc outcome = errc::busy;
    while (outcome == errc::busy and not reached(unit.now, sent + milliseconds(5'000))) {
        unit.say("55"_hex);
        unit.transmit();
        outcome = unit.fault();
    }
    // The time-out, then the wait for a silence that does not come.
    return outcome == errc::bus_jam and unit.transmissions == 1 and
           reached(sent + milliseconds(250), unit.now);
}
PROOF("a babbling node is reported in time", babble)

constexpr bool broadcasts()
{
    constexpr auto command = "00 06 21 35 00 00 92 29"_hex;
    far_end unit{{.turnaround = milliseconds(100)}};
    unit.ask(command);
    unit.pass(milliseconds(50));
    unit.say("00 06 21 35 00 00 92 29"_hex);
    bool const pending = unit.fault() == errc::busy;
    unit.run(milliseconds(100));
    auto const outcome = unit.link.poll_outcome();
    return pending and outcome and *outcome and (*outcome)->pdu().empty() and
           unit.transmissions == 1;
}
PROOF("a broadcast succeeds after the turnaround delay, whatever is said", broadcasts)

constexpr bool one_at_a_time()
{
    far_end unit;
    unit.ask(read_eta);
    bool const busy = unit.link.start(request{read_next}, unit.now) == errc::busy;
    unit.say(answer_1234);
    bool const still = unit.link.start(request{read_next}, unit.now) == errc::busy;
    return busy and still and unit.has(0x1234);
}
PROOF("a second question is refused until the outcome is taken", one_at_a_time)

constexpr bool sizes()
{
    far_end unit;
    std::array<std::byte, 257> const octets{};
    bool const refused =
        unit.link.start(request{byte_view{octets}.first(3)}, unit.now) == errc::frame_too_short and
        unit.link.start(request{octets}, unit.now) == errc::frame_too_long;
    return refused and not unit.link.is_busy();
}
PROOF("a request that is no frame is refused and nothing starts", sizes)

constexpr bool cancels()
{
    far_end unit{impatient};
    unit.ask(read_eta);
    unit.link.cancel(unit.now);
    bool const cancelled = unit.fault() == errc::cancelled;
    static_cast<void>(unit.link.start(request{read_next}, unit.now));
    unit.run(milliseconds(50));
    unit.say(answer_1234);
    bool const not_taken = unit.fault() == errc::busy and unit.transmissions == 1;
    unit.link.cancel(unit.now);
    bool const again = unit.fault() == errc::cancelled;
    unit.link.cancel(unit.now);
    return cancelled and not_taken and again and unit.fault() == errc::busy;
}
PROOF("a cancelled question's answer is not taken for another's", cancels)

constexpr bool stalls()
{
    far_end unit{impatient};
    static_cast<void>(unit.link.start(request{read_eta}, unit.now));
    bool const wants = not unit.link.poll_transmit().empty();
    unit.pass(milliseconds(0)); // from here on it has its time
    unit.pass(milliseconds(100));
    bool const patient = unit.fault() == errc::busy;
    unit.pass(milliseconds(5));
    bool const stalled = patient and unit.fault() == errc::transmit_stalled;
    static_cast<void>(unit.link.start(request{read_of_2}, unit.now));
    unit.pass(milliseconds(200));
    return wants and stalled and unit.fault() == errc::transmit_stalled;
}
PROOF("a transmitter that never ends, or never begins, is reported", stalls)

constexpr bool noise_before_sending()
{
    far_end unit;
    static_cast<void>(unit.link.start(request{read_eta}, unit.now));
    unit.say("00"_hex);
    bool const held = unit.link.poll_transmit().empty();
    unit.pass(line.t3_5());
    return held and not unit.link.poll_transmit().empty();
}
PROOF("noise just before sending holds the request back", noise_before_sending)

/// Asks for two registers, one after the other.
struct two_questions : asker {
    single_question<read_holding_registers> first{unit_id{1}, {0x0C81, 1}};
    single_question<read_holding_registers> second{unit_id{1}, {0x0C82, 1}};
    unsigned outcomes{0};

    constexpr bool settled() const { return second.settled(); }

    constexpr std::optional<request> next() const
    {
        return first.settled() ? second.next() : first.next();
    }
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
    far_end unit;
    two_questions talk;
    for (unsigned pass = 0; pass < 2; ++pass) {
        unit.run(milliseconds(10));
        unit.link.converse(talk, unit.now);
        unit.run(milliseconds(10));
        unit.say(answer_1234);
        unit.link.converse(talk, unit.now);
    }
    return talk.outcomes == 2 and unit.transmissions == 2 and talk.second.outcome() and
           not unit.link.is_busy();
}
PROOF("a conversation of two questions is run in order", converses)

constexpr bool unencodable()
{
    single_question talk{unit_id{1}, read_holding_registers{0, 126}};
    far_end unit;
    unit.link.converse(talk, unit.now);
    return talk.outcome() == errc::invalid_quantity and not unit.link.is_busy();
}
PROOF("a question that cannot be encoded is never asked", unencodable)

} // namespace

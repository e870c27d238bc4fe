// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A response that comes after its time is never taken for the response to another request. Each answer carries the
// number of the request that it belongs to, outside of its bytes; the test holds it against the number of the
// request whose outcome the client says it is.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

frame_bytes request_of(unsigned function, unsigned unit, unsigned number)
{
    unsigned const value = number % 3U;
    switch (function) {
    case 3: return read_of(unit, 3201 + value);
    case 6: return write_of(unit, 8602, 100 + number % 2U);
    case 16: return framed({unit, 16, 0x21, 0x9A, 0, 1, 2, 0, value});
    case 22: return framed({unit, 22, 0x21, 0x9A, 0xFF, value, 0, value});
    default: break;
    }
    return framed({unit, 23, 0x0C, 0x81, 0, 1, 0x21, 0x9A, 0, 1, 2, 0, value});
}

/// A unit that answers one request after the other, each the same time after it could begin.
struct slow_unit {
    std::uint64_t latency;
    std::uint64_t free_at{0};

    std::uint64_t answers_at(std::uint64_t now)
    {
        free_at = std::max(now, free_at) + latency;
        return free_at;
    }
};

struct tally {
    unsigned wrong{0};
    unsigned asked{0};
    unsigned answered{0};
};

/// Ten requests of one function to a unit of this latency, with a client that is told nothing.
tally of_client(unsigned function, std::uint64_t latency)
{
    scripted_line<client> line{client{office_line}, office_line};
    slow_unit unit{latency};
    tally found;
    series conversation{[&](unsigned number) { return request_of(function, 1, number); }, 10};
    line.heard = [&](frame_bytes const& frame) {
        frame_bytes const response = response_to(frame);
        line.arrive(unit.answers_at(line.time()) + line.length_of(response.size()), response,
                    static_cast<int>(conversation.number));
    };
    conversation.took = [&](unsigned number, result<response> const& outcome) {
        ++found.asked;
        found.answered += outcome ? 1U : 0U;
        found.wrong += outcome and line.last_tag != static_cast<int>(number) ? 1U : 0U;
    };
    line.run(200'000'000, [&](instant now) { line.link.converse(conversation, now); });
    return found;
}

/// The same on a bus with a unit that answers at once.
tally of_bus(unsigned function, std::uint64_t latency, unsigned& others)
{
    scripted_line<bus<2>> line{bus<2>{office_line}, office_line};
    slow_unit unit{latency};
    tally found;
    series conversation{[&](unsigned number) { return request_of(function, 1, number); }, 6};
    series other{[&](unsigned number) { return read_of(2, 100 + number % 5U); }};
    line.heard = [&](frame_bytes const& frame) {
        frame_bytes const response = response_to(frame);
        bool const is_slow = at(frame, 0) == 1;
        std::uint64_t const begin = is_slow ? unit.answers_at(line.time()) : line.time() + 5'000;
        line.arrive(begin + line.length_of(response.size()), response,
                    static_cast<int>(is_slow ? conversation.number : other.number));
    };
    auto const judge = [&](unsigned number, result<response> const& outcome) {
        found.wrong += outcome and line.last_tag != static_cast<int>(number) ? 1U : 0U;
    };
    conversation.took = [&](unsigned number, result<response> const& outcome) {
        ++found.asked;
        found.answered += outcome ? 1U : 0U;
        judge(number, outcome);
    };
    other.took = judge;
    line.run(60'000'000, [&](instant now) {
        line.link.converse(0, conversation, now);
        line.link.converse(1, other, now);
    });
    others = other.answered;
    return found;
}

/// A response that comes while its repetition leaves is lost on two wires.
bool is_lost(std::uint64_t latency) { return latency < 1'020; }

} // namespace

TEST_CASE("defect: D1 the answer to a repetition is never the value of the next question")
{
    for (unsigned const function : {3U, 6U, 16U, 22U, 23U}) {
        unsigned wrong = 0;
        unsigned without = 0;
        for (std::uint64_t latency = 1'005; latency <= 1'900; latency += 5) {
            tally const found = of_client(function, 1'000 * latency);
            wrong += found.wrong;
            without += is_lost(latency) or found.answered == 10 ? 0U : 1U;
        }
        INFO("function " << function);
        CHECK(wrong == 0);
        CHECK(without == 0);
    }
}

TEST_CASE("defect: D1 the same on a bus, where another unit is asked all the time", "[rest]")
{
    for (unsigned const function : {3U, 6U, 16U, 22U, 23U}) {
        unsigned wrong = 0;
        unsigned without = 0;
        unsigned hindered = 0;
        for (std::uint64_t latency = 1'005; latency <= 1'900; latency += 5) {
            unsigned others = 0;
            tally const found = of_bus(function, 1'000 * latency, others);
            wrong += found.wrong;
            without += is_lost(latency) or found.answered != 0 ? 0U : 1U;
            hindered += others < 1'000 ? 1U : 0U;
        }
        INFO("function " << function);
        CHECK(wrong == 0);
        CHECK(without == 0);
        CHECK(hindered == 0);
    }
}

TEST_CASE("defect: D1 a late answer of another unit, damaged so that it seems to be of this one, pays for nothing")
{
    client_options const options{
        .response_timeout = milliseconds(500), .late_response = milliseconds(100), .retries = 1};
    scripted_line<client> line{client{office_line, options}, office_line};
    slow_unit unit{400'000};
    frame_bytes late = response_to(read_of(3, 3201, 2));
    late[0] = std::byte{2};
    unsigned wrong = 0;
    series off{[](unsigned) { return read_of(3, 3201, 2); }, 1};
    series conversation{[](unsigned number) { return read_of(2, 100 + number); }, 4};
    conversation.took = [&](unsigned number, result<response> const& outcome) {
        wrong += outcome and line.last_tag != static_cast<int>(number) ? 1U : 0U;
    };
    line.heard = [&](frame_bytes const& frame) {
        if (at(frame, 0) == 3) {
            return;
        }
        if (line.departures.size() == 2) {
            line.say(3'000, late);
        }
        frame_bytes const response = response_to(frame);
        line.arrive(unit.answers_at(line.time()) + line.length_of(response.size()), response,
                    static_cast<int>(conversation.number));
    };
    retry_policy const once{.response_timeout = milliseconds(500), .retries = 0};
    line.run(10'000'000, [&](instant now) {
        line.link.converse(off, now, once);
        if (off.settled()) {
            line.link.converse(conversation, now);
        }
    });
    CHECK(off.last == errc::timed_out);
    CHECK(conversation.number == 4);
    CHECK(conversation.answered >= 3);
    CHECK(wrong == 0);
}

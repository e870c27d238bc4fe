// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit that answers some registers late and others at once, so that its answers overtake each other: what it answers late is
// never taken for the answer to another request of the same form. Each register holds its address, so that a value tells whose it is.
#include "defect/client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr unsigned slow_register = 100;
constexpr unsigned prompt_register = 200;
constexpr std::uint64_t prompt = 5'000;

struct tally {
    unsigned wrong{0};
    unsigned answered{0};
};

/// Reads a register, or several in turn, of one unit, and counts which values are another register's.
series reader(unsigned unit, unsigned address, unsigned registers, unsigned most, tally& of)
{
    series made{[=](unsigned number) { return read_of(unit, address + number % registers); }, most};
    made.took = [=, &of](unsigned number, result<response> const& outcome) {
        of.answered += outcome ? 1U : 0U;
        of.wrong += outcome and u16_at(outcome->pdu(), 2) != address + number % registers ? 1U : 0U;
    };
    return made;
}

/// Each answer of the unit comes so long after its request as its register says, whatever comes before it. Late ones may come
/// byte by byte.
template <typename Link>
void answer_out_of_order(scripted_line<Link>& line, std::uint64_t late, unsigned unit = 1, bool in_pieces = false)
{
    line.heard = [=, &line](frame_bytes const& frame) {
        bool const is_late = word_at(frame, 2) == slow_register and at(frame, 0) == unit;
        frame_bytes const response = response_to(frame);
        if (not is_late or not in_pieces) {
            return line.say(is_late ? late : prompt, response);
        }
        for (std::size_t i = 0; i < response.size(); ++i) {
            line.say(late + line.length_of(i), {response[i]});
        }
    };
}

client_options options_of(unsigned retries)
{
    return {
        .response_timeout = milliseconds(500), .late_response = milliseconds(200), .retries = std::uint8_t(retries)};
}

/// From the moment on at which none of the sendings is answered in time until none would be held for the first answer.
template <typename Try> void for_each_lateness(unsigned retries, Try try_it)
{
    std::uint64_t const sendings = retries + 1U;
    for (std::uint64_t late = 500'000 * sendings + 20'000; late < 700'000 * sendings; late += 5'000) {
        try_it(late);
    }
}

/// One read of the slow register, then reads of others until the time is over, at each lateness.
template <typename Series, typename Link> void check_late_answers(unsigned unit, bool in_pieces)
{
    for (unsigned const retries : {1U, 2U, 3U}) {
        tally slow, fast;
        for_each_lateness(retries, [&](std::uint64_t late) {
            scripted_line<Link> line{Link{office_line, options_of(retries)}, office_line};
            answer_out_of_order(line, late, unit, in_pieces);
            Series once{reader(unit, slow_register, 1, 1, slow)};
            Series often{reader(unit, prompt_register, 50, 1'000, fast)};
            line.run(12'000'000, [&](instant now) {
                line.link.converse(once, now);
                if (once.settled()) {
                    line.link.converse(often, now);
                }
            });
        });
        CAPTURE(retries);
        CHECK(fast.wrong == 0);
        CHECK(fast.answered > 10'000);
    }
}

struct alone_on_its_line : series {
    static constexpr bool asks_only_unit = true;
    explicit alone_on_its_line(series const& of) : series{of} {}
};
inline constexpr client_needs<> of_only_unit{.has_only_unit = true};

} // namespace

TEST_CASE("defect: of two late answers none is another request's, where the answers overtake each other")
{
    check_late_answers<series, client>(1, false);
}

TEST_CASE("defect: the same where the late answers come byte by byte") { check_late_answers<series, client>(1, true); }

TEST_CASE("defect: the same of the only unit of a line, at address 0")
{
    check_late_answers<alone_on_its_line, basic_client<of_only_unit>>(0, false);
}

TEST_CASE("defect: the same on a bus, where a late answer comes while another unit is asked")
{
    for (unsigned const retries : {1U, 2U}) {
        tally slow, fast, other;
        for_each_lateness(retries, [&](std::uint64_t late) {
            scripted_line<bus<3>> line{bus<3>{office_line, options_of(retries)}, office_line};
            answer_out_of_order(line, late);
            series once = reader(1, slow_register, 1, 1, slow);
            series often = reader(1, prompt_register, 50, 1'000, fast);
            series beside = reader(2, prompt_register, 50, 5'000, other);
            line.run(12'000'000, [&](instant now) {
                line.link.converse(0, once, now);
                if (once.settled()) {
                    line.link.converse(1, often, now);
                }
                line.link.converse(2, beside, now);
            });
        });
        CAPTURE(retries);
        CHECK(fast.wrong == 0);
        CHECK(other.wrong == 0);
        CHECK(fast.answered > 10'000);
    }
}

TEST_CASE("a unit that babbles is held no longer than all its sendings may take, once for each")
{
    for (std::uint64_t const every : {100'000U, 400'000U, 699'000U, 1'000'000U, 1'399'000U, 2'500'000U}) {
        scripted_line<client> line{client{office_line, options_of(1)}, office_line};
        tally never, again;
        series once = reader(1, slow_register, 1, 1, never);
        series next = reader(1, prompt_register, 1, 1, again);
        for (std::uint64_t at = every; at < 30'000'000; at += every) {
            line.say(at, framed({1, 4, 2, 0, 0})); // a response to a function that nobody asks for
        }
        line.run(30'000'000, [&](instant now) {
            line.link.converse(once, now);
            if (once.settled()) {
                line.link.converse(next, now);
            }
        });
        CAPTURE(every);
        REQUIRE(line.departures.size() >= 3);
        // Two sendings, each with its time-out, L and what it takes on the line; then what is left of one, of no more than both and L.
        std::uint64_t const both = 2 * (500'000 + 700'000 + line.length_of(15) + 10'000);
        CHECK(line.departures[2].begin - line.departures[0].begin < both + both + 200'000 + every);
        CHECK(next.settled());
    }
}

TEST_CASE("where a unit's late answers have all come it is asked once its first hold is over")
{
    scripted_line<client> line{client{office_line, options_of(1)}, office_line};
    answer_out_of_order(line, 520'000); // the first one while the repetition waits
    tally slow, fast;
    series once = reader(1, slow_register, 1, 1, slow);
    series next = reader(1, prompt_register, 1, 1, fast);
    line.run(3'000'000, [&](instant now) {
        line.link.converse(once, now);
        if (once.settled()) {
            line.link.converse(next, now);
        }
    });
    CHECK(slow.answered == 1);
    CHECK(fast.answered == 1);
    CHECK(line.departures.size() == 3);
    CHECK(line.departures[2].begin - line.departures[0].begin < 2 * 520'000 + 200'000 + 30'000);
}

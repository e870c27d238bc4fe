// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// When a bus asks a silent unit again, to the microsecond, and from when on a unit counts as silent.
#include <rtuwire/client/bus.hpp>

#include <array>
#include <cstdint>
#include <optional>

#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
// No response comes late: the unit may be asked again as soon as its turn comes.
constexpr client_options once{.response_timeout = milliseconds(50), .late_response = {}, .retries = 0};

/// Asks the same for ever.
struct endless : asker {
    single_request<read_holding_registers> request;
    unsigned answers{0};
    unsigned failures{0};

    explicit constexpr endless(std::uint32_t unit) : request{*unit_id::checked(unit), read_holding_registers{3201, 1}}
    {}
    constexpr std::optional<request_frame> next() const { return request.next(); }
    constexpr void accept(result<response> const& outcome)
    {
        answers += outcome ? 1U : 0U;
        failures += outcome ? 0U : 1U;
    }
    static constexpr bool settled() { return false; }
};

/// One slot, whose unit answers as far as it is told to. Goes from deadline to deadline.
struct lonely {
    bus<1> link;
    endless conversation{7};
    bool is_answering{false};
    instant now{0xFFFF'FF00};
    instant asked_at{0};
    instant ended_at{0};

    explicit constexpr lonely(bus_options const& share = {}, client_options const& options = once)
        : link{line, options, share}
    {}

    /// False where the bus wants to sleep for ever.
    constexpr bool pass()
    {
        unsigned const outcomes = conversation.failures + conversation.answers;
        link.advance(now);
        link.converse(0, conversation, now);
        ended_at = conversation.failures + conversation.answers != outcomes ? now : ended_at;
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            asked_at = now;
            transmit(to_u8(frame[0]), frame.size());
            return true;
        }
        deadline const next = link.poll_deadline();
        now = next and not reached(now, *next) ? *next : now;
        return next.has_value();
    }

    constexpr bool fails(unsigned times)
    {
        for (unsigned const all = conversation.failures + times; conversation.failures != all;) {
            if (not pass()) {
                return false;
            }
        }
        return true;
    }
    constexpr bool answers(unsigned times)
    {
        is_answering = true;
        for (unsigned const all = conversation.answers + times; conversation.answers != all;) {
            if (not pass()) {
                return false;
            }
        }
        is_answering = false;
        return true;
    }

private:
    constexpr void transmit(std::uint8_t unit, std::size_t size)
    {
        now = now + line.characters(size);
        link.sent(now);
        if (is_answering) {
            register_block const word{0x0237};
            std::array<std::byte, 8> place{};
            now = now + milliseconds(4);
            link.receive(*encode_into(place, *unit_id::checked(unit), read_holding_registers_response{word}), now);
        }
    }
};

/// From the end of a loss to the next request, and what the loss took.
struct rest {
    std::uint64_t length, cost;
};
constexpr rest rest_after_a_loss(bus_options const& share, client_options const& options = once)
{
    lonely it{share, options};
    bool ok = it.fails(2);
    duration const cost = it.ended_at - it.asked_at;
    instant const end = it.ended_at;
    while (ok and not reached(it.asked_at, end)) {
        ok = it.pass();
    }
    return ok ? rest{(it.asked_at - end).microseconds, cost.microseconds} : rest{0, 0};
}

/// So much that the loss is the share of it and the rest together, and a tenth of a millisecond more at most.
constexpr bool is_share(rest const& of, std::uint64_t percent)
{
    std::uint64_t const least = of.cost * (100 - percent);
    return of.cost >= 50'000 and of.length * percent >= least and of.length * percent <= least + 100 * percent;
}
constexpr bool leaves_the_line_to_the_others()
{
    return is_share(rest_after_a_loss({}), 10) and is_share(rest_after_a_loss({.silent_share = 1}), 1) and
           is_share(rest_after_a_loss({.silent_share = 50}), 50) and
           is_share(rest_after_a_loss({.silent_share = 99}), 99);
}
PROOF("a silent unit is asked again when its last loss is its share of the time, and no later",
      leaves_the_line_to_the_others)

constexpr bool rests_ten_minutes_at_most()
{
    rest const most = rest_after_a_loss({.silent_share = 1},
                                        {.response_timeout = milliseconds(7'000), .late_response = {}, .retries = 0});
    rest const nearly = rest_after_a_loss({.silent_share = 1},
                                          {.response_timeout = milliseconds(5'950), .late_response = {}, .retries = 0});
    return most.length == 600'000'000 and is_share(nearly, 1);
}
PROOF("a loss of seconds costs ten minutes at most", rests_ten_minutes_at_most)

/// The longest loss whose share is not cut: rule 29 gives (6 060 605 / 1 + 1) x 99 us for it, 6 us below ten minutes.
constexpr bool rests_no_longer_than_its_share()
{
    constexpr std::uint32_t longest_cost = 6'060'605, some_timeout = 5'950'000;
    constexpr auto after = [](std::uint32_t timeout) {
        return rest_after_a_loss({.silent_share = 1},
                                 {.response_timeout = microseconds(timeout), .late_response = {}, .retries = 0});
    };
    auto const more = static_cast<std::uint32_t>(after(some_timeout).cost) - some_timeout;
    rest const uncut = after(longest_cost - more), cut = after(longest_cost - more + 1);
    return uncut.cost == longest_cost and uncut.length == 599'999'994 and cut.cost == longest_cost + 1 and
           cut.length == 600'000'000;
}
PROOF("ten minutes take the place of what is longer, and of nothing shorter", rests_no_longer_than_its_share)

constexpr bool counts_from_the_first_response()
{
    lonely foreign_unit;
    bool ok = not foreign_unit.link.is_silent(0) and not foreign_unit.link.is_silent(1);
    ok = ok and foreign_unit.fails(1) and foreign_unit.link.is_silent(0);
    ok = ok and foreign_unit.answers(1) and not foreign_unit.link.is_silent(0);
    ok = ok and foreign_unit.fails(1) and not foreign_unit.link.is_silent(0);
    ok = ok and foreign_unit.fails(1) and foreign_unit.link.is_silent(0);
    ok = ok and foreign_unit.answers(1) and foreign_unit.fails(1) and not foreign_unit.link.is_silent(0);
    return ok and foreign_unit.answers(1) and foreign_unit.fails(1) and not foreign_unit.link.is_silent(0);
}
PROOF("who never answered is silent after one request, who did after two in a row", counts_from_the_first_response)

constexpr bool asks_at_once_who_is_not_silent()
{
    lonely it;
    bool ok = it.answers(1) and it.fails(1);
    instant const end = it.ended_at;
    while (ok and not reached(it.asked_at, end)) {
        ok = it.pass();
    }
    return ok and it.asked_at - end < milliseconds(5);
}
PROOF("one lost response of a unit that answered puts nothing off", asks_at_once_who_is_not_silent)

constexpr bool forgets_the_unit_before(std::uint32_t before, std::uint32_t after)
{
    lonely it;
    it.conversation = endless{before};
    bool ok = it.answers(3);
    it.conversation = endless{after};
    for (instant const last = it.asked_at; ok and it.asked_at == last;) {
        ok = it.pass() and not it.link.is_silent(0);
    }
    return ok and it.fails(1) and it.link.is_silent(0);
}
constexpr bool keeps_the_health_of_one_unit()
{
    return forgets_the_unit_before(1, 2) and forgets_the_unit_before(2, 1) and forgets_the_unit_before(247, 246);
}
PROOF("a slot that asks another unit knows nothing of it", keeps_the_health_of_one_unit)

/// A slot that rests: its next request comes so long after the end of the last transaction, no sooner.
constexpr bool rests_between_requests()
{
    lonely it;
    it.link.set(1, {.least_idle = milliseconds(9'999)});
    it.link.set(0, {.with = {milliseconds(50), 0}, .least_idle = milliseconds(200)});
    bool ok = it.answers(1);
    instant const end = it.ended_at;
    ok = ok and it.answers(1);
    return ok and it.asked_at - end >= milliseconds(200) and it.asked_at - end <= milliseconds(201);
}
PROOF("a unit has its idle time, to the millisecond", rests_between_requests)

} // namespace

TEST_CASE("a unit stays silent however often it does not answer")
{
    lonely it;
    for (unsigned i = 0; i < 600; ++i) {
        REQUIRE(it.fails(1));
        REQUIRE(it.link.is_silent(0));
    }
}

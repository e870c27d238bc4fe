// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Turns on a line: fairness, a retry policy by unit, and what a silent unit may cost.
#include <rtuwire/client/bus.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};

/// Asks the same for ever, and counts.
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

/// What unit 3 says where it refuses, by a code that no document has.
constexpr auto refusal = "03 83 80 E1 50"_hex;

/// Three conversations on one line, played by hand: units from `silent_from` on say nothing.
struct three {
    bus<3> link;
    std::array<endless, 3> conversations{endless{1}, endless{2}, endless{3}};
    unsigned silent_from{4};
    unsigned refusing{0};
    instant now{0xFFFF'FF00};
    std::array<std::uint8_t, 64> order{};
    std::size_t asked{0};

    explicit constexpr three(bus_options const& options = {})
        : link{line, {.response_timeout = milliseconds(50), .retries = 1}, options}
    {}

    constexpr void pass()
    {
        link.advance(now);
        for (std::size_t i = 0; i < conversations.size(); ++i) {
            link.converse(i, conversations[i], now);
        }
        transmit();
        deadline const next = link.poll_deadline();
        now = next and not reached(now, *next) ? *next : now + microseconds(100);
    }

    constexpr void transmit()
    {
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return;
        }
        auto const unit = to_u8(frame[0]);
        order[asked % order.size()] = unit;
        ++asked;
        now = now + line.characters(frame.size());
        link.sent(now);
        if (unit == refusing) {
            now = now + milliseconds(4);
            link.receive(refusal, now);
        } else if (unit != 0 and unit < silent_from) {
            register_block const word{0x0237};
            std::array<std::byte, 8> place{};
            auto const response = encode_into(place, *unit_id::checked(unit), read_holding_registers_response{word});
            now = now + milliseconds(4);
            link.receive(*response, now);
        }
    }
};

constexpr bool takes_turns()
{
    three all;
    while (all.asked < 30) {
        all.pass();
    }
    for (std::size_t i = 0; i < 30; ++i) {
        if (all.order[i] != 1 + i % 3) {
            return false;
        }
    }
    return all.conversations[0].answers == 10 and all.conversations[2].answers >= 9;
}
PROOF("conversations take turns, one request each", takes_turns)

constexpr bool limits_silence(std::uint8_t share, std::uint32_t at_most)
{
    three all{bus_options{share}};
    all.silent_from = 3;
    instant const start = all.now;
    std::uint64_t lost = 0;
    while ((all.now - start) < milliseconds(1'500)) {
        unsigned const failures = all.conversations[2].failures;
        all.pass();
        lost += all.conversations[2].failures - failures;
    }
    // The first silence costs two attempts of about 57 ms each, later ones one.
    return lost >= 2 and lost * 57 <= at_most and all.conversations[0].answers > 25 and all.link.is_silent(2) and
           not all.link.is_silent(0);
}
constexpr bool limits_silence_to_ten_percent() { return limits_silence(10, 400); }
constexpr bool limits_silence_to_half() { return limits_silence(50, 1'000); }
PROOF("a silent unit costs no more than its share", limits_silence_to_ten_percent)
PROOF("and the share can be chosen", limits_silence_to_half)

constexpr bool comes_back()
{
    three all;
    all.silent_from = 3;
    while (not all.link.is_silent(2)) {
        all.pass();
    }
    all.silent_from = 4;
    instant const start = all.now;
    while (all.conversations[2].answers < 5 and (all.now - start) < milliseconds(3'000)) {
        all.pass();
    }
    return all.conversations[2].answers == 5 and not all.link.is_silent(2);
}
PROOF("a unit that answers again is asked as often as the others", comes_back)

constexpr bool hears_refusals()
{
    three all;
    all.refusing = 3;
    while (all.asked < 30) {
        all.pass();
    }
    return all.conversations[2].failures >= 9 and not all.link.is_silent(2);
}
PROOF("a unit that refuses is not silent, even by a code that no document has", hears_refusals)

constexpr bool keeps_idle_time()
{
    three all;
    all.link.set(1, {.with = {milliseconds(50), 0}, .least_idle = milliseconds(200)});
    all.link.set(99, {});
    instant const start = all.now;
    while ((all.now - start) < milliseconds(1'000)) {
        all.pass();
    }
    return all.conversations[1].answers >= 4 and all.conversations[1].answers <= 5 and
           all.conversations[0].answers > 20;
}
PROOF("a unit that needs idle time gets it, and the others go on", keeps_idle_time)

constexpr bool does_not_wait_for_the_absent()
{
    three all;
    instant const start = all.now;
    while ((all.now - start) < milliseconds(500)) {
        all.link.advance(all.now);
        all.link.converse(0, all.conversations[0], all.now);
        all.link.converse(2, all.conversations[2], all.now);
        all.link.converse(7, all.conversations[1], all.now);
        all.transmit();
        deadline const next = all.link.poll_deadline();
        all.now = next and not reached(all.now, *next) ? *next : all.now + microseconds(100);
    }
    return all.conversations[0].answers > 10 and all.conversations[2].answers > 10 and
           all.conversations[1].answers == 0;
}
PROOF("a slot that nobody runs does not hold the others up", does_not_wait_for_the_absent)

constexpr bool lets_the_urgent_go_first()
{
    three all;
    while (all.asked < 4) {
        all.pass();
    }
    single_request stop{broadcast, write_single_register{8501, 0}};
    while (not stop.settled()) {
        all.link.advance(all.now);
        all.link.run_urgent(stop, all.now);
        for (std::size_t i = 0; i < 3; ++i) {
            all.link.converse(i, all.conversations[i], all.now);
        }
        all.transmit();
        deadline const next = all.link.poll_deadline();
        all.now = next and not reached(all.now, *next) ? *next : all.now + microseconds(100);
    }
    bool const next_was_broadcast = all.order[4] == 0;
    bool const is_done = stop.outcome().has_value();
    all.link.run_urgent(stop, all.now);
    while (all.asked < 10) {
        all.pass();
    }
    return next_was_broadcast and is_done and stop.outcome().error() == errc::used_already and all.order[5] != 0;
}
PROOF("what is urgent comes before all turns", lets_the_urgent_go_first)

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A loop that did not call `deliver_to` for any time, while interrupts put in what the line said: nothing of it waits for
// the clock to come round, and what comes then is heard.
#include "client_line.hpp"
#include "long_pauses.hpp"

#include "support/catch.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/rtu/interrupt_queue.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

/// Counts what it is given.
struct counter {
    unsigned bytes{0}, errors{0}, ends{0};

    void receive(byte_view received, instant) { bytes += static_cast<unsigned>(received.size()); }
    void receive_error(instant) { ++errors; }
    void sent(instant) { ++ends; }
};

/// The count that a counter of 32 bits shows.
instant shown(std::uint64_t time) { return instant{static_cast<std::uint32_t>(time)}; }

/// How long after a pause a unit's first answer comes to who asks it all the time; one byte of noise came in the pause.
std::uint64_t client_is_answered_after(std::uint64_t pause)
{
    std::uint64_t time = 0xFFFF'FFFFU - 3'000'000U;
    interrupt_queue<64> line;
    client link{office_line, {.response_timeout = milliseconds(100), .retries = 0}};
    single_request request{unit_id{1}, read_holding_registers{0, 1}};
    auto pass = [&] {
        line.deliver_to(link, shown(time));
        link.advance(shown(time));
    };
    for (unsigned i = 0; i < 20; ++i, time += 5'000) {
        pass();
    }
    line.receive(std::byte{0xFF}, shown(time));
    time += pause;
    for (std::uint64_t waited = 0; waited < 60 * minute; waited += 10'000, time += 10'000) {
        pass();
        link.converse(request, shown(time));
        if (request.settled()) {
            if (request.outcome()) {
                return waited;
            }
            request.again();
            continue;
        }
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            line.sent(shown(time + 4'600));
            line.receive(byte_view{response_to(read_of(1, 0))}, shown(time + 9'000));
        }
    }
    return 60 * minute;
}

/// The same for a server: how many requests it takes until it answers one.
unsigned server_answers_request(std::uint64_t pause)
{
    std::uint64_t time = 0xFFFF'FFFFU - 3'000'000U;
    interrupt_queue<64> line;
    server unit{unit_id{1}, office_line};
    word_bank<1> bank{};
    bool has_answered = false;
    auto pass = [&](std::uint64_t length) {
        for (std::uint64_t const end = time + length; time < end; time += 1'000) {
            line.deliver_to(unit, shown(time));
            unit.serve(bank, shown(time));
            if (byte_view const frame = unit.poll_transmit(); not frame.empty()) {
                has_answered = true;
                time += office_line.characters(frame.size()).microseconds;
                line.sent(shown(time));
            }
        }
    };
    pass(100'000);
    line.receive(std::byte{0xFF}, shown(time));
    time += pause;
    for (unsigned asked = 1; asked <= 200; ++asked) {
        line.receive(byte_view{read_of(1, 0)}, shown(time));
        pass(100'000);
        if (has_answered) {
            return asked;
        }
    }
    return 0;
}

} // namespace

TEST_CASE("defect: D24 what waited in an interrupt's queue is due after any pause of the loop")
{
    for (std::uint64_t const pause : long_pauses) {
        for (std::uint64_t const percent : {0U, 10U, 30U, 50U, 70U, 90U, 100U}) {
            INFO(pause / second << " s, an event after " << percent << " % of it");
            interrupt_queue<8> line;
            counter engine;
            std::uint64_t const begin = 1'000;
            line.deliver_to(engine, shown(begin));
            line.receive(std::byte{1}, shown(begin + pause * percent / 100));
            line.sent(shown(begin + pause));
            line.deliver_to(engine, shown(begin + pause));
            // At once, or within 0.1 s where the time of the event looks like one just ahead.
            line.deliver_to(engine, shown(begin + pause + second / 10));
            CHECK(engine.bytes == 1);
            CHECK(engine.ends == 1);
            CHECK(line.is_empty());
        }
    }
}

TEST_CASE("defect: D24 a client hears its unit after any pause of the loop, noise in its queue or not")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO(pause / second << " s");
        CHECK(client_is_answered_after(pause) < second);
    }
}

TEST_CASE("defect: D24 a server answers after any pause of the loop, noise in its queue or not")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO(pause / second << " s");
        unsigned const request = server_answers_request(pause);
        CHECK(request >= 1);
        CHECK(request <= 2);
    }
}

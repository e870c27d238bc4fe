// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program that was away for any time, and whose first pass begins with bytes that have just come: they are what the line
// does now, whatever it did before.
#include "client_line.hpp"
#include "long_pauses.hpp"

#include "support/catch.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

instant shown(std::uint64_t time) { return instant{static_cast<std::uint32_t>(time)}; }

} // namespace

TEST_CASE("defect: D24 a client does not send into a frame that has just begun, after any pause")
{
    for (std::uint64_t const pause : long_pauses) {
        for (bool const was_busy : {false, true}) {
            INFO(pause / second << " s, the line was " << (was_busy ? "busy" : "quiet"));
            std::uint64_t time = 1'000'000;
            client link{office_line};
            link.advance(shown(time));
            link.advance(shown(time += 100'000));
            if (was_busy) {
                link.receive(std::byte{0x55}, shown(time));
                link.advance(shown(time));
            }
            time += pause;
            link.receive(std::byte{0x01}, shown(time));
            link.advance(shown(time));
            single_request request{unit_id{1}, read_holding_registers{0, 1}};
            link.converse(request, shown(time));
            CHECK_FALSE(link.is_quiet());
            CHECK(link.poll_transmit().empty());
            // Once the line is silent it asks.
            link.advance(shown(time += 100'000));
            link.converse(request, shown(time));
            CHECK_FALSE(link.poll_transmit().empty());
        }
    }
}

TEST_CASE("defect: D24 the first frame after any pause is not put behind the rest of one before it")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO(pause / second << " s");
        std::uint64_t time = 1'000'000;
        framer<direction::request> reader{office_line};
        reader.advance(shown(time));
        reader.advance(shown(time += 100'000));
        frame_bytes const frame = read_of(1, 0);
        reader.receive(byte_view{frame}.first(3), shown(time));
        time += pause;
        // First the rest of the old one is told, once the first byte of the new one has come.
        byte_view rest{frame};
        rest = rest.subspan(reader.receive(rest, shown(time)));
        auto const cut = reader.poll_frame();
        REQUIRE(cut);
        CHECK(cut->error() == errc::frame_too_short);
        REQUIRE(rest.size() == frame.size());
        CHECK(reader.receive(rest, shown(time)) == frame.size());
        auto const whole = reader.poll_frame();
        REQUIRE(whole);
        CHECK(*whole);
    }
}

TEST_CASE("defect: D24 a server answers the first request after any pause, a frame's rest before it or not")
{
    for (std::uint64_t const pause : long_pauses) {
        for (unsigned const begun : {0U, 1U, 3U, 7U}) {
            INFO(pause / second << " s, " << begun << " bytes before it");
            std::uint64_t time = 1'000'000;
            server unit{unit_id{1}, office_line};
            word_bank<1> bank{};
            unit.serve(bank, shown(time));
            unit.serve(bank, shown(time += 100'000));
            frame_bytes const frame = read_of(1, 0);
            for (unsigned i = 0; i < begun; ++i) {
                unit.receive(frame[i], shown(time));
                unit.serve(bank, shown(time));
                time += office_line.characters(1).microseconds;
            }
            time += pause;
            for (std::byte const each : frame) {
                unit.receive(each, shown(time));
                unit.serve(bank, shown(time));
                time += office_line.characters(1).microseconds;
            }
            unit.serve(bank, shown(time += 10'000));
            CHECK_FALSE(unit.poll_transmit().empty());
        }
    }
}

TEST_CASE("defect: D24 a server whose response never left hears again after any pause")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO(pause / second << " s");
        std::uint64_t time = 1'000'000;
        server unit{unit_id{1}, office_line};
        word_bank<1> bank{};
        unit.serve(bank, shown(time));
        unit.serve(bank, shown(time += 100'000));
        frame_bytes const frame = read_of(1, 0);
        unit.receive(byte_view{frame}, shown(time));
        unit.serve(bank, shown(time += 10'000));
        REQUIRE_FALSE(unit.poll_transmit().empty());
        time += pause; // nobody calls `sent`
        bool has_answered = false;
        for (unsigned asked = 0; asked < 2 and not has_answered; ++asked) {
            unit.receive(byte_view{frame}, shown(time));
            unit.serve(bank, shown(time));
            unit.serve(bank, shown(time += 100'000));
            has_answered = not unit.poll_transmit().empty();
        }
        CHECK(has_answered);
    }
}

TEST_CASE("defect: D24 a server executes no request from before a pause, whatever else is reported first")
{
    for (std::uint64_t const pause : long_pauses) {
        for (bool const is_sent : {false, true}) {
            INFO(pause / second << " s, then " << (is_sent ? "an end of sending" : "a damaged byte"));
            std::uint64_t time = 1'000'000;
            server unit{unit_id{1}, office_line};
            word_bank<1> bank{};
            unit.serve(bank, shown(time));
            unit.serve(bank, shown(time += 100'000));
            unit.receive(byte_view{write_of(1, 0, 7)}, shown(time));
            unit.advance(shown(time += 10'000)); // the line is quiet
            REQUIRE(unit.is_asked());
            time += pause;
            if (is_sent) {
                unit.sent(shown(time));
            } else {
                unit.receive_error(shown(time));
            }
            unit.serve(bank, shown(time));
            CHECK(bank.get(0) == 0);
            deadline const next = unit.poll_deadline();
            CHECK((not next or *next - shown(time) <= office_line.frame_end()));
        }
    }
}

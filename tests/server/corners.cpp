// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server whose bank fails, whose line is noisy at the last moment, and that nobody understands.
#include <rtuwire/server/server.hpp>

#include "support/catch.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto line = test::usual_line;
constexpr unit_id one{1};
constexpr auto loop = "08 00 00 A5 37"_hex;
constexpr auto short_one = "08 00"_hex;
constexpr auto basic_from_80 = "2B 0E 01 80"_hex;
constexpr auto reserved_5 = "08 00 05"_hex;
constexpr auto listen_only = "08 00 04 00 00"_hex;
constexpr auto odd_restart = "08 00 01 12 34"_hex;
constexpr auto restart = "08 00 01 00 00"_hex;
constexpr auto refusal_of_1 = "01 83 02 C0 F1"_hex;
constexpr auto refusal_of_2 = "02 83 02 30 F1"_hex;
constexpr auto status_of_7 = "07"_hex;
constexpr auto refusal_of_7 = "87 01"_hex;
constexpr auto refusal_of_6 = "86 01"_hex;
constexpr auto write_5 = "06 00 01 00 05"_hex;
constexpr device_object vendor[] = {{vendor_name, "vendor"}};
constexpr device_object vendor_and_more[] = {{vendor_name, "vendor"}, {0x80, "private"}};
constexpr server_profile profile{.identity = identity_of<vendor>};
constexpr auto read_1 = "01 03 00 01 00 01 D5 CA"_hex;

/// Says more than it was asked for.
struct talkative_bank {
    static errc check_read(std::uint16_t, std::size_t) { return errc::none; }
    static errc check_write(std::uint16_t, register_view) { return errc::illegal_data_value; }
    static errc read(std::uint16_t, std::size_t, byte_writer& out)
    {
        for (unsigned i = 0; i < 200; ++i) {
            out.u16(1);
        }
        return errc::none;
    }
    static errc write(std::uint16_t, register_view) { return errc::none; }
};

/// Says less.
struct quiet_bank : talkative_bank {
    static errc read(std::uint16_t, std::size_t, byte_writer& out)
    {
        out.u16(1);
        return errc::none;
    }
};

/// A request where its response comes.
struct in_place {
    std::array<std::byte, max_pdu_size> bytes{};
    pdu_buffer pdu{bytes, 0};

    explicit in_place(byte_view request)
    {
        byte_writer{bytes}.bytes(request);
        pdu.size = request.size();
    }
};

template <typename Bank, std::size_t Size> std::uint32_t exception_to(std::array<std::byte, Size> const& pdu)
{
    Bank bank;
    std::array<std::byte, max_pdu_size> place{};
    auto const response = respond(pdu, bank, profile, place);
    return response.size() == 2 and to_u8(response[0]) >= 0x80 ? to_u8(response[1]) : 0U;
}

using unit_1 = test::server_on_a_line<>;

} // namespace

TEST_CASE("a bank that fails is exception 04, one that refuses is its word")
{
    CHECK(exception_to<talkative_bank>("03 00 00 00 01"_hex) == 4);
    CHECK(exception_to<quiet_bank>("03 00 00 00 02"_hex) == 4);
    CHECK(exception_to<talkative_bank>("06 00 00 00 01"_hex) == 3);
    CHECK(exception_to<word_bank<4>>("2B 0D 00 00"_hex) == 1);
    CHECK(exception_to<word_bank<4>>("2B 0E 09 00"_hex) == 3);
    CHECK(exception_to<word_bank<4>>("2B 0E 01"_hex) == 3);
}

TEST_CASE("a damaged byte between a response's readiness and its start delays it")
{
    unit_1 unit;
    unit.node.receive(read_1, unit.now);
    unit.pass({});
    unit.pass(line.t3_5()); // ready
    CHECK(unit.node.poll_deadline());
    unit.node.receive_error(unit.now);
    CHECK(unit.node.poll_transmit().empty());
    CHECK(unit.node.poll_deadline() == deadline{unit.now + line.t3_5()});
    unit.pass(line.t3_5());
    CHECK(unit.node.poll_transmit().size() == 7);
}

TEST_CASE("bytes behind a damaged one drop the request and are ignored until the line is silent")
{
    unit_1 unit;
    unit.node.receive(read_1, unit.now);
    unit.node.receive_error(unit.now);
    CHECK(unit.node.is_asked());
    unit.node.receive(read_1, unit.now);
    CHECK_FALSE(unit.node.is_asked());
    CHECK(unit.node.poll_deadline() == deadline{unit.now + line.frame_end()});
    unit.pass(line.frame_end());
    unit.node.receive(read_1, unit.now);
    CHECK(unit.node.is_asked());
}

TEST_CASE("a damaged byte while it answers is noise, and one before the line was silent is nothing")
{
    unit_1 unit;
    unit.node.receive(read_1, unit.now);
    unit.pass({});
    unit.node.receive_overrun(unit.now);
    unit.pass(line.t3_5());
    CHECK(unit.node.poll_transmit().size() == 7);

    server fresh{one, line};
    instant now{0};
    fresh.advance(now);
    fresh.receive_error(now);
    now = now + milliseconds(10);
    fresh.advance(now);
    fresh.receive(read_1, now);
    CHECK(fresh.is_asked());
}

TEST_CASE("a counting server loops back too")
{
    serial_diagnostics counts;
    in_place looped{loop};
    in_place short_loop{short_one};
    REQUIRE(counts.response(looped.pdu) == errc::none);
    CHECK(same_bytes(looped.pdu.view(), loop));
    CHECK(counts.response(short_loop.pdu) == errc::illegal_data_value);
    in_place reserved{reserved_5};
    CHECK(counts.response(reserved.pdu) == errc::illegal_function);
}

TEST_CASE("a unit that is told to be silent hears no restart that is not one")
{
    serial_diagnostics counts;
    auto const is_silent = [&counts](byte_view request) {
        in_place heard{request};
        return counts.response(heard.pdu) == errc::none and heard.pdu.size == 0;
    };
    REQUIRE(is_silent(listen_only));
    REQUIRE(counts.is_listen_only());
    CHECK(is_silent(odd_restart));
    CHECK(is_silent(short_one));
    CHECK(is_silent(loop));
    CHECK(counts.is_listen_only());
    CHECK(is_silent(restart));
    CHECK_FALSE(counts.is_listen_only());
}

TEST_CASE("a response in this unit's name, or to nobody's request, is not obeyed")
{
    for (auto const& foreign : {refusal_of_1, refusal_of_2}) {
        unit_1 unit;
        unit.node.receive(foreign, unit.now);
        unit.now = unit.now + line.t3_5();
        unit.node.advance(unit.now);
        CHECK_FALSE(unit.node.is_asked());
        unit.pass(line.t3_5());
        unit.node.receive(read_1, unit.now);
        CHECK(unit.node.is_asked());
    }
}

TEST_CASE("a response that does not get onto the line in time is dropped")
{
    unit_1 unit;
    unit.node.receive(read_1, unit.now);
    unit.node.serve(unit.bank, unit.now);
    instant const end = unit.now + line.frame_end() + milliseconds(100);
    for (unsigned i = 0; i < 101; ++i) { // a line that never falls silent
        unit.now = unit.now + milliseconds(1);
        unit.node.receive_error(unit.now);
        unit.node.advance(unit.now);
    }
    CHECK(unit.node.poll_deadline() == deadline{end});
    unit.now = end;
    unit.node.advance(unit.now);
    unit.pass(milliseconds(5));
    CHECK(unit.node.poll_transmit().empty());
    CHECK_FALSE(unit.node.poll_deadline());
}

TEST_CASE("a profile that names a function nobody answers gets it refused, and no other obeyed")
{
    constexpr server_profile odd{.functions = function_set{static_cast<function_code>(7)}};
    word_bank<4> bank;
    std::array<std::byte, max_pdu_size> place{};
    CHECK(same_bytes(respond(status_of_7, bank, odd, place), refusal_of_7));
    CHECK(same_bytes(respond(write_5, bank, odd, place), refusal_of_6));
    CHECK(bank.get(1) == 0);
}

TEST_CASE("a stream that starts at an object of another category starts anew")
{
    in_place heard{basic_from_80};
    REQUIRE(write_identification(heard.pdu, identity_of<vendor_and_more>) == errc::none);
    CHECK(to_u8(heard.bytes[7]) == vendor_name);
}

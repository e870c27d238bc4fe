// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client asks a server for function 65, and all that is made of the list of functions knows it.
#include <rtuwire/wire/double_number.hpp>

#include <array>

#include "support/fact.hpp"
#include "support/pdus.hpp"
#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/response.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::is;

namespace {

constexpr auto request = "02 41 12 34 00 00"_hex;
constexpr length_hint whole{6, true};

STATIC_CHECK(all_functions.contains(static_cast<function_code>(65)));
STATIC_CHECK(test::all_pdus::contains<double_number>and test::all_pdus::contains<double_number_response>);

// Both directions end at their size.
STATIC_CHECK(frame_length(direction::request, byte_view{request}.first(2)) == whole);
STATIC_CHECK(frame_length(direction::response, byte_view{request}.first(2)) == whole);
STATIC_CHECK(longest_response(request) == whole);
STATIC_CHECK(frame_length(direction::response, "02 C1"_hex) == length_hint{5, true});

template <std::size_t Size> constexpr errc verdict(std::array<std::byte, Size> const& response_adu)
{
    return check_response(request, adu{response_adu});
}
STATIC_CHECK(verdict("02 41 24 68 00 00"_hex) == errc::none);
STATIC_CHECK(verdict("02 41 24 69 00 00"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict("02 41 24 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict("02 41 12 34 00 00"_hex) == errc::line_echo);
STATIC_CHECK(verdict("02 C1 02 00 00"_hex) == errc::illegal_data_address);

// Requests of the other functions stay what they were.
STATIC_CHECK(check_response("02 03 00 00 00"_hex, adu{"02 03 02 12 34 00 00"_hex}) == errc::none);
STATIC_CHECK(check_response("02 2B 0E 04 00 00"_hex, adu{"02 2B 01 00 00"_hex}) == errc::none);

/// A request travels from a client to a server, and its response back.
constexpr bool is_asked_and_answered()
{
    line_timing const line{19'200, character_format::even_8_1};
    host_client client{line};
    basic_server<loopback_only, function_list<read_holding_registers, double_number>> node{unit_id{2}, line};
    word_bank<4> bank;
    single_request ask{unit_id{2}, double_number{0x9001}};
    instant now{0};
    for (int pass = 0; pass < 100 and not ask.settled(); ++pass) {
        now = now + milliseconds(5);
        client.advance(now);
        client.converse(ask, now);
        node.advance(now);
        if (byte_view const sent = client.poll_transmit(); not sent.empty()) {
            now = now + line.characters(sent.size());
            client.sent(now);
            node.receive(sent, now);
        }
        node.serve(bank, now);
        now = now + milliseconds(5);
        node.advance(now);
        if (byte_view const told = node.poll_transmit(); not told.empty()) {
            now = now + line.characters(told.size());
            client.receive(told, now);
            node.sent(now);
        }
    }
    auto const outcome = ask.outcome();
    return is(outcome.has_value(), "a response came") and
           is(outcome->to<double_number>()->doubled == 0x2002, "it is the double");
}
PROOF("a client asks a server for the new function", is_asked_and_answered)

} // namespace

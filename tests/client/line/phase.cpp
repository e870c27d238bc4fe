// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every phase of a client with every input: the table of the header as data.
#include <rtuwire/client/line/request.hpp>

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/hex.hpp>

#include <cstddef>
#include <sstream>
#include <string>

#include "client/line/phase_table.hpp"
#include "support/asking.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using enum rtuwire::detail::client_phase;
using namespace test::client_table;

namespace {

enum input : std::size_t { visits, transmit, sent, bytes, response_taken, busy, damaged, advance, time_over, cancel };

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr auto to_unit = "01 03 0C 81 00 01 D7 72"_hex;
constexpr auto to_all = "00 06 21 35 00 00 92 29"_hex;
constexpr auto answer = "01 03 02 12 34 B5 33"_hex;
constexpr auto exception_06 = "01 83 06 C1 32"_hex;
constexpr auto with_wrong_crc = "01 03 02 12 34 B5 34"_hex;

/// A client, one conversation of one request, and a clock.
struct desk {
    client link{timing, client_options{.late_response = {}}};
    test::frame_request conversation;
    retry_policy with{};
    instant now{1'000'000};

    desk(request_frame const& request, retry_policy const& policy) : conversation{request}, with{policy}
    {
        link.advance(now);
        pass(milliseconds(10));
    }

    void pass(duration length)
    {
        now = now + length;
        link.advance(now);
    }
    void visit() { link.converse(conversation, now, with); }

    void take(input what)
    {
        switch (what) {
        case visits: return visit();
        case transmit: return static_cast<void>(link.poll_transmit());
        case sent: return link.sent(now);
        case bytes: return link.receive("55"_hex, now);
        case response_taken: return link.receive(answer, now);
        case busy: return link.receive(exception_06, now);
        case damaged:
            link.receive(with_wrong_crc, now);
            return link.phase_now() == awaiting ? pass(timing.frame_end()) : void(); // silence ends it
        case advance: return link.advance(now);
        case time_over: return pass(milliseconds(5'000));
        case cancel: return link.cancel(now);
        }
    }

    /// Goes to a phase by inputs that lead there.
    void go_to(client_phase wanted)
    {
        if (wanted == idle) {
            return;
        }
        if (wanted == waiting) {
            take(bytes);
            visit();
            return pass(milliseconds(10)); // the line is quiet, and its asker has not visited since
        }
        visit();
        if (wanted == ready) {
            return;
        }
        if (wanted == settled) {
            return take(cancel);
        }
        take(transmit);
        if (wanted == handed_out) {
            return;
        }
        take(advance);
        if (wanted == transmitting) {
            return;
        }
        take(sent);
        if (wanted == pausing) {
            take(busy);
        }
    }
};

client_phase phase_of(std::string const& name)
{
    std::size_t at = 0;
    while (at < phases.size() and phases[at] != name) {
        ++at;
    }
    REQUIRE(at < phases.size());
    return static_cast<client_phase>(at);
}

void check(char const* table, request_frame const& request, retry_policy const& policy)
{
    std::istringstream words{table};
    std::string from;
    std::size_t rows = 0;
    for (; words >> from; ++rows) {
        for (std::size_t i = 0; i < inputs; ++i) {
            std::string to;
            REQUIRE(words >> to);
            INFO(from << ", " << input_names[i]);
            desk it{request, policy};
            it.go_to(phase_of(from));
            REQUIRE(it.link.phase_now() == phase_of(from));
            it.take(static_cast<input>(i));
            CHECK(phases[static_cast<std::size_t>(it.link.phase_now())] == (to == "." ? from : to));
        }
    }
    CHECK(rows >= 6);
}

constexpr retry_policy with_retries{.response_timeout = milliseconds(100), .retries = 1, .busy_retries = 1};
constexpr retry_policy without_retries{.response_timeout = milliseconds(100), .retries = 0, .busy_retries = 0};

} // namespace

TEST_CASE("every phase with every input: a request that may be repeated")
{
    check(of_several_sendings, request_frame{to_unit}, with_retries);
}

TEST_CASE("every phase with every input: a request that may not be repeated")
{
    check(of_one_sending, request_frame{to_unit, repetition::never}, with_retries);
}

TEST_CASE("every phase with every input: a broadcast") { check(of_a_broadcast, request_frame{to_all}, with_retries); }

TEST_CASE("where no repetition is left, the end of awaiting is the end of the request")
{
    for (input const what : {response_taken, busy, damaged, time_over, cancel}) {
        INFO(input_names[what]);
        desk it{request_frame{to_unit}, without_retries};
        it.go_to(awaiting);
        it.take(what);
        CHECK(it.link.phase_now() == settled);
    }
}

TEST_CASE("a request that was cancelled while it left ends when it has left")
{
    for (client_phase const leaving : {handed_out, transmitting}) {
        desk it{request_frame{to_unit}, with_retries};
        it.go_to(leaving);
        it.take(cancel);
        REQUIRE(it.link.phase_now() == leaving);
        it.take(sent);
        CHECK(it.link.phase_now() == settled);
    }
}

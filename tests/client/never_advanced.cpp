// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A loop that forgets `advance`: nothing would ever leave, and nobody would be told.
#include "support/catch.hpp"

#include <rtuwire/client.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
constexpr client_options options{.response_timeout = milliseconds(300)};

struct one_client {
    host_client link{line, options};
    void visit(auto& who, instant now) { link.converse(who, now); }
};

struct one_bus {
    bus<2> link{line, options};
    void visit(auto& who, instant now) { link.converse(1, who, now); }
};

/// Passes of a millisecond, without `advance`. How long it takes until the read has ended; 10 s where it does not.
template <typename Node> duration time_to_end(Node& node, auto& who, instant from)
{
    instant now = from;
    while (not who.settled() and now - from < milliseconds(10'000)) {
        node.visit(who, now);
        CHECK(node.link.poll_transmit().empty());
        now = now + milliseconds(1);
    }
    return now - from;
}

} // namespace

TEMPLATE_TEST_CASE("defect: a forgotten advance is told within two response time-outs", "", one_client, one_bus)
{
    // Near the end of the counter, too.
    for (std::uint32_t const from : {0U, 5'000'000U, 0xFFFF'FFF0U}) {
        CAPTURE(from);
        TestType node;
        single_request ask{unit_id{1}, read_holding_registers{.start = 0, .count = 1}};
        CHECK(time_to_end(node, ask, instant{from}) <= milliseconds(600));
        CHECK(ask.outcome().error() == errc::never_advanced);
        if constexpr (std::is_same_v<TestType,
                                     one_client>) { // a slot whose unit did not answer rests, without an end here
            ask.again();
            CHECK(time_to_end(node, ask, instant{from + 1'000'000U}) <= milliseconds(600));
            CHECK(ask.outcome().error() == errc::never_advanced);
        }
    }
}

TEMPLATE_TEST_CASE("defect: each of several reads is told of a forgotten advance, one after another", "", host_client,
                   client)
{
    TestType link{line, options};
    single_request first{unit_id{3}, read_holding_registers{.start = 0, .count = 1}};
    single_request second{unit_id{4}, read_holding_registers{.start = 0, .count = 1}};
    single_request third{unit_id{3}, read_holding_registers{.start = 0, .count = 1}};
    instant now{0};
    for (; not third.settled() and now - instant{0} < milliseconds(10'000); now = now + milliseconds(1)) {
        for (auto* who : {&first, &second, &third}) {
            if (not who->settled()) {
                link.converse(*who, now);
            }
        }
        CHECK(link.poll_transmit().empty());
    }
    CHECK(now - instant{0} <= milliseconds(3 * 600));
    for (auto* who : {&first, &second, &third}) {
        CHECK(who->outcome().error() == errc::never_advanced);
    }
}

TEST_CASE("defect: two slots of a bus are told of a forgotten advance")
{
    bus<2> link{line, options};
    single_request first{unit_id{3}, read_holding_registers{.start = 0, .count = 1}};
    single_request second{unit_id{4}, read_holding_registers{.start = 0, .count = 1}};
    for (std::uint32_t ms = 0; ms < 1'200; ++ms) {
        if (not first.settled()) {
            link.converse(0, first, instant{ms * 1'000});
        }
        if (not second.settled()) {
            link.converse(1, second, instant{ms * 1'000});
        }
    }
    CHECK(first.outcome().error() == errc::never_advanced);
    CHECK(second.outcome().error() == errc::never_advanced);
}

TEST_CASE("a client that is advanced late has not forgotten it")
{
    one_client node;
    single_request ask{unit_id{1}, read_holding_registers{.start = 0, .count = 1}};
    node.visit(ask, instant{0});
    node.link.advance(instant{0});
    for (std::uint32_t ms = 0; ms < 200; ++ms) {
        node.visit(ask, instant{ms * 1'000});
    }
    node.link.advance(instant{200'000});
    node.visit(ask, instant{200'000});
    CHECK_FALSE(node.link.poll_transmit().empty());
}

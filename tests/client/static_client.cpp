// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client whose times are constants does what one does that was told them, and costs less.
#include <rtuwire/client/client.hpp>

#include <array>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(60),
                                 .turnaround = milliseconds(20),
                                 .late_response = milliseconds(30),
                                 .retries = 1,
                                 .max_leading_noise = 1};

constexpr auto stop_all = "00 06 21 35 00 00 92 29"_hex;
constexpr auto busy = "01 83 06 C1 32"_hex;
constexpr auto damaged = "01 03 02 12 34 B5 32"_hex;
constexpr auto noise = "00 FF"_hex;
constexpr std::array<byte_view, 4> said{test::response_1234, busy, damaged, noise};

/// Two clients on one line that hear and are told the same.
struct twins {
    test::asking<client> told{test::line, patient};
    test::asking<static_client<test::line, patient>> fixed{};
    instant now{0xFFFF'FFFFU - 2'000'000U};
    unsigned outcomes{0};
    unsigned sent{0};

    /// One thing happens; whether both then say the same.
    constexpr bool step(test::random& random)
    {
        now = now + microseconds(random.next() % 30'000);
        told.advance(now);
        fixed.advance(now);
        if (std::uint32_t const what = random.next() % 8; what < said.size()) {
            told.receive(said[what], now);
            fixed.receive(said[what], now);
        } else if (what == 4) {
            told.receive_error(now);
            fixed.receive_error(now);
        } else if (what < 7) {
            request_frame const asked{what == 5 ? byte_view{test::read_eta} : byte_view{stop_all}};
            if (told.start(asked, now).error() != fixed.start(asked, now).error()) {
                return false;
            }
        }
        return sends_the_same() and ends_the_same();
    }

    constexpr bool sends_the_same()
    {
        byte_view const one = told.poll_transmit();
        byte_view const other = fixed.poll_transmit();
        if (not one.empty()) {
            ++sent;
            now = now + test::line.characters(one.size());
            told.sent(now);
            fixed.sent(now);
        }
        return same_bytes(one, other) and told.poll_deadline() == fixed.poll_deadline();
    }

    constexpr bool ends_the_same()
    {
        auto const one = told.poll_outcome();
        auto const other = fixed.poll_outcome();
        outcomes += one ? 1U : 0U;
        return one.has_value() == other.has_value() and
               (not one or
                (one->error() == other->error() and (not *one or same_bytes((*one)->pdu(), (*other)->pdu()))));
    }
};

constexpr bool does_the_same(unsigned steps)
{
    test::random random{6};
    twins both;
    for (unsigned step = 0; step < steps; ++step) {
        if (not both.step(random)) {
            return false;
        }
    }
    return both.sent * 10 > steps and both.outcomes * 20 > steps;
}
constexpr bool does_the_same_for_a_while() { return does_the_same(400); }
PROOF("a fixed client says and takes what one does that was told", does_the_same_for_a_while)

// Its frame, and 76 bytes at most on a 32-bit processor; neither times nor options.
static_assert(sizeof(static_client<test::line>) + sizeof(line_timing) + sizeof(client_options) <= sizeof(client));
static_assert(sizeof(void*) != 4 or sizeof(static_client<test::line>) <= max_adu_size + 76);

constinit static_client<test::line> ready_before_any_code_runs;

} // namespace

TEST_CASE("a fixed client goes on like one that was told, for long") { CHECK(does_the_same(200'000)); }

TEST_CASE("a fixed client starts as zeros and works")
{
    auto& link = ready_before_any_code_runs;
    single_request ask{unit_id{1}, read_holding_registers{3201, 1}};
    instant now{0};
    link.advance(now);
    now = now + milliseconds(10);
    link.advance(now);
    link.converse(ask, now);
    CHECK(same_bytes(link.poll_transmit(), test::read_eta));
    link.sent(now);
    link.receive(test::response_1234, now + milliseconds(5));
    link.converse(ask, now + milliseconds(5));
    REQUIRE(ask.outcome());
    CHECK(same_bytes(ask.outcome()->pdu(), "03 02 12 34"_hex));
}

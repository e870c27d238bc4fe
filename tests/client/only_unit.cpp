// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit that answers at address 0, on a line of its own: asked where a program says so, and apart from all else that is sent
// to that address. Frames of users' reports (W08, W09).
#include "defect/client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client.hpp>

#include <type_traits>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr line_timing office{9'600, character_format::none_8_1};
constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(200), .retries = 0};

inline constexpr client_needs<> alone{.has_only_unit = true};
inline constexpr client_needs<> alone_with_orders{.quarantine_places = 4, .motors = 2, .has_only_unit = true};

// What a client that says nothing of it has, it still has.
static_assert(sizeof(basic_client<alone>) >= sizeof(client));
static_assert(decltype(single_request{only_unit, read_holding_registers{0, 1}})::asks_only_unit);
static_assert(not decltype(single_request{unit_id{1}, read_holding_registers{0, 1}})::asks_only_unit);
static_assert(not decltype(single_request{broadcast, write_single_register{0, 1}})::asks_only_unit);

// Nobody commands a drive so, nor holds it for a unit: it is none.
static_assert(not std::is_convertible_v<rtuwire::detail::only_unit_t, unit_id>);
static_assert(not std::is_constructible_v<unit_id, rtuwire::detail::only_unit_t>);
static_assert(not std::is_constructible_v<rtuwire::detail::destination, rtuwire::detail::only_unit_t>);

frame_bytes const w09_asked = framed({0x00, 0x03, 0x00, 0x00, 0x00, 0x01});
frame_bytes const w09_came = framed({0x00, 0x03, 0x02, 0x00, 0x05});

std::vector<unsigned> numbers(frame_bytes const& frame)
{
    std::vector<unsigned> all;
    for (std::byte const each : frame) {
        all.push_back(std::to_integer<unsigned>(each));
    }
    return all;
}

template <typename Link> struct line_of : scripted_line<Link> {
    explicit line_of(client_options const& how = once) : scripted_line<Link>{Link{office, how}, office} {}

    template <typename... Conversations> void converse(std::uint64_t time, Conversations&... all)
    {
        this->run(time, [&](instant now) {
            ((all.settled() ? static_cast<void>(0) : static_cast<void>(this->link.converse(all, now))), ...);
        });
    }
};

template <typename Link> void check_w09()
{
    line_of<Link> line;
    line.heard = [&](frame_bytes const& asked) {
        CHECK(asked == w09_asked);
        line.say(20'000, w09_came);
    };
    single_request ask{only_unit, read_holding_registers{0, 1}};
    line.converse(500'000, ask);
    REQUIRE(ask.outcome().error() == errc::none);
    CHECK(ask.outcome()->template to<read_holding_registers>()->registers[0] == 5);
    CHECK(line.departures.size() == 1);
}

} // namespace

TEST_CASE("W09: a unit that answers at address 0 is asked where a program says so")
{
    CHECK(numbers(w09_asked) == std::vector<unsigned>{0x00, 0x03, 0x00, 0x00, 0x00, 0x01, 0x85, 0xDB});
    CHECK(numbers(w09_came) == std::vector<unsigned>{0x00, 0x03, 0x02, 0x00, 0x05, 0x45, 0x87});
    check_w09<basic_client<alone>>();
    check_w09<basic_client<alone_with_orders>>();
}

TEST_CASE("W09: what carries the unit's own address is no response to a request at address 0")
{
    line_of<basic_client<alone>> line;
    line.heard = [&](frame_bytes const&) { line.say(20'000, framed({0x01, 0x03, 0x02, 0x00, 0x05})); };
    single_request ask{only_unit, read_holding_registers{0, 1}};
    line.converse(500'000, ask);
    CHECK(ask.outcome().error() == errc::timed_out);
}

TEST_CASE("a request at address 0 is repeated, and its exception is one")
{
    line_of<basic_client<alone>> line{{.response_timeout = milliseconds(50), .retries = 1}};
    line.heard = [&](frame_bytes const&) {
        if (line.departures.size() == 2) {
            line.say(5'000, framed({0x00, 0x83, 0x02}));
        }
    };
    single_request ask{only_unit, read_holding_registers{0, 1}};
    line.converse(1'000'000, ask);
    CHECK(ask.outcome().error() == errc::illegal_data_address);
    CHECK(line.departures.size() == 2);
}

TEST_CASE("no request follows one at address 0 until its response can come no more")
{
    for (unsigned const next : {0U, 1U, 9U}) {
        CAPTURE(next);
        line_of<basic_client<alone>> line;
        line.heard = [&](frame_bytes const& asked) {
            if (line.departures.size() == 1) {
                line.say(250'000, w09_came); // after the time-out: whoever asks by then would take it
            } else {
                line.say(5'000, response_to(asked));
            }
        };
        single_request first{only_unit, read_holding_registers{0, 1}};
        line.converse(130'000, first);
        REQUIRE(first.outcome().error() == errc::timed_out);
        if (next == 0) {
            single_request second{only_unit, read_holding_registers{0x70, 1}};
            line.converse(1'000'000, second);
            REQUIRE(second.outcome().error() == errc::none);
            CHECK(second.outcome()->to<read_holding_registers>()->registers[0] == 0x70);
        } else {
            single_request second{*unit_id::checked(next), read_holding_registers{0x70, 1}};
            line.converse(1'000'000, second);
            CHECK(second.outcome()->to<read_holding_registers>()->registers[0] == 0x70);
        }
        REQUIRE(line.departures.size() == 2);
        CHECK(line.departures[1].begin > 250'000);
    }
}

TEST_CASE("W08: a write to address 0 stays a broadcast, which nobody answers, beside the only unit")
{
    line_of<basic_client<alone>> line;
    line.heard = [&](frame_bytes const& asked) {
        if (at(asked, 1) == 6) {
            CHECK(numbers(asked) == std::vector<unsigned>{0x00, 0x06, 0x40, 0x00, 0x00, 0x02, 0x1C, 0x1A});
            line.say(30'000, framed({0x02, 0x06, 0x00, 0x00, 0x00, 0x02}));
        } else {
            line.say(5'000, response_to(asked));
        }
    };
    single_request write{broadcast, write_single_register{0x4000, 2}};
    single_request read{only_unit, read_holding_registers{0x70, 1}};
    line.converse(1'000'000, write, read);
    CHECK(write.outcome().error() == errc::none);
    CHECK(write.outcome()->pdu().empty());
    REQUIRE(read.outcome().error() == errc::none);
    CHECK(read.outcome()->to<read_holding_registers>()->registers[0] == 0x70);
    REQUIRE(line.departures.size() == 2);
    CHECK(line.departures[1].begin - line.departures[0].end >= 100'000); // its turnaround
}

TEST_CASE("an order's unit is not lost by a request at address 0 that nobody answers")
{
    line_of<basic_client<alone_with_orders>> line;
    line.heard = [&](frame_bytes const& asked) {
        if (at(asked, 0) != 0) {
            line.say(5'000, response_to(asked));
        }
    };
    single_request none{only_unit, read_holding_registers{0, 1}};
    single_request other{unit_id{9}, read_holding_registers{3, 1}};
    line.converse(1'000'000, none, other);
    CHECK(none.outcome().error() == errc::timed_out);
    CHECK(other.outcome().error() == errc::none);
}

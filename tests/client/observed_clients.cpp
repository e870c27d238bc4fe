// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any kind of client counts, and hands its frames on, without losing what it was.
#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/trace.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
using counts = line_statistics;

template <auto const& Needs> constexpr auto needs_of(basic_client<Needs> const*) { return Needs; }
template <typename Plain, typename Counting> constexpr bool needs_the_same()
{
    constexpr auto plain = needs_of(static_cast<Plain const*>(nullptr));
    constexpr auto counting = needs_of(static_cast<Counting const*>(nullptr));
    return plain.longest_frame == counting.longest_frame and plain.request_room == counting.request_room and
           plain.motors == counting.motors and plain.quarantine_places == counting.quarantine_places and
           plain.timing.has_value() == counting.timing.has_value();
}
STATIC_CHECK(sizeof(counts) == 112);
STATIC_CHECK(needs_the_same<client, client::observed_by<counts>>());
STATIC_CHECK(needs_the_same<host_client, host_client::observed_by<counts>>());
STATIC_CHECK(needs_the_same<drive_client<3>, drive_client<3>::observed_by<counts>>());
STATIC_CHECK(needs_the_same<static_client<line>, static_client<line>::observed_by<counts>>());

struct frame_count {
    unsigned requests{0};
    unsigned responses{0};
    void take(traced_frame const& frame) noexcept
    {
        requests += frame.role == frame_role::request ? 1U : 0U;
        responses += frame.role == frame_role::response ? 1U : 0U;
    }
};

/// What a unit says to function 03, at once.
struct answering_port {
    instant time{1'000'000};
    bool is_asked{false};

    instant now() { return time = time + microseconds(500); }
    result<void> write(byte_view, instant)
    {
        is_asked = true;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        static constexpr auto response = "01 03 02 00 07 F9 86"_hex;
        if (not is_asked) {
            time = reached(until, time) ? until : time;
            return place.first(0);
        }
        is_asked = false;
        std::size_t size = 0;
        for (std::byte const each : byte_view{response}) {
            place[size++] = each;
        }
        return place.first(size);
    }
};

} // namespace

TEST_CASE("a blocking client counts, and hands its frames to a sink")
{
    answering_port port;
    frame_count seen;
    blocking_client<answering_port>::observed_by<unit_statistics<2>>::traced_by<frame_count> link{port, line};
    link.trace_to(seen);
    for (unsigned i = 0; i < 3; ++i) {
        REQUIRE(link.ask(unit_id{1}, read_holding_registers{.start = 0, .count = 1}));
    }
    CHECK(link.statistics().line()[line_event::request] == 3);
    CHECK(link.statistics().unit(1)->by_event[static_cast<std::size_t>(line_event::reply)] == 3);
    CHECK((seen.requests == 3 and seen.responses == 3));
}

TEST_CASE("a bus counts as it is told to")
{
    bus<2>::observed_by<unit_statistics<2>> link{line};
    CHECK(link.statistics().line()[line_event::request] == 0);
}

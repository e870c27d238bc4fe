// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server whose loop comes late: what its client has given up is neither executed nor answered. And one
// that is never told that its response has left.
#include <rtuwire/server/server.hpp>

#include "support/catch.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto line = test::usual_line;
constexpr auto write_3 = "01 06 00 01 00 03 98 0B"_hex;
constexpr auto read_0 = "01 03 00 00 00 01 84 0A"_hex;
constexpr auto read_1 = "01 03 00 01 00 01 D5 CA"_hex;
constexpr auto says_1111 = "01 03 02 11 11 74 18"_hex;
constexpr auto says_2222 = "01 03 02 22 22 20 FD"_hex;
constexpr auto everyone_writes_3 = "00 06 00 01 00 03 99 DA"_hex;
constexpr auto noise = "55"_hex;
/// From the last byte of a request: the time its response may start in, and one that is long over.
constexpr duration limit = line.frame_end() + milliseconds(100);
constexpr duration long_after = milliseconds(1'200);

struct unit_1 : test::server_on_a_line<> {
    unit_1()
    {
        static_cast<void>(bank.set(0, 0x1111));
        static_cast<void>(bank.set(1, 0x2222));
    }

    /// What it sends within 10 ms.
    byte_view says()
    {
        pass(microseconds(0));
        pass(milliseconds(10));
        return send();
    }
};

} // namespace

TEST_CASE("defect: D5 a server served late answers the request that came last")
{
    unit_1 unit;
    unit.receive(read_0);
    unit.now = unit.now + long_after; // the client gave up, and asks for the next
    unit.receive(read_1);
    CHECK(same_bytes(unit.says(), says_2222));
}

TEST_CASE("defect: D5 both requests in one lump, as a buffer hands them over late")
{
    unit_1 unit;
    std::array<std::byte, 16> both{};
    byte_writer out{both};
    out.bytes(write_3);
    out.bytes(read_0);
    unit.receive(both);
    CHECK(same_bytes(unit.says(), says_1111));
    CHECK(unit.bank.get(1) == 0x2222);
}

TEST_CASE("defect: D5 a write that waited too long is neither executed nor answered")
{
    for (auto const& request : {write_3, everyone_writes_3}) {
        unit_1 unit;
        unit.receive(request);
        unit.now = unit.now + long_after;
        unit.node.serve(unit.bank, unit.now);
        CHECK(unit.bank.get(1) == 0x2222);
        CHECK(unit.says().empty());
        unit.receive(read_0);
        CHECK(same_bytes(unit.says(), says_1111));
    }
}

TEST_CASE("defect: D5 the time counts from the request's last byte, to the microsecond")
{
    for (bool const is_late : {false, true}) {
        unit_1 unit;
        unit.receive(write_3);
        instant const end = unit.now;
        unit.sleep(line.t3_5());
        CHECK(unit.node.poll_deadline() == deadline{end + limit});
        unit.now = end + limit - microseconds(is_late ? 0 : 1);
        unit.node.serve(unit.bank, unit.now);
        CHECK((unit.bank.get(1) == 3) == not is_late);
        // Served 1 us before the end, it may leave then, and not later.
        CHECK(unit.node.poll_deadline().has_value() == not is_late);
        unit.sleep(microseconds(1));
        CHECK(unit.node.poll_transmit().empty());
        CHECK_FALSE(unit.node.poll_deadline());
    }
}

TEST_CASE("defect: D5 a response that waits for silence is dropped when bytes arrive")
{
    unit_1 unit;
    unit.receive(read_0);
    unit.pass(microseconds(100));
    unit.receive(read_1);
    CHECK(same_bytes(unit.says(), says_2222));
    unit.receive(read_0);
    unit.pass(line.t3_5());
    unit.receive(noise); // ready to leave
    CHECK(unit.says().empty());
    unit.receive(read_1);
    CHECK(same_bytes(unit.says(), says_2222));
}

TEST_CASE("defect: D16 a server that is never told of the end of one response goes on")
{
    unit_1 unit;
    unsigned answered = 0;
    for (unsigned i = 0; i < 1'000; ++i) {
        unit.receive(read_0);
        unit.pass(microseconds(0));
        unit.pass(milliseconds(3));
        byte_view const frame = unit.node.poll_transmit();
        answered += same_bytes(frame, says_1111) ? 1U : 0U;
        unit.now = unit.now + line.characters(says_1111.size());
        if (i != 10 and not frame.empty()) {
            unit.node.sent(unit.now);
        }
        unit.pass(milliseconds(250));
    }
    CHECK(answered == 1'000);
}

TEST_CASE("defect: D16 it has a deadline for that, and listens after the next silence")
{
    unit_1 unit;
    unit.receive(read_0);
    instant const asked = unit.now;
    unit.pass(microseconds(0));
    unit.pass(line.t3_5());
    REQUIRE(unit.node.poll_transmit().size() == says_1111.size());
    instant const end = asked + limit + line.characters(says_1111.size()) + milliseconds(100);
    REQUIRE(unit.node.poll_deadline() == deadline{end});
    unit.now = end - microseconds(1);
    unit.node.receive(read_1, unit.now); // heard while it sends: nothing
    unit.pass(microseconds(0));
    CHECK(unit.node.poll_deadline() == deadline{end});
    unit.sleep(microseconds(1));
    CHECK(unit.node.poll_deadline() == deadline{end - microseconds(1) + line.frame_end()});
    unit.node.receive(read_1, unit.now); // no silence before it
    CHECK_FALSE(unit.node.is_asked());
    CHECK(unit.node.poll_deadline() == deadline{end + line.frame_end()});
    unit.sleep(line.frame_end());
    CHECK_FALSE(unit.node.poll_deadline());
    unit.receive(read_1);
    CHECK(same_bytes(unit.says(), says_2222));
}

TEST_CASE("defect: D16 the end of a response that is told late does no harm")
{
    unit_1 unit;
    unit.receive(read_0);
    unit.pass(microseconds(0));
    unit.pass(line.t3_5());
    REQUIRE(unit.node.poll_transmit().size() == says_1111.size());
    unit.pass(milliseconds(500));
    unit.pass(milliseconds(500));
    unit.receive(byte_view{read_1}.first(4));
    unit.node.sent(unit.now);
    unit.receive(byte_view{read_1}.subspan(4));
    CHECK(same_bytes(unit.says(), says_2222));
}

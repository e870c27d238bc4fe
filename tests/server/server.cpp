// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit on a line: when it speaks, and when it is silent.
#include <rtuwire/server/server.hpp>

#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr auto line = test::usual_line;
using unit_1 = test::server_on_a_line<>;

// Its memory has a frame, and no room in front of it, where a client keeps its request.
STATIC_CHECK(sizeof(server) <= sizeof(detail::line_memory<detail::stored<line_timing>, max_adu_size>) + 32);

constexpr auto write_3 = "01 06 00 01 00 03 98 0B"_hex;
constexpr auto read_1 = "01 03 00 01 00 01 D5 CA"_hex;

constexpr bool serves()
{
    unit_1 unit;
    unit.hear(write_3);
    bool const written = unit.says(write_3) and unit.bank.get(1) == 3;
    unit.hear(read_1);
    return written and unit.says("01 03 02 00 03 F8 45"_hex);
}
PROOF("a request is answered after t3.5, then the next", serves)

constexpr bool sleeps_between_requests()
{
    unit_1 unit;
    unit.hear(write_3);
    bool const waits = unit.node.poll_deadline() == deadline{unit.now + line.t3_5()};
    bool const answered = unit.says(write_3) and not unit.node.poll_deadline();
    unit.hear("01 03"_hex);
    return waits and answered and unit.node.poll_deadline();
}
PROOF("between requests a server has no deadline; in one it has", sleeps_between_requests)

template <std::size_t Size> constexpr bool is_ignored(std::array<std::byte, Size> const& bytes)
{
    unit_1 unit;
    unit.hear(bytes);
    bool const silent = unit.is_silent() and unit.bank.get(1) == 0;
    unit.hear(write_3);
    return silent and unit.says(write_3);
}
constexpr bool silent_on()
{
    using test::is;
    return is(is_ignored("02 06 00 01 00 03 98 38"_hex), "a request to another unit") and
           is(is_ignored("01 06 00 01 00 03 98 0C"_hex), "a damaged request") and
           is(is_ignored("01 83 02 C0 F1"_hex), "an answer") and
           is(is_ignored("FF 03 00 00 00 01 91 D4"_hex), "a request to a reserved unit") and
           is(is_ignored("00 03 00 00 00 01 85 DB"_hex), "a read of everyone") and
           is(is_ignored("FF FF"_hex), "two bytes that are no frame") and
           is(is_ignored("02 03 00 01 FF FF 15 89"_hex), "a request to another unit, of too many registers") and
           is(is_ignored("01 03"_hex), "the beginning of a request");
}
PROOF("other units, damage, answers, reserved units and broadcast reads get silence", silent_on)

constexpr bool broadcast_write()
{
    unit_1 unit;
    unit.hear("00 06 00 01 00 03 99 DA"_hex);
    return unit.bank.get(1) == 3 and unit.is_silent();
}
PROOF("a broadcast write is obeyed in silence", broadcast_write)

constexpr auto read_by_nine = "09 03 00 00 00 01 85 42"_hex;
constexpr auto response_of_nine = "09 03 02 00 00 59 85"_hex;

constexpr bool moves_to_another_address()
{
    unit_1 unit;
    unit.hear(write_3);
    unit.node.listen_as(unit_id{9}); // the response that waits still has the old one
    bool const answered = unit.says(write_3);
    unit.hear(read_by_nine);
    bool const moved = unit.says(response_of_nine);
    unit.hear(read_1);
    return answered and moved and unit.is_silent();
}
PROOF("a server listens to another address from the next frame on", moves_to_another_address)

constexpr bool has_no_address()
{
    unit_1 unit;
    unit.node.listen_as(std::nullopt);
    unit.hear(write_3);
    bool const ignored = unit.is_silent() and unit.bank.get(1) == 0;
    unit.hear("00 06 00 00 00 05 48 18"_hex);
    return ignored and unit.is_silent() and unit.bank.get(0) == 5;
}
PROOF("a server without an address obeys broadcasts, and answers nobody", has_no_address)

constexpr bool trailing_noise()
{
    unit_1 unit;
    unit.hear(write_3);
    unit.pass(microseconds(1'500));
    unit.hear("00"_hex);
    bool const dropped = unit.is_silent();
    unit.hear(read_1);
    return dropped and unit.says("01 03 02 00 03 F8 45"_hex);
}
PROOF("a byte behind a request drops the response, not what was done", trailing_noise)

constexpr bool power_up()
{
    server node{unit_id{1}, line};
    word_bank<4> bank;
    node.advance(instant{5});
    node.receive(write_3, instant{5});
    node.serve(bank, instant{5});
    return not node.is_asked() and bank.get(1) == 0 and node.poll_deadline() == deadline{instant{5} + line.t3_5()};
}
PROOF("at power-up nothing is obeyed before the line was silent", power_up)

constexpr bool poisoned()
{
    unit_1 unit;
    unit.node.receive(byte_view{write_3}.first(3), unit.now);
    unit.node.receive_error(unit.now);
    unit.hear(byte_view{write_3}.subspan(3));
    return unit.is_silent() and unit.bank.get(1) == 0;
}
PROOF("a request with a damaged byte is not obeyed even if its CRC is right", poisoned)

constexpr bool the_last_request_counts()
{
    unit_1 unit;
    unit.node.receive(write_3, unit.now);
    unit.node.receive(read_1, unit.now);
    unit.pass({});
    return unit.bank.get(1) == 0 and unit.says("01 03 02 00 00 B8 44"_hex);
}
PROOF("a request before the response to the last takes its place", the_last_request_counts)

} // namespace

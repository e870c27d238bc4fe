// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Exceptions 05 and 06: the unit asks for time.
#include <rtuwire/client/client.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using test::manual_unit;
using test::read_eta;
using test::response_1234;

namespace {

constexpr auto is_busy = "01 83 06 C1 32"_hex;
constexpr auto acknowledges = "01 83 05 81 33"_hex;

constexpr bool asks_again_later()
{
    manual_unit unit;
    unit.ask(read_eta);
    unit.say(is_busy);
    unit.run(milliseconds(49));
    bool ok = unit.transmissions == 1 and unit.fault() == errc::busy;
    unit.run(milliseconds(2));
    ok = ok and unit.transmissions == 2;
    unit.say(acknowledges);
    unit.run(milliseconds(99));
    ok = ok and unit.transmissions == 2;
    unit.run(milliseconds(2));
    unit.say(response_1234);
    return ok and unit.transmissions == 3 and unit.has(0x1234);
}
PROOF("a busy unit is asked again, after pauses that double", asks_again_later)

constexpr bool gives_up()
{
    manual_unit unit;
    unit.ask(read_eta);
    for (unsigned i = 0; i < 3; ++i) {
        unit.say(is_busy);
        unit.run(milliseconds(500));
    }
    unit.say(is_busy);
    return unit.transmissions == 4 and unit.fault() == errc::server_device_busy;
}
PROOF("a unit that stays busy is reported", gives_up)

/// Whether a request has left so often, half a second behind its first answer.
constexpr bool leaves_behind(byte_view request, byte_view answer, unsigned times)
{
    manual_unit unit{{.response_timeout = milliseconds(1'000), .retries = 2}};
    unit.ask(request);
    unit.say(answer);
    unit.run(milliseconds(500));
    return unit.transmissions == times;
}
constexpr bool leaves_what_is_under_way()
{
    bool ok = true;
    ok = leaves_behind("01 01 00 00 00 01 FD CA"_hex, "01 81 05 80 53"_hex, 2) and ok;
    ok = leaves_behind("01 02 00 00 00 01 B9 CA"_hex, "01 82 05 80 A3"_hex, 2) and ok;
    ok = leaves_behind("01 03 0C 81 00 01 D7 72"_hex, "01 83 05 81 33"_hex, 2) and ok;
    ok = leaves_behind("01 04 0C 81 00 01 62 B2"_hex, "01 84 05 83 03"_hex, 2) and ok;
    ok = leaves_behind("01 05 00 03 FF 00 7C 3A"_hex, "01 85 05 82 93"_hex, 1) and ok;
    ok = leaves_behind("01 05 00 03 FF 00 7C 3A"_hex, "01 85 06 C2 92"_hex, 2) and ok;
    ok = leaves_behind("01 06 0C 82 00 01 EB 72"_hex, "01 86 05 82 63"_hex, 1) and ok;
    ok = leaves_behind("01 06 0C 82 00 01 EB 72"_hex, "01 86 06 C2 62"_hex, 2) and ok;
    ok = leaves_behind("01 0F 00 03 00 01 01 01 AB 57"_hex, "01 8F 05 84 33"_hex, 1) and ok;
    ok = leaves_behind("01 0F 00 03 00 01 01 01 AB 57"_hex, "01 8F 06 C4 32"_hex, 2) and ok;
    ok = leaves_behind("01 10 0C 82 00 01 02 00 01 B5 B2"_hex, "01 90 05 8C 03"_hex, 1) and ok;
    ok = leaves_behind("01 10 0C 82 00 01 02 00 01 B5 B2"_hex, "01 90 06 CC 02"_hex, 2) and ok;
    ok = leaves_behind("01 16 0C 82 FF FF 00 01 4F 30"_hex, "01 96 05 8F A3"_hex, 1) and ok;
    ok = leaves_behind("01 16 0C 82 FF FF 00 01 4F 30"_hex, "01 96 06 CF A2"_hex, 2) and ok;
    ok = leaves_behind("01 17 0C 82 00 01 0C 82 00 01 02 00 01 DE 3E"_hex, "01 97 05 8E 33"_hex, 1) and ok;
    ok = leaves_behind("01 17 0C 82 00 01 0C 82 00 01 02 00 01 DE 3E"_hex, "01 97 06 CE 32"_hex, 2) and ok;
    manual_unit unit;
    unit.ask("01 06 0C 82 00 01 EB 72"_hex);
    unit.say("01 86 05 82 63"_hex);
    return ok and unit.fault() == errc::acknowledge;
}
PROOF("what a unit has accepted is not sent again, but for a read", leaves_what_is_under_way)

constexpr bool not_for_stale_words()
{
    manual_unit unit;
    static_cast<void>(unit.link.start(request_frame{read_eta, repetition::never}, unit.now));
    unit.transmit();
    unit.say(is_busy);
    return unit.fault() == errc::server_device_busy;
}
PROOF("words that may be out of date are not said again", not_for_stale_words)

constexpr bool asks_once()
{
    manual_unit unit{{.response_timeout = milliseconds(50), .retries = 2}};
    static_cast<void>(unit.link.start(request_frame{read_eta, repetition::never}, unit.now));
    unit.run(milliseconds(500));
    return unit.transmissions == 1 and unit.fault() == errc::timed_out;
}
PROOF("a request that may not be repeated is not, after silence either", asks_once)

constexpr bool pauses_are_bounded()
{
    manual_unit unit;
    retry_policy const long_suffering{.busy_retries = 255, .busy_pause = milliseconds(1)};
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now, long_suffering));
    unit.transmit();
    for (unsigned i = 0; i < 20; ++i) {
        unit.say(is_busy);
        unit.run(milliseconds(66));
    }
    return unit.transmissions == 21;
}
PROOF("however often, a pause is never above 64 times the first", pauses_are_bounded)

} // namespace

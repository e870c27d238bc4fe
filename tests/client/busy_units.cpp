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

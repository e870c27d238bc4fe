// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The cycle, request by request: how many misses it takes, when it asks, what its limits count from.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using cycle = cycle_by_hand<atv12::device>;
using words = cycle::words;

constexpr bool counts_misses_in_a_row()
{
    cycle it{{.tolerated_misses = 2}};
    bool ok = it.begins();
    for (unsigned i = 0; i < 5; ++i) {
        ok = ok and it.fails() and it.fails() and not it.loop.link_lost() and it.exchange();
    }
    ok = ok and it.fails() and it.fails() and not it.loop.link_lost();
    return ok and it.fails() and it.loop.link_lost();
}
PROOF("as many misses in a row as are tolerated lose no link, however often", counts_misses_in_a_row)

constexpr bool tolerates_no_refusal()
{
    cycle it{{.tolerated_misses = 200}};
    bool ok = it.begins() and it.fails() and it.fails(errc::crc_mismatch) and not it.loop.link_lost();
    ok = ok and it.fails(errc::server_device_failure) and it.loop.link_lost();
    return ok and it.loop.control().reason().error == errc::server_device_failure;
}
PROOF("an exception is a response, and no miss: the link is lost at once", tolerates_no_refusal)

constexpr bool tolerates_the_first_miss()
{
    cycle it;
    bool ok = it.fails() and it.loop.control().reason().kind == outcome_kind::pending;
    return ok and it.fails() and it.loop.control().reason().kind == outcome_kind::silent;
}
PROOF("a drive that was never heard is silent after as many misses, too", tolerates_the_first_miss)

constexpr bool looks_for_a_fault_once()
{
    cycle it;
    bool ok = it.begins() and it.exchange(in_fault);
    ok = ok and it.asks();
    ok = ok and u16_at(it.loop.next()->frame(), 2) == lft_address;
    it.hear({9});
    ok = ok and it.loop.control().reason().fault == 9 and it.asks();
    return ok and it.loop.next()->frame()[1] == std::byte{23}; // and no second look at the scanner
}
PROOF("a drive that goes into fault is asked which, then the cycle goes on", looks_for_a_fault_once)

/// When the cycle is due again after an exchange, for this period and this TTO, in 0.1 s.
constexpr duration pause_of(duration period, std::uint16_t tto)
{
    cycle it{{.period = period}};
    static_cast<void>(it.begins(switch_on_disabled, tto));
    static_cast<void>(it.asks());
    it.hear({switch_on_disabled, 0, 0, 0});
    return *it.loop.poll_deadline() - it.now;
}
constexpr bool asks_in_a_third_of_the_time()
{
    return pause_of(milliseconds(9'000), 9) == milliseconds(300) and
           pause_of(milliseconds(299), 9) == milliseconds(299) and
           pause_of(milliseconds(301), 9) == milliseconds(300) and
           pause_of(milliseconds(9'000), 100) == microseconds(3'333'333) and
           pause_of(milliseconds(100), 100) == milliseconds(100) and cyclic_options{}.period == milliseconds(100);
}
PROOF("the period is a third of the drive's time-out at most, which is read from it", asks_in_a_third_of_the_time)

constexpr bool asks_when_due()
{
    cycle it;
    instant const start = it.now;
    bool const is_first_due = it.asks_at(start);
    it.miss();
    bool const is_early = it.asks_at(start + milliseconds(100) - microseconds(1));
    return is_first_due and not is_early and it.asks_at(start + milliseconds(100));
}
PROOF("the first request is due at once, the next a period later and no sooner", asks_when_due)

constexpr bool asks_nothing_before_it_began()
{
    cycle it;
    return not it.loop.next() and it.loop.link_lost() and it.loop.input(0) == 0;
}
PROOF("nothing is asked before the clock is known", asks_nothing_before_it_began)

constexpr bool enables_in_time_from_the_first_order()
{
    cycle it;
    bool ok = not it.loop.run(1'500_rpm); // refused, and the limit does not count from here
    ok = ok and it.begins() and it.exchange(ready);
    instant const ordered = it.now;
    ok = ok and it.loop.run(1'500_rpm);
    it.loop.advance(ordered); // the visit from which it counts
    for (unsigned i = 0; i < 10; ++i) {
        ok = ok and it.exchange(ready) and it.loop.run(1'000_rpm);
    }
    it.loop.advance(ordered + milliseconds(3'000) - microseconds(1));
    ok = ok and it.loop.control().is_ordered();
    it.loop.advance(ordered + milliseconds(3'000));
    return ok and not it.loop.control().is_ordered() and it.loop.control().reason().kind == outcome_kind::state_timeout;
}
PROOF("an order has three seconds to be followed, from when it was first given", enables_in_time_from_the_first_order)

constexpr bool has_as_many_words_as_the_drive()
{
    cycle it;
    it.loop.set_output(3, 0x1234);
    it.loop.set_output(4, 0x5678);
    bool const begins = it.begins();
    bool const is_asked = it.asks();
    auto const request = it.loop.next();
    byte_view const frame = request->frame();
    it.hear({switch_on_disabled, 0, 7, 9});
    bool const is_written =
        frame.size() == 21 and u16_at(frame, 17) == 0x1234 and u16_at(frame, 15) == 0 and u16_at(frame, 11) == 0;
    return begins and is_asked and is_written and it.loop.input(2) == 7 and it.loop.input(3) == 9 and
           it.loop.input(4) == 0;
}
PROOF("words beyond those that the drive has are not written and read 0", has_as_many_words_as_the_drive)

/// Whether the cycle goes on when the scanner's output slots are these.
constexpr bool takes(words slots, std::size_t named)
{
    cycle it;
    it.loop.set_output(named, 1);
    bool ok = it.asks();
    it.hear({switch_on_disabled});
    ok = ok and it.asks();
    it.hear({0});
    return ok and it.tells_its_slots(slots) and it.is_checked() and not it.loop.link_lost();
}
constexpr bool writes_to_known_words_only()
{
    using test::is;
    return is(takes({cmd_address, lfrd_address, 0, 0}, 0), "no further words") and
           is(not takes({cmd_address, lfrd_address, 9001, 0}, 0), "a third word that nobody named") and
           is(not takes({cmd_address, lfrd_address, 0, 9001}, 0), "a fourth word that nobody named") and
           is(takes({cmd_address, lfrd_address, 9001, 0}, 2), "the third word, named") and
           is(takes({cmd_address, lfrd_address, 0, 9001}, 3), "the fourth word, named") and
           is(not takes({cmd_address, lfrd_address, 9002, 9001}, 3), "the fourth word, with a third unnamed") and
           is(not takes({cmd_address, 8503, 0, 0}, 3), "another word for the reference") and
           is(not takes({0, lfrd_address, 0, 0}, 3), "no word for the command");
}
PROOF("an output slot that nobody named must stand for no register", writes_to_known_words_only)

} // namespace

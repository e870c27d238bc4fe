// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes that interrupts had no place for are told whatever the clock shows.
#include <rtuwire/rtu/interrupt_queue.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

/// Counts what it is given.
struct tally {
    constexpr void receive(byte_view received, instant) { bytes += received.size(); }
    constexpr void receive_error(instant at)
    {
        ++errors;
        last_error = at;
    }
    constexpr void sent(instant) {}

    std::size_t bytes{0};
    unsigned errors{0};
    instant last_error{0};
};

constexpr duration tick = microseconds(1);
constexpr std::byte some{0x11};

/// Fills a queue from a time on, and drops one byte more. Returns the time of the drop.
constexpr instant overfill(interrupt_queue<8>& line, instant now)
{
    for (unsigned i = 0; i < 6; ++i) {
        line.receive(some, now);
        now = now + tick;
    }
    line.receive(some, now);
    return now;
}

/// Whether a drop that a byte follows is told once, at its time.
constexpr bool tells_a_drop_at(instant start)
{
    interrupt_queue<8> line;
    tally seen;
    instant const dropped = overfill(line, start);
    line.deliver_to(seen, start + tick); // makes room, and does not come to the drop
    line.receive(some, dropped + tick);
    line.deliver_to(seen, dropped + tick);
    return seen.bytes == 7 and seen.errors == 1 and seen.last_error == dropped and line.overflows() == 1 and
           line.is_empty();
}
constexpr bool tells_a_drop_whenever()
{
    return tells_a_drop_at(instant{1}) and tells_a_drop_at(instant{0x7FFF'FFF0U}) and
           tells_a_drop_at(instant{0x8000'0000U}) and tells_a_drop_at(instant{0xC000'0000U}) and
           tells_a_drop_at(instant{0xFFFF'FF00U}) and tells_a_drop_at(instant{0xFFFF'FFFCU});
}
PROOF("interrupt queue: a drop is told at any time of the clock", tells_a_drop_whenever)

constexpr bool tells_the_next_one_after_an_hour()
{
    interrupt_queue<8> line;
    tally seen;
    instant now{0xFFFF'FF00U};
    instant dropped = overfill(line, now);
    line.deliver_to(seen, dropped + tick); // tells the drop before anything follows it
    line.receive(some, dropped + tick + tick);
    line.deliver_to(seen, dropped + tick + tick);
    bool const first = seen.errors == 1 and line.overflows() == 1;
    now = dropped + milliseconds(30 * 60'000) + milliseconds(30 * 60'000);
    dropped = overfill(line, now);
    line.deliver_to(seen, now + tick);
    line.receive(some, dropped + tick);
    line.deliver_to(seen, dropped + tick);
    return first and seen.errors == 2 and seen.last_error == dropped and line.overflows() == 2;
}
PROOF("interrupt queue: a drop an hour after the last one is told, too", tells_the_next_one_after_an_hour)

// A place takes 6 bytes, up to the capacity of which a position still is one byte.
STATIC_CHECK(sizeof(interrupt_queue<128>) - sizeof(interrupt_queue<64>) == 64 * 6);

} // namespace

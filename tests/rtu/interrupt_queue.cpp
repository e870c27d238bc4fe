// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What interrupts hand over reaches the loop: each event with its time, in order, and no drop unsaid.
#include <rtuwire/rtu/interrupt_queue.hpp>

#include <type_traits>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Writes down each call as a letter, its time and its bytes.
struct notebook {
    struct line {
        char what{};
        std::uint32_t at{};
        std::size_t size{};
        std::byte first{};
        std::byte last{};
        constexpr bool operator==(line const&) const = default;
    };

    constexpr void note(line const& each) { lines[count++] = each; }
    constexpr void receive(byte_view bytes, instant at)
    {
        note({'r', at.microseconds, bytes.size(), bytes.front(), bytes.back()});
    }
    constexpr void receive_error(instant at) { note({'e', at.microseconds}); }
    constexpr void sent(instant at) { note({'s', at.microseconds}); }

    constexpr bool is(std::size_t number, char what, std::uint32_t at) const
    {
        return number < count and lines[number].what == what and lines[number].at == at;
    }
    constexpr bool got(std::size_t number, std::uint32_t at, unsigned value) const
    {
        return is(number, 'r', at) and lines[number].size == 1 and
               lines[number].first == std::byte{static_cast<std::uint8_t>(value)};
    }

    std::array<line, 64> lines{};
    std::size_t count{0};
};

/// One that has a call for overruns, as a server has.
struct server_notebook : notebook {
    constexpr void receive_overrun(instant at) { note({'o', at.microseconds}); }
};

constexpr std::byte operator""_b(unsigned long long value) { return std::byte{static_cast<std::uint8_t>(value)}; }

constexpr bool keeps_order_and_times()
{
    interrupt_queue<8> line;
    notebook seen;
    line.receive(0x11_b, instant{10});
    line.receive(0x12_b, instant{20});
    line.sent(instant{25});
    line.receive_error(instant{30});
    line.receive_overrun(instant{31});
    line.receive(0x13_b, instant{40});
    line.deliver_to(seen, instant{50});
    using test::is;
    return is(seen.count == 6, "six events are delivered") and is(seen.got(0, 10, 0x11), "the first byte") and
           is(seen.got(1, 20, 0x12), "the second byte") and is(seen.is(2, 's', 25), "the end of a transmission") and
           is(seen.is(3, 'e', 30), "the receive error") and is(seen.is(4, 'e', 31), "the overrun") and
           is(seen.got(5, 40, 0x13), "the third byte") and is(line.is_empty(), "the queue is empty then") and
           is(line.overflows() == 0, "none was dropped");
}
PROOF("interrupt queue: events keep their order and their times", keeps_order_and_times)

constexpr bool tells_overruns_apart()
{
    interrupt_queue<8> line;
    server_notebook seen;
    line.receive_error(instant{1});
    line.receive_overrun(instant{2});
    line.deliver_to(seen, instant{5});
    return seen.count == 2 and seen.is(0, 'e', 1) and seen.is(1, 'o', 2);
}
PROOF("interrupt queue: an overrun goes to a call of its own where there is one", tells_overruns_apart)

constexpr bool lumps_stay_whole()
{
    interrupt_queue<16> line;
    notebook seen;
    // Moves the wrap into the middle of the lump.
    for (unsigned i = 0; i < 12; ++i) {
        line.receive(0_b, instant{i});
        line.deliver_to(seen, instant{i});
    }
    seen = {};
    line.receive("01 02 03 04 05 06 07 08"_hex, instant{90});
    line.receive(0x09_b, instant{91});
    line.deliver_to(seen, instant{100});
    return seen.count == 2 and seen.lines[0] == notebook::line{'r', 90, 8, 0x01_b, 0x08_b} and seen.got(1, 91, 0x09);
}
PROOF("interrupt queue: bytes of one interrupt arrive in one piece, others apart", lumps_stay_whole)

constexpr bool waits_for_its_time()
{
    interrupt_queue<8> line;
    notebook seen;
    line.receive(0x11_b, instant{0xFFFF'FFFFU});
    line.receive(0x12_b, instant{1});
    line.deliver_to(seen, instant{0xFFFF'FFFEU});
    bool const is_early = seen.count == 0 and not line.is_empty();
    line.deliver_to(seen, instant{0});
    bool const is_half = seen.count == 1 and not line.is_empty();
    line.deliver_to(seen, instant{1});
    return is_early and is_half and seen.count == 2 and seen.got(1, 1, 0x12) and line.is_empty();
}
PROOF("interrupt queue: what is later than the loop's time waits, across the wrap of the clock", waits_for_its_time)

/// A queue of 8 with its 6 places for bytes filled at the times 1 to 6.
struct full_queue {
    constexpr full_queue()
    {
        for (unsigned i = 1; i <= 6; ++i) {
            line.receive(0x11_b, instant{i});
        }
    }
    interrupt_queue<8> line{};
    notebook seen{};
};

constexpr bool full_is_not_dropped()
{
    full_queue full;
    full.line.deliver_to(full.seen, instant{10});
    return full.seen.count == 6 and full.line.overflows() == 0 and full.line.is_empty();
}
PROOF("interrupt queue: two places less than its capacity are for bytes", full_is_not_dropped)

constexpr bool drop_is_told_where_it_was()
{
    full_queue full;
    full.line.receive(0x12_b, instant{7}); // dropped
    full.line.receive(0x13_b, instant{8}); // dropped
    bool const has_news = not full.line.is_empty();
    full.line.deliver_to(full.seen, instant{10});
    bool const is_told =
        full.seen.count == 7 and full.seen.is(6, 'e', 10) and full.line.overflows() == 1 and full.line.is_empty();
    // It is not told again: not in the next pass, and not before the next byte.
    full.line.deliver_to(full.seen, instant{11});
    full.line.receive(0x14_b, instant{20});
    full.line.deliver_to(full.seen, instant{21});
    return has_news and is_told and full.seen.count == 8 and full.seen.got(7, 20, 0x14) and full.line.overflows() == 1;
}
PROOF("interrupt queue: a drop at the end is told as a receive error of now, once", drop_is_told_where_it_was)

constexpr bool drop_stands_between()
{
    full_queue full;
    full.line.receive(0x12_b, instant{7}); // dropped
    full.line.deliver_to(full.seen, instant{1});
    full.line.receive(0x13_b, instant{8}); // dropped: it wants a place for the drop, too
    full.line.deliver_to(full.seen, instant{2});
    full.line.receive(0x14_b, instant{9});
    full.line.deliver_to(full.seen, instant{9});
    return full.seen.count == 8 and full.seen.got(5, 6, 0x11) and full.seen.is(6, 'e', 8) and
           full.seen.got(7, 9, 0x14) and full.line.overflows() == 1;
}
PROOF("interrupt queue: a drop stands between what came before and after it", drop_stands_between)

constexpr bool second_drop_is_told()
{
    full_queue full;
    full.line.receive(0x12_b, instant{7}); // dropped
    full.line.deliver_to(full.seen, instant{10});
    full.seen = {};
    for (unsigned i = 11; i <= 16; ++i) {
        full.line.receive(0x15_b, instant{i}); // the first brings the old drop, the last is dropped
    }
    full.line.deliver_to(full.seen, instant{20});
    full.line.receive(0x16_b, instant{21});
    full.line.deliver_to(full.seen, instant{22});
    using test::is;
    return is(full.seen.count == 7, "seven events are delivered") and
           is(full.seen.got(0, 11, 0x15), "the first byte") and
           is(full.seen.got(4, 15, 0x15), "the last byte that had room") and
           is(full.seen.is(5, 'e', 20), "an error for the second drop") and
           is(full.seen.got(6, 21, 0x16), "the byte after it") and is(full.line.overflows() == 2, "two were dropped");
}
PROOF("interrupt queue: another drop is told again", second_drop_is_told)

constexpr bool errors_are_not_dropped_silently()
{
    full_queue full;
    full.line.receive_error(instant{7}); // no place
    full.line.deliver_to(full.seen, instant{10});
    return full.seen.count == 7 and full.seen.is(6, 'e', 10);
}
PROOF("interrupt queue: a receive error without a place is told as a drop", errors_are_not_dropped_silently)

constexpr bool sent_has_a_place()
{
    full_queue full;
    full.line.receive(0x12_b, instant{7}); // dropped
    full.line.sent(instant{8});
    full.line.receive(0x13_b, instant{9}); // dropped
    full.line.deliver_to(full.seen, instant{10});
    return full.seen.count == 9 and full.seen.is(6, 'e', 7) and full.seen.is(7, 's', 8) and full.seen.is(8, 'e', 10) and
           full.line.overflows() == 2;
}
PROOF("interrupt queue: sent has a place when nothing else has, with what was dropped before it", sent_has_a_place)

constexpr bool two_sent_have_places()
{
    full_queue full;
    full.line.sent(instant{7});
    full.line.receive(0x12_b, instant{8}); // dropped
    full.line.sent(instant{9});            // the place for the drop is taken
    full.line.receive(0x13_b, instant{9}); // dropped
    full.line.deliver_to(full.seen, instant{10});
    return full.seen.count == 9 and full.seen.is(6, 's', 7) and full.seen.is(7, 's', 9) and full.seen.is(8, 'e', 10);
}
PROOF("interrupt queue: two transmissions that nobody took note of have places", two_sent_have_places)

constexpr bool runs_round()
{
    interrupt_queue<128> line;
    notebook seen;
    for (unsigned round = 0; round < 1'000; ++round) {
        seen = {};
        for (unsigned i = 0; i < 40; ++i) {
            line.receive(std::byte{static_cast<std::uint8_t>(i)}, instant{round * 100 + i});
        }
        line.deliver_to(seen, instant{round * 100 + 50});
        if (seen.count != 40 or not seen.got(39, round * 100 + 39, 39)) {
            return false;
        }
    }
    return line.is_empty() and line.overflows() == 0;
}
TEST_CASE("interrupt queue: its positions wrap") { CHECK(runs_round()); }

template <std::size_t Capacity> constexpr bool holds()
{
    interrupt_queue<Capacity> line;
    for (std::size_t i = 0; i < Capacity - 2; ++i) {
        line.receive(0x11_b, instant{0});
    }
    notebook seen;
    line.deliver_to(seen, instant{0});
    bool const is_whole = seen.count == 1 and seen.lines[0].size == Capacity - 2;
    return is_whole and line.overflows() == 0;
}
STATIC_CHECK(holds<8>());
STATIC_CHECK(holds<64>());
STATIC_CHECK(holds<128>());
STATIC_CHECK(holds<256>());

// The interrupt has its address: it is neither copied nor moved. 6 bytes a place.
STATIC_CHECK(not std::is_copy_constructible_v<interrupt_queue<>>);
STATIC_CHECK(not std::is_copy_assignable_v<interrupt_queue<>>);
STATIC_CHECK(sizeof(interrupt_queue<>) <= 64 * 6 + 24);
STATIC_CHECK(sizeof(interrupt_queue<256>) <= 256 * 6 + 24);

} // namespace

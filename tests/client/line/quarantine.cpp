// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The times in which units are asked nothing new; the echo of a request; what a client does unless told.
#include <rtuwire/client/line/request.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/client/client.hpp>
#include <rtuwire/client/needs.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr instant begin{0xFFFF'FF00U};
constexpr instant after(std::uint32_t time_ms) { return begin + milliseconds(time_ms); }

constexpr bool has_a_place_for_each()
{
    quarantine<2> held;
    held.begin(7, after(100));
    held.begin(9, after(50));
    bool ok = held.covers(7) and held.covers(9) and not held.covers(8) and not held.covers(0);
    // Each has its own end; an earlier one changes nothing.
    held.begin(7, after(20));
    held.begin(9, after(70));
    ok = ok and not held.advance(after(70) - microseconds(1)) and held.covers(9);
    ok = ok and held.advance(after(70)) and not held.covers(9) and held.covers(7);
    ok = ok and not held.advance(after(100) - microseconds(1)) and held.covers(7);
    return ok and held.advance(after(100)) and not held.covers(7) and not held.advance(after(200));
}
PROOF("each unit is held until its own last end", has_a_place_for_each)

constexpr bool holds_all_where_places_are_few()
{
    quarantine<2> held;
    held.begin(7, after(100));
    held.begin(9, after(50));
    held.begin(11, after(60));
    bool ok = held.covers(200) and not held.covers(0);
    ok = ok and held.advance(after(100)) and not held.covers(200) and not held.covers(7);
    held.begin(5, after(300));
    return ok and held.covers(5) and not held.covers(7);
}
PROOF("where more units owe a response than there are places, all are held", holds_all_where_places_are_few)

/// Of a unit that owes so many, the first sent at `begin`, whose waits may take 500 ms in all.
constexpr owed_responses owed_by(std::uint32_t count) { return {begin, milliseconds(500), count}; }

constexpr bool holds_on_for_what_is_owed()
{
    constexpr duration late = milliseconds(20);
    quarantine<2> held;
    held.begin(7, after(300), owed_by(3));
    held.begin(9, after(200));
    held.note_late(9, after(100), late); // held, but owes nothing
    held.note_late(8, after(100), late);
    bool ok = held.advance(after(200)) and not held.covers(9);
    held.note_late(7, after(150), late); // two are left, each within 150 ms and 20
    ok = ok and not held.advance(after(490) - microseconds(1)) and held.covers(7);
    held.note_late(7, after(480), late); // one is left
    ok = ok and not held.advance(after(980) - microseconds(1));
    held.note_late(7, after(970), late); // none
    held.note_late(7, after(975), late);
    return ok and held.advance(after(980)) and not held.covers(7);
}
PROOF("a late answer holds its unit on for those that are still owed", holds_on_for_what_is_owed)

constexpr bool holds_on_no_longer_than_all()
{
    constexpr duration late = milliseconds(20);
    for (std::uint32_t const minutes : {1U, 35U, 36U, 50U, 71U}) { // the program was stopped
        quarantine<1> held;
        held.begin(7, after(300), owed_by(200));
        instant const now{begin.microseconds + minutes * 60'000'000U};
        held.note_late(7, now, late);
        if (not held.advance(within_reach(begin, now + milliseconds(520)))) {
            return false;
        }
    }
    return true;
}
PROOF("but no longer than all its sendings and their waits may take", holds_on_no_longer_than_all)

constexpr bool owes_for_several()
{
    constexpr duration late = milliseconds(20);
    quarantine<1> held;
    held.begin(7, after(300), owed_by(1));
    held.begin(7, after(350),
               {after(310), milliseconds(40), 1}); // a stop passed the hold: the first is the older one still
    held.note_late(7, after(340), late);
    bool ok = not held.advance(after(700) - microseconds(1)) and held.advance(after(700));
    held.begin(7, after(800), {after(750), milliseconds(40), 1}); // what was owed before is forgotten with its hold
    held.note_late(7, after(790), late);
    ok = ok and held.advance(after(800));
    held.begin(7, after(900), owed_by(2));
    held.begin(9, after(910)); // all units
    held.note_late(5, after(880), late);
    return ok and held.advance(after(880) + milliseconds(520)) and not held.covers(7);
}
PROOF("what is owed by several requests, and by all units, is added up", owes_for_several)

constexpr bool compares_an_echo()
{
    constexpr std::array<std::byte, 8> sent{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4},
                                            std::byte{5}, std::byte{6}, std::byte{7}, std::byte{8}};
    line_echo echo;
    bool ok = not echo.is_open() and not echo.is_whole();
    echo.begin();
    for (std::size_t i = 0; i < sent.size(); ++i) {
        ok = ok and echo.is_open() and echo.taken() == i and not echo.is_whole();
        ok = ok and echo.take({&sent[i], 1}, sent) == 1;
    }
    ok = ok and not echo.is_open() and echo.is_whole() and echo.taken() == 0;
    echo.begin();
    ok = ok and echo.take(byte_view{sent}.first(3), sent) == 3 and echo.taken() == 3;
    ok = ok and echo.take(byte_view{sent}.subspan(3), sent) == 5 and echo.is_whole();
    echo.begin();
    echo.end();
    ok = ok and not echo.is_open() and not echo.is_whole();
    echo.begin();
    return ok and echo.take({&sent[1], 1}, sent) == 0 and not echo.is_open() and not echo.is_whole();
}
PROOF("an echo is open until its last byte or another one", compares_an_echo)

constexpr bool learns_an_echo()
{
    line_echo echo;
    echo.doubt();
    bool ok = not echo.is_known() and not echo.is_proven();
    echo.note_seen();
    ok = ok and echo.is_known() and not echo.is_proven();
    echo.note_seen();
    echo.note_seen();
    ok = ok and echo.is_proven();
    echo.doubt();
    ok = ok and echo.is_known() and not echo.is_proven();
    echo.forget();
    return ok and not echo.is_known();
}
PROOF("a line is known to echo when it did once, for sure when twice, and until it is forgotten", learns_an_echo)

STATIC_CHECK(retry_policy{}.response_timeout == milliseconds(1'000) and retry_policy{}.retries == 2);
STATIC_CHECK(retry_policy{}.busy_retries == 3 and retry_policy{}.busy_pause == milliseconds(50));
STATIC_CHECK(client_options{}.response_timeout == milliseconds(1'000));
STATIC_CHECK(client_options{}.turnaround == milliseconds(100));
STATIC_CHECK(client_options{}.late_response == milliseconds(200) and client_options{}.retries == 2);
STATIC_CHECK(not client_options{}.has_line_echo and client_options{}.max_leading_noise == 0);

} // namespace

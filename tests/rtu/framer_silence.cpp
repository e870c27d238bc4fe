// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What silence ends, to the microsecond.
#include <rtuwire/rtu/framer.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
// Five seconds before the counter wraps.
constexpr instant start{0xFFFF'FFFFU - 5'000'000U};
constexpr auto request = "02 03 0C 1E 00 04 27 6C"_hex;
constexpr auto reply_of_one = "02 03 02 12 00 F0 E4"_hex;

constexpr bool ends_an_open_end()
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    for (line_timing const& timing : {line, host}) {
        framer<direction::request> receiver{timing};
        receiver.advance(start);
        receiver.advance(start + milliseconds(100));
        receiver.note_foreign_request(2, 3);
        instant const last = start + milliseconds(200);
        receiver.receive(reply_of_one, last); // a byte 00 might follow, and make it a request
        bool const is_open = not receiver.poll_frame() and not receiver.is_at_start();
        receiver.advance(last + timing.t3_5() - microseconds(1));
        bool const stays = not receiver.poll_frame();
        receiver.advance(last + timing.t3_5());
        auto const frame = receiver.poll_frame();
        bool const ended = frame and *frame and receiver.is_foreign_response() and receiver.is_at_start();
        if (not is_open or not stays or not ended or not same_bytes((*frame)->bytes(), reply_of_one)) {
            return false;
        }
    }
    return true;
}
PROOF("a response with an open end has ended after t3.5, as the response", ends_an_open_end)

/// Damage that is reported so long after the last activity of a line that was not silent yet: whether it is the
/// first byte of a frame, which is then refused.
constexpr bool begins_a_frame(duration after)
{
    framer<direction::request> receiver{line};
    receiver.advance(start);
    instant const then = start + after;
    receiver.receive_error(then);
    receiver.receive(request, then + line.characters(request.size()));
    receiver.advance(then + milliseconds(50));
    auto const frame = receiver.poll_frame();
    return frame and frame->error() == errc::uart_error;
}
constexpr bool damage_after_silence()
{
    duration const least = line.frame_end() + line.characters(1);
    return begins_a_frame(least) and not begins_a_frame(duration{least.microseconds - 1});
}
PROOF("damage is of a new frame where it comes a byte behind the silence that ended the last", damage_after_silence)

constexpr bool believes_what_is_sent()
{
    framer<direction::response> receiver{line};
    receiver.note_activity(start);
    instant const before = start - (line.characters(max_adu_size) + milliseconds(100));
    instant const long_after = before - microseconds(1); // the clock has gone round
    return receiver.within_reach_of_line(before) == before and
           receiver.within_reach_of_line(long_after) == before + duration{0x8000'0000U};
}
PROOF("a frame that is sent may end 256 characters and 100 ms ahead of the clock", believes_what_is_sent)

} // namespace

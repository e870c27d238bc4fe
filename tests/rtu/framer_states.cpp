// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The framer's table of states, each with each input. States are told apart by what a framer does next.
#include <rtuwire/rtu/framer.hpp>

#include "rtu/framer_table.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace test::framer_table;

namespace {

// A host's times: its frame_end is longer than t3.5.
constexpr auto line = line_timing::host(19'200, character_format::even_8_1);
constexpr instant start{0xFFFF'FFFFU - 100'000U};
constexpr auto request = "02 03 0C 1E 00 04 27 6C"_hex;
constexpr auto reply_of_one = "02 03 02 12 00 F0 E4"_hex;
constexpr auto other_byte = "55"_hex;

using listener = framer<direction::request>;

/// Brings a new framer into a state. Receiving: the last byte of the frame is missing.
constexpr void bring(listener& to, state wanted, byte_view frame)
{
    to.advance(start);
    if (wanted == state::synchronising) {
        return;
    }
    instant const now = start + milliseconds(200);
    to.advance(now);
    if (same_bytes(frame, reply_of_one)) {
        to.note_foreign_request(2, 3);
    }
    if (wanted != state::idle) {
        static_cast<void>(to.receive(wanted == state::receiving ? frame.first(frame.size() - 1) : frame, now));
    }
}

/// The state that a framer was in; it goes on from there.
constexpr state take_state(listener& of)
{
    if (of.poll_frame()) {
        return state::done;
    }
    if (of.is_at_start()) {
        return state::idle;
    }
    instant const last = of.last_activity();
    of.advance(last + line.t3_5());
    if (of.poll_frame()) {
        return state::open_end;
    }
    of.advance(last + line.frame_end());
    return of.poll_frame() ? state::receiving : state::synchronising;
}

constexpr void apply(listener& to, input what)
{
    instant const now = to.last_activity();
    switch (what) {
    case input::byte: static_cast<void>(to.receive(other_byte, now)); break;
    case input::last_byte: static_cast<void>(to.receive(byte_view{request}.last(1), now)); break;
    case input::open_last_byte: static_cast<void>(to.receive(byte_view{reply_of_one}.last(1), now)); break;
    case input::damaged_byte: to.receive_error(now); break;
    case input::t3_5: to.advance(now + line.t3_5()); break;
    case input::frame_end: to.advance(now + line.frame_end()); break;
    case input::poll_frame: static_cast<void>(to.poll_frame()); break;
    case input::restart: to.restart(now); break;
    case input::resynchronise: to.resynchronise(); break;
    }
}

/// Whether an input leads from a state to the one that the table says.
constexpr bool holds(state from, input what)
{
    bool const is_open = from == state::open_end or (from == state::receiving and what == input::open_last_byte);
    byte_view const frame = is_open ? byte_view{reply_of_one} : byte_view{request};
    listener before{line};
    bring(before, from, frame);
    listener it{line};
    bring(it, from, frame);
    apply(it, what);
    return take_state(before) == from and
           take_state(it) == next[static_cast<std::size_t>(from)][static_cast<std::size_t>(what)];
}

template <std::size_t From> constexpr bool row_holds()
{
    for (std::size_t what = 0; what < inputs; ++what) {
        if (not holds(static_cast<state>(From), static_cast<input>(what))) {
            return false;
        }
    }
    return true;
}
PROOF("synchronising: only silence, or a restart, leads on", row_holds<0>)
PROOF("idle: the next byte begins a frame", row_holds<1>)
PROOF("receiving: the last byte or frame_end ends a frame", row_holds<2>)
PROOF("open end: a byte or t3.5 ends the frame", row_holds<3>)
PROOF("done: until it is polled, or the next byte arrives", row_holds<4>)

} // namespace

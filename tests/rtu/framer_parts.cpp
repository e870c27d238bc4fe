// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The parts of a framer that a server and a client use.
#include <rtuwire/rtu/framer.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/rtu/line.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
// Five seconds before the counter wraps.
constexpr instant start{0xFFFF'FFFFU - 5'000'000U};
constexpr auto asks_2 = "02 03 0C 81 00 01 D7 41"_hex;
constexpr auto writes_2 = "02 06 21 35 00 00 93 CB"_hex;

/// The parts, on a line that has been silent.
template <direction Way> struct listener_of {
    using cutter = framer_state<Way, frame_place<0>, stored<line_timing>>;
    cutter framer{};
    typename cutter::memory memory{line};
    instant now{start};

    constexpr listener_of()
    {
        framer.advance(memory, now);
        pause(milliseconds(100));
    }

    constexpr void pause(duration length)
    {
        now = now + length;
        framer.advance(memory, now);
    }

    constexpr void hear(byte_view bytes)
    {
        now = now + line.characters(bytes.size());
        static_cast<void>(framer.receive(memory, bytes, now));
    }

    /// Why what ended is refused; busy while nothing ended.
    constexpr errc fault() { return framer.poll_end() ? framer.verdict(memory) : errc::busy; }
};

constexpr bool looks_addressed_to()
{
    listener_of<direction::response> listener;
    bool const nobody = not listener_of<direction::request>{}.framer.is_foreign_response();
    listener.hear("02 03 00"_hex);
    listener.pause(milliseconds(10));
    bool const too_short =
        listener.fault() == errc::frame_too_short and not listener.framer.looks_addressed_to(listener.memory, asks_2);
    listener.hear("02 03 00 00"_hex);
    bool const starts = not listener.framer.is_at_start();
    listener.pause(milliseconds(10));
    using test::is;
    return is(nobody, "a receiver of requests begins with no response") and
           is(too_short, "three bytes are too short") and is(starts, "four bytes begin a frame") and
           is(listener.fault() == errc::crc_mismatch, "the CRC of four bytes is wrong") and
           is(listener.framer.looks_addressed_to(listener.memory, asks_2), "they look like a response to the read") and
           is(not listener.framer.looks_addressed_to(listener.memory, writes_2),
              "they do not look like a response to the write") and
           is(listener.framer.is_at_start(), "the next byte begins a frame");
}
PROOF("what has a frame's size and begins like a response claims to be one", looks_addressed_to)

constexpr bool byte_by_byte()
{
    listener_of<direction::request> listener;
    for (std::size_t i = 0; i < asks_2.size(); ++i) {
        listener.now = listener.now + line.characters(1);
        bool const is_early =
            listener.framer.begin_chunk(listener.memory, 1, listener.now) or listener.framer.poll_end();
        if (is_early or listener.framer.push(listener.memory, asks_2[i]) != (i + 1 == asks_2.size())) {
            return false;
        }
    }
    return listener.fault() == errc::none and listener.framer.matches_size_hint() and
           same_bytes(listener.framer.frame(listener.memory).bytes(), asks_2) and listener.fault() == errc::busy;
}
PROOF("byte by byte the last one says so, and the frame is polled once", byte_by_byte)

} // namespace

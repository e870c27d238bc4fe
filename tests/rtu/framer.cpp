// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames out of bytes and silence.
#include <rtuwire/rtu/framer.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
// Five seconds before the counter wraps.
constexpr instant start{0xFFFF'FFFFU - 5'000'000U};

/// A framer that has heard silence, and its clock.
template <direction Way> struct listener_of {
    framer<Way> receiver;
    instant now{start};

    explicit constexpr listener_of(line_timing const& timing = line) : receiver{timing}
    {
        receiver.advance(now);
        pause(milliseconds(100));
    }

    constexpr void pause(duration length)
    {
        now = now + length;
        receiver.advance(now);
    }

    constexpr std::size_t hear(byte_view bytes)
    {
        now = now + line.characters(bytes.size());
        return receiver.receive(bytes, now);
    }

    /// What ended: none while nothing did.
    constexpr errc fault()
    {
        auto const frame = receiver.poll_frame();
        return frame ? frame->error() : errc::busy;
    }

    constexpr bool none_yet() { return not receiver.poll_frame(); }

    /// Whether a frame ended that is these bytes.
    constexpr bool has(byte_view bytes)
    {
        auto const frame = receiver.poll_frame();
        if (not frame or not *frame) {
            return false;
        }
        return (*frame)->unit() == to_u8(bytes[0]) and same_bytes((*frame)->pdu(), bytes.subspan(1, bytes.size() - 3));
    }
};

constexpr auto request = "02 03 0C 1E 00 04 27 6C"_hex;
constexpr auto reply = "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex;

constexpr bool ends_by_rule()
{
    listener_of<direction::request> listener;
    bool const early = listener.hear(byte_view{request}.first(7)) == 7 and listener.none_yet();
    return early and listener.hear(byte_view{request}.last(1)) == 1 and listener.has(request) and listener.none_yet();
}
PROOF("a frame ends with the last byte of its length rule", ends_by_rule)

constexpr bool leaves_the_rest()
{
    listener_of<direction::response> listener;
    std::array<std::byte, reply.size() + 1> noisy{};
    byte_writer out{noisy};
    out.bytes(reply);
    bool const taken = listener.hear(noisy) == reply.size() and listener.has(reply);
    constexpr auto zero = "00"_hex;
    bool const noise = listener.hear(zero) == 1 and listener.none_yet();
    listener.pause(line.t3_5());
    return taken and noise and listener.fault() == errc::frame_too_short;
}
PROOF("bytes behind a frame are no part of it", leaves_the_rest)

// The one-register answer whose last byte is 00 passes the CRC without it too.
constexpr bool a_matching_crc_ends_nothing()
{
    constexpr auto frame = "01 04 02 03 01 78 00"_hex;
    listener_of<direction::response> listener;
    bool const waits =
        crc16(byte_view{frame}.first(6)) == 0 and listener.hear(byte_view{frame}.first(6)) == 6 and listener.none_yet();
    listener.hear(byte_view{frame}.last(1));
    return waits and listener.has(frame);
}
PROOF("a CRC that matches early ends nothing", a_matching_crc_ends_nothing)

constexpr bool damage_waits_for_silence()
{
    auto damaged = request;
    damaged[3] ^= std::byte{1};
    listener_of<direction::request> listener;
    listener.hear(damaged);
    bool const waits = listener.none_yet();
    listener.hear(request);
    bool const still = listener.none_yet();
    listener.pause(line.t3_5());
    bool const refused = listener.fault() == errc::crc_mismatch;
    listener.hear(request);
    return waits and still and refused and listener.has(request);
}
PROOF("after a wrong CRC only silence starts a new frame", damage_waits_for_silence)

constexpr bool longer_than_its_rule()
{
    // Function 06 with one byte too many: as a whole it has a right CRC, and the PDU refuses it.
    constexpr auto frame = "01 06 00 01 00 03 00 0A AA"_hex;
    listener_of<direction::request> listener;
    listener.hear(frame);
    bool const waits = crc16(frame) == 0 and listener.none_yet();
    listener.pause(line.t3_5());
    return waits and listener.has(frame);
}
PROOF("a frame longer than its rule is whole when silence says so", longer_than_its_rule)

constexpr bool sizes_at_the_edge()
{
    std::array<std::byte, 257> bytes{};
    bytes[0] = std::byte{1};
    bytes[1] = std::byte{0x41};
    std::uint16_t const crc = crc16(byte_view{bytes}.first(254));
    bytes[254] = to_byte(crc);
    bytes[255] = to_byte(std::uint32_t{crc} >> 8U);
    listener_of<direction::request> listener;
    listener.hear(byte_view{bytes}.first(256));
    listener.pause(line.t3_5());
    bool const longest = listener.has(byte_view{bytes}.first(256));
    listener.hear(bytes);
    listener.pause(line.t3_5());
    bool const too_long = listener.fault() == errc::frame_too_long;
    listener.hear("FF FF"_hex);
    listener.pause(line.t3_5());
    return longest and too_long and listener.fault() == errc::frame_too_short;
}
PROOF("256 bytes are a frame, 257 and 2 are none", sizes_at_the_edge)

constexpr bool poison()
{
    listener_of<direction::request> listener;
    listener.hear(byte_view{request}.first(4));
    listener.receiver.receive_error(listener.now);
    listener.hear(byte_view{request}.subspan(4));
    bool const held = listener.none_yet();
    listener.pause(line.t3_5());
    bool const refused = listener.fault() == errc::uart_error;
    listener.hear(request);
    return held and refused and listener.has(request);
}
PROOF("a damaged byte poisons its frame even if the CRC is right, and no other", poison)

constexpr bool power_up()
{
    framer<direction::request> receiver{line};
    instant now = start;
    receiver.advance(now);
    receiver.receive(request, now);
    bool const deaf = not receiver.poll_frame() and not receiver.is_quiet();
    now = now + line.t3_5();
    receiver.advance(now);
    receiver.receive(request, now + line.characters(8));
    return deaf and receiver.poll_frame().has_value();
}
constexpr bool bytes_before_the_clock()
{
    framer<direction::request> receiver{line};
    return receiver.receive(request, start) == 8 and not receiver.poll_frame() and not receiver.is_quiet() and
           receiver.receive({}, start) == 0;
}
PROOF("bytes before time is known are ignored too", bytes_before_the_clock)
PROOF("at power-up everything is ignored until the line was silent", power_up)

constexpr bool a_lump_after_silence()
{
    listener_of<direction::request> listener;
    listener.hear(byte_view{request}.first(3));
    listener.now = listener.now + milliseconds(20);
    bool const closed = listener.hear(request) == 0 and listener.fault() == errc::frame_too_short;
    return closed and listener.receiver.receive(request, listener.now) == 8 and listener.has(request);
}
PROOF("a lump that comes after silence starts a new frame", a_lump_after_silence)

/// A lump of two bytes `length` after the last byte of an unfinished frame.
constexpr bool starts_anew_after(duration length)
{
    listener_of<direction::request> listener;
    listener.hear(byte_view{request}.first(6));
    listener.now = listener.now + length;
    listener.receiver.receive(byte_view{request}.last(2), listener.now);
    return not listener.has(request);
}
constexpr bool the_edge_of_silence()
{
    return starts_anew_after(microseconds(2'006 + 2 * 573)) and
           not starts_anew_after(microseconds(2'006 + 2 * 573 - 1));
}
PROOF("a lump starts a new frame when its own time and t3.5 have passed", the_edge_of_silence)

constexpr bool host_gaps()
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    listener_of<direction::request> listener{host};
    listener.hear(byte_view{request}.first(3));
    listener.pause(milliseconds(45));
    listener.hear(byte_view{request}.subspan(3));
    bool const whole = listener.has(request);
    listener.hear(byte_view{request}.first(3));
    listener.pause(milliseconds(50));
    return whole and listener.fault() == errc::frame_too_short;
}
PROOF("on a host a gap of an adapter does not cut a frame", host_gaps)

constexpr bool deadlines()
{
    framer<direction::request> receiver{line};
    bool const none_before_start = not receiver.poll_deadline();
    receiver.advance(start);
    bool const first_silence = receiver.poll_deadline() == deadline{start + line.t3_5()};
    receiver.advance(start + line.t3_5());
    bool const none_when_quiet = not receiver.poll_deadline() and receiver.is_quiet();
    instant const then = start + milliseconds(60'000);
    receiver.receive(byte_view{request}.first(1), then);
    bool const end_of_fragment = receiver.poll_deadline() == deadline{then + line.t3_5()};
    return none_before_start and first_silence and none_when_quiet and end_of_fragment and not receiver.is_quiet();
}
PROOF("a framer wants to be woken only for silence", deadlines)

constexpr bool host_deadlines()
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    listener_of<direction::request> listener{host};
    listener.hear(byte_view{request}.first(3));
    instant const last = listener.now;
    bool const to_send = listener.receiver.poll_deadline() == deadline{last + host.t3_5()};
    listener.pause(host.t3_5());
    return to_send and listener.receiver.is_quiet() and
           listener.receiver.poll_deadline() == deadline{last + host.frame_end()};
}
PROOF("on a host it is woken twice: when somebody may send, and when what it has is all", host_deadlines)

constexpr bool takes_all_of_a_lump()
{
    std::array<std::byte, 300> bytes{};
    listener_of<direction::request> listener;
    return listener.hear(bytes) == bytes.size() and listener.none_yet();
}
PROOF("bytes that no frame has room for are taken all the same", takes_all_of_a_lump)

} // namespace

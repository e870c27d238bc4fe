// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames out of octets and silence.
#include <rtuwire/rtu/framer.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
// Five seconds before the counter wraps.
constexpr instant start{0xFFFF'FFFFU - 5'000'000U};

/// A framer that has heard silence, and its clock.
template <direction Way> struct listener {
    framer<Way> receiver;
    instant now{start};

    explicit constexpr listener(line_timing const& timing = line) : receiver{timing}
    {
        receiver.advance(now);
        pause(milliseconds(100));
    }

    constexpr void pause(duration length)
    {
        now = now + length;
        receiver.advance(now);
    }

    constexpr std::size_t hear(byte_view octets)
    {
        now = now + line.characters(octets.size());
        return receiver.receive(octets, now);
    }

    /// What ended: none while nothing did.
    constexpr errc fault()
    {
        auto const frame = receiver.poll_frame();
        return frame ? frame->error() : errc::busy;
    }

    /// Whether a frame ended that is these octets.
    constexpr bool has(byte_view octets)
    {
        auto const frame = receiver.poll_frame();
        if (not frame or not *frame) {
            return false;
        }
        return (*frame)->unit() == to_u8(octets[0]) and
               same_bytes((*frame)->pdu(), octets.subspan(1, octets.size() - 3));
    }
};

constexpr auto request = "02 03 0C 1E 00 04 27 6C"_hex;
constexpr auto reply = "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex;

constexpr bool ends_by_rule()
{
    listener<direction::request> ear;
    bool const early = ear.hear(byte_view{request}.first(7)) == 7 and ear.fault() == errc::busy;
    return early and ear.hear(byte_view{request}.last(1)) == 1 and ear.has(request) and
           ear.fault() == errc::busy;
}
PROOF("a frame ends with the last octet of its length rule", ends_by_rule)

constexpr bool leaves_the_rest()
{
    listener<direction::response> ear;
    std::array<std::byte, reply.size() + 1> noisy{};
    byte_writer out{noisy};
    out.bytes(reply);
    bool const taken = ear.hear(noisy) == reply.size() and ear.has(reply);
    constexpr auto zero = "00"_hex;
    bool const noise = ear.hear(zero) == 1 and ear.fault() == errc::busy;
    ear.pause(line.t3_5());
    return taken and noise and ear.fault() == errc::frame_too_short;
}
PROOF("octets behind a frame are no part of it", leaves_the_rest)

// The one-register answer whose last octet is 00 passes the CRC without it too.
constexpr bool a_matching_crc_ends_nothing()
{
    constexpr auto frame = "01 04 02 03 01 78 00"_hex;
    listener<direction::response> ear;
    bool const waits = crc16(byte_view{frame}.first(6)) == 0 and
                       ear.hear(byte_view{frame}.first(6)) == 6 and ear.fault() == errc::busy;
    ear.hear(byte_view{frame}.last(1));
    return waits and ear.has(frame);
}
PROOF("a CRC that matches early ends nothing", a_matching_crc_ends_nothing)

constexpr bool damage_waits_for_silence()
{
    auto damaged = request;
    damaged[3] ^= std::byte{1};
    listener<direction::request> ear;
    ear.hear(damaged);
    bool const waits = ear.fault() == errc::busy;
    ear.hear(request);
    bool const still = ear.fault() == errc::busy;
    ear.pause(line.t3_5());
    bool const refused = ear.fault() == errc::crc_mismatch;
    ear.hear(request);
    return waits and still and refused and ear.has(request);
}
PROOF("after a wrong CRC only silence starts a new frame", damage_waits_for_silence)

constexpr bool longer_than_its_rule()
{
    // Function 06 with one octet too many: as a whole it has a right CRC, and the PDU refuses it.
    constexpr auto frame = "01 06 00 01 00 03 00 0A AA"_hex;
    listener<direction::request> ear;
    ear.hear(frame);
    bool const waits = crc16(frame) == 0 and ear.fault() == errc::busy;
    ear.pause(line.t3_5());
    return waits and ear.has(frame);
}
PROOF("a frame longer than its rule is whole when silence says so", longer_than_its_rule)

constexpr bool sizes_at_the_edge()
{
    std::array<std::byte, 257> octets{};
    octets[0] = std::byte{1};
    octets[1] = std::byte{0x41};
    std::uint16_t const crc = crc16(byte_view{octets}.first(254));
    octets[254] = to_byte(crc);
    octets[255] = to_byte(std::uint32_t{crc} >> 8U);
    listener<direction::request> ear;
    ear.hear(byte_view{octets}.first(256));
    ear.pause(line.t3_5());
    bool const longest = ear.has(byte_view{octets}.first(256));
    ear.hear(octets);
    ear.pause(line.t3_5());
    bool const too_long = ear.fault() == errc::frame_too_long;
    ear.hear("FF FF"_hex);
    ear.pause(line.t3_5());
    return longest and too_long and ear.fault() == errc::frame_too_short;
}
PROOF("256 octets are a frame, 257 and 2 are none", sizes_at_the_edge)

constexpr bool poison()
{
    listener<direction::request> ear;
    ear.hear(byte_view{request}.first(4));
    ear.receiver.receive_error(ear.now);
    ear.hear(byte_view{request}.subspan(4));
    bool const held = ear.fault() == errc::busy;
    ear.pause(line.t3_5());
    bool const refused = ear.fault() == errc::uart_error;
    ear.hear(request);
    return held and refused and ear.has(request);
}
PROOF("a damaged octet poisons its frame even if the CRC is right, and no other", poison)

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
constexpr bool octets_before_the_clock()
{
    framer<direction::request> receiver{line};
    return receiver.receive(request, start) == 8 and not receiver.poll_frame() and
           not receiver.is_quiet() and receiver.receive({}, start) == 0;
}
PROOF("octets before time is known are ignored too", octets_before_the_clock)
PROOF("at power-up everything is ignored until the line was silent", power_up)

constexpr bool a_lump_after_silence()
{
    listener<direction::request> ear;
    ear.hear(byte_view{request}.first(3));
    ear.now = ear.now + milliseconds(20);
    bool const closed = ear.hear(request) == 0 and ear.fault() == errc::frame_too_short;
    return closed and ear.receiver.receive(request, ear.now) == 8 and ear.has(request);
}
PROOF("a lump that comes after silence starts a new frame", a_lump_after_silence)

/// A lump of two octets `length` after the last octet of an unfinished frame.
constexpr bool starts_anew_after(duration length)
{
    listener<direction::request> ear;
    ear.hear(byte_view{request}.first(6));
    ear.now = ear.now + length;
    ear.receiver.receive(byte_view{request}.last(2), ear.now);
    return not ear.has(request);
}
constexpr bool the_edge_of_silence()
{
    return starts_anew_after(microseconds(2'006 + 2 * 573)) and
           not starts_anew_after(microseconds(2'006 + 2 * 573 - 1));
}
PROOF("a lump starts a new frame when its own time and t3.5 have passed", the_edge_of_silence)

constexpr auto asks_2 = "02 03 0C 81 00 01 D7 41"_hex;
constexpr auto writes_2 = "02 06 21 35 00 00 93 CB"_hex;

constexpr bool claims()
{
    listener<direction::response> ear;
    bool const nobody = not listener<direction::request>{}.receiver.is_overheard();
    ear.hear("02 03 00"_hex);
    ear.pause(milliseconds(10));
    bool const too_short = ear.fault() == errc::frame_too_short and not ear.receiver.claims(asks_2);
    ear.hear("02 03 00 00"_hex);
    bool const starts = not ear.receiver.is_at_start();
    ear.pause(milliseconds(10));
    return nobody and too_short and starts and ear.fault() == errc::crc_mismatch and
           ear.receiver.claims(asks_2) and not ear.receiver.claims(writes_2) and
           ear.receiver.is_at_start();
}
PROOF("what has a frame's size and begins like an answer claims to be one", claims)

constexpr bool host_gaps()
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    listener<direction::request> ear{host};
    ear.hear(byte_view{request}.first(3));
    ear.pause(milliseconds(45));
    ear.hear(byte_view{request}.subspan(3));
    bool const whole = ear.has(request);
    ear.hear(byte_view{request}.first(3));
    ear.pause(milliseconds(50));
    return whole and ear.fault() == errc::frame_too_short;
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
    return none_before_start and first_silence and none_when_quiet and end_of_fragment and
           not receiver.is_quiet();
}
PROOF("a framer wants to be woken only for silence", deadlines)

constexpr bool host_deadlines()
{
    auto const host = line_timing::host(19'200, character_format::even_8_1);
    listener<direction::request> ear{host};
    ear.hear(byte_view{request}.first(3));
    instant const last = ear.now;
    bool const to_send = ear.receiver.poll_deadline() == deadline{last + host.t3_5()};
    ear.pause(host.t3_5());
    return to_send and ear.receiver.is_quiet() and
           ear.receiver.poll_deadline() == deadline{last + host.frame_end()};
}
PROOF("on a host it is woken twice: when somebody may send, and when what it has is all",
      host_deadlines)

constexpr bool takes_all_of_a_lump()
{
    std::array<std::byte, 300> octets{};
    listener<direction::request> ear;
    return ear.hear(octets) == octets.size() and ear.fault() == errc::busy;
}
PROOF("octets that no frame has room for are taken all the same", takes_all_of_a_lump)

} // namespace

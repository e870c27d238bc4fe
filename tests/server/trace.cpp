// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a server's trace says of each kind of frame and of bytes that belong to none.
#include <rtuwire/server.hpp>
#include <rtuwire/trace.hpp>

#include <type_traits>

#include "support/kept_frames.hpp"
#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::is;
using test::kept_frames;
using role = frame_role;
using verdict = frame_verdict;

namespace {

constexpr auto read_1 = "01 03 00 00 00 01 84 0A"_hex;
constexpr auto answer_1 = "01 03 02 00 00 B8 44"_hex;
constexpr auto read_2 = "02 03 00 00 00 01 84 39"_hex;
constexpr auto answer_2 = "02 03 02 12 34 F1 33"_hex;

using traced_server = server::traced_by<kept_frames>;
template <typename Engine>
concept can_be_traced = requires(Engine& engine, kept_frames& frames)
{
    engine.trace_to(frames);
};

STATIC_CHECK(std::is_trivially_copyable_v<traced_server> == std::is_trivially_copyable_v<server>);
STATIC_CHECK(not can_be_traced<server>);
STATIC_CHECK(can_be_traced<counting_server::traced_by<kept_frames>>);

template <typename Server = traced_server> struct traced_node : test::server_on_a_line<Server> {
    kept_frames frames;

    constexpr traced_node() { this->node.trace_to(frames); }
    constexpr bool has(std::size_t index, byte_view bytes, frame_role what, verdict how, bool is_own = false) const
    {
        return frames.has(index, bytes, what, how, is_own);
    }
    constexpr void rest() { this->pass(milliseconds(10)); }
};

constexpr bool an_exchange()
{
    traced_node node;
    node.hear(read_1);
    instant const heard = node.now;
    node.rest();
    node.send();
    return is(node.has(0, read_1, role::request, verdict::good), "request") and
           is(node.frames.has_at(0, heard), "its end") and
           is(node.has(1, answer_1, role::response, verdict::good, true), "response") and
           is(node.frames.has_at(1, node.now), "when it had left") and node.frames.count() == 2;
}
PROOF("a traced server tells the request and its response", an_exchange)

constexpr bool between_others()
{
    traced_node node;
    node.hear(read_2);
    node.rest();
    node.hear(answer_2);
    node.rest();
    node.hear("02 83 02 30 F1"_hex);
    node.rest();
    return is(node.has(0, read_2, role::request, verdict::foreign), "request") and
           is(node.has(1, answer_2, role::response, verdict::foreign), "response") and
           is(node.has(2, "02 83 02 30 F1"_hex, role::response, verdict::foreign), "exception");
}
PROOF("requests to others and their responses are foreign", between_others)

constexpr bool a_broadcast()
{
    traced_node node;
    node.hear("00 06 00 00 00 05 48 18"_hex);
    node.rest();
    return node.has(0, "00 06 00 00 00 05 48 18"_hex, role::request, verdict::good) and node.frames.count() == 1;
}
PROOF("a broadcast is a good request", a_broadcast)

constexpr bool damage()
{
    traced_node node;
    node.hear("01 03 00 00 00 01 84 0B"_hex);
    instant const heard = node.now;
    node.rest();
    node.hear("01 03"_hex);
    node.node.receive_error(node.now);
    node.rest();
    return is(node.has(0, "01 03 00 00 00 01 84 0B"_hex, role::unknown, verdict::damaged), "CRC") and
           is(node.frames.has_at(0, heard), "its last byte") and
           is(node.has(1, "01 03"_hex, role::unknown, verdict::damaged), "a receive error");
}
PROOF("damaged frames are told as such, when silence ended them, with the time of their last byte", damage)

constexpr bool own_exception()
{
    traced_node node;
    node.hear("01 83 02 C0 F1"_hex);
    node.rest();
    return node.has(0, "01 83 02 C0 F1"_hex, role::response, verdict::stray);
}
PROOF("an exception response from its own address is stray", own_exception)

constexpr bool ignored_bytes()
{
    kept_frames frames;
    traced_server node{unit_id{1}, test::usual_line};
    node.trace_to(frames);
    node.advance(instant{0});
    node.receive("12 34"_hex, instant{500});
    node.receive(std::byte{0x56}, instant{1'000});
    return frames.has(0, "12 34"_hex, role::unknown, verdict::stray) and
           frames.has(1, "56"_hex, role::unknown, verdict::stray);
}
PROOF("bytes that are ignored until the line falls silent are stray", ignored_bytes)

constexpr bool while_sending()
{
    traced_node node;
    node.hear(read_1);
    node.rest();
    static_cast<void>(node.node.poll_transmit());
    node.receive("01 03"_hex);
    node.receive("02 FF"_hex);
    node.receive("00"_hex);
    node.node.sent(node.now);
    return is(node.has(1, "01 03"_hex, role::response, verdict::echo, true), "its echo") and
           is(node.has(2, "02 FF"_hex, role::unknown, verdict::stray), "others") and
           is(node.has(3, "00"_hex, role::unknown, verdict::stray), "and no echo behind them") and
           is(node.has(4, answer_1, role::response, verdict::good, true), "response");
}
PROOF("bytes while a response is sent are its echo or stray", while_sending)

constexpr bool never_sent()
{
    traced_node node;
    node.hear(read_1);
    node.rest();
    static_cast<void>(node.node.poll_transmit());
    node.pass(milliseconds(1'000));
    return node.frames.count() == 1;
}
PROOF("a response of which nobody knows whether it left is not told", never_sent)

/// Unit 2 is asked for a coil; what follows may be its response of 6 bytes or, with one byte 00 more, a request.
constexpr bool open_end()
{
    traced_node node;
    node.hear("02 03 00 00 00 01 84 39"_hex);
    node.rest();
    // 02 03, then bytes chosen so that the CRC is right after 7 = 5 + 2 bytes, by the response's rule.
    std::array<std::byte, 8> frame{std::byte{2}, std::byte{3}, std::byte{2}, std::byte{0}, std::byte{0}};
    std::uint16_t const crc = crc16(byte_view{frame.data(), 5});
    frame[5] = to_byte(crc & 0xFFU);
    frame[6] = to_byte(std::uint32_t{crc} >> 8U);
    node.hear(frame); // with the 00 behind it, 8 bytes: a request by its length
    node.rest();
    return node.has(1, frame, role::request, verdict::foreign) and node.frames.count() == 2;
}
PROOF("a request that ends one byte behind a response's size is told with that byte", open_end)

constexpr bool dropped_with_a_damaged_byte()
{
    traced_node node;
    node.receive("01 2B 0E 01"_hex);
    node.now = node.now + milliseconds(20);
    node.node.receive_error(node.now);
    return node.has(0, "01 2B 0E 01"_hex, role::unknown, verdict::damaged);
}
PROOF("a frame that silence ended, and a damaged byte discards, is told", dropped_with_a_damaged_byte)

constexpr bool without_a_sink()
{
    test::server_on_a_line<traced_server> node;
    node.hear(read_1);
    return node.says(answer_1);
}
PROOF("a traced server without a sink works as any", without_a_sink)

constexpr bool of_several_units()
{
    kept_frames frames;
    word_bank<4> a{}, b{};
    auto node = traced_server::for_units(test::usual_line, bank_at{unit_id{1}, a}, bank_at{unit_id{2}, b});
    node.trace_to(frames);
    node.advance(instant{0});
    node.advance(instant{100'000});
    node.receive(read_2, instant{200'000});
    return frames.has(0, read_2, role::request, verdict::good);
}
PROOF("a server of several units tells requests to each of them as good", of_several_units)

} // namespace

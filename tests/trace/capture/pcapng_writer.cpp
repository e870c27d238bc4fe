// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The bytes of a capture, as the drafts of pcapng have them. tests/wireshark shows what Wireshark says of them.
#include <rtuwire/trace/capture/pcapng_writer.hpp>

#include <array>
#include <string_view>
#include <vector>

#include <rtuwire/core/hex.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto request = "07 03 0C 82 00 01 27 0C"_hex;

constexpr bool is(byte_view made, byte_view expected) { return same_bytes(made, expected); }

/// The number at an offset, least significant byte first.
constexpr std::uint32_t number_at(byte_view bytes, std::size_t at)
{
    return to_u16(bytes[at + 1], bytes[at]) | std::uint32_t{to_u16(bytes[at + 3], bytes[at + 2])} << 16U;
}

constexpr bool a_file_begins_with_a_section_and_an_interface()
{
    pcapng_blocks blocks;
    return is(blocks.begin({.form = capture_form::user0, .interface_name = "COM3", .bits_per_second = 19'200},
                           {.unix_microseconds = 0, .at = instant{0}}),
              "0A0D0D0A 2C000000 4D3C2B1A 0100 0000 FFFFFFFFFFFFFFFF"
              "0400 0700 72747577697265 00 00000000 2C000000"
              "01000000 34000000 9300 0000 FFFF0000"
              "0200 0400 434F4D33"
              "0800 0800 004B000000000000"
              "0900 0100 06 000000"
              "00000000 34000000"_hex);
}
PROOF("A file begins with a section and an interface", a_file_begins_with_a_section_and_an_interface)

constexpr bool a_request_is_a_packet_to_its_unit()
{
    pcapng_blocks blocks;
    static_cast<void>(blocks.begin({}, {.unix_microseconds = 0x1'0000'0000, .at = instant{1}}));
    return is(blocks.packet({.bytes = request, .at = instant{3}, .role = frame_role::request, .is_own = true}),
              "06000000 50000000 00000000 01000000 02000000 24000000 24000000"
              "4500 0024 00000000 4011 65C5 0A0000FE 0A000007"
              "C350 05DE 0010 0000"
              "07030C820001270C"
              "0200 0400 02000000 00000000 50000000"_hex);
}
PROOF("A request is a packet to its unit, the client's port is 50000", a_request_is_a_packet_to_its_unit)

constexpr bool other_forms_say_the_role_in_words()
{
    pcapng_blocks blocks;
    static_cast<void>(blocks.begin({.form = capture_form::user0}, {.unix_microseconds = 5, .at = instant{0}}));
    auto const late = "07 03 02 01 F4 31 93"_hex;
    return is(
        blocks.packet({.bytes = late, .at = instant{0}, .role = frame_role::response, .verdict = frame_verdict::late}),
        "06000000 48000000 00000000 00000000 05000000 07000000 07000000"
        "07030201F43193 00"
        "0200 0400 01000000"
        "0100 0E00 726573706F6E73652C206C617465 0000 00000000 48000000"_hex);
}
PROOF("Forms without ports say the role in words", other_forms_say_the_role_in_words)

/// The sum of an IPv4 header is all ones, whatever is in it.
constexpr bool checksums_of_all_units_are_right()
{
    for (unsigned unit = 0; unit < 256; ++unit) {
        for (frame_role const role : {frame_role::request, frame_role::response, frame_role::unknown}) {
            std::array<std::byte, 256> bytes{to_byte(unit)};
            pcapng_blocks blocks;
            static_cast<void>(blocks.begin({}, {.at = instant{0}}));
            byte_view const frame = byte_view{bytes}.first(1 + unit % 255U);
            byte_view const packet = blocks.packet({.bytes = frame, .at = instant{0}, .role = role}).subspan(28);
            std::uint32_t sum = 0;
            for (std::size_t i = 0; i < 20; i += 2) {
                sum += u16_at(packet, i);
            }
            if ((sum & 0xFFFFU) + (sum >> 16U) != 0xFFFFU or u16_at(packet, 2) != 28 + frame.size()) {
                return false;
            }
        }
    }
    return true;
}
TEST_CASE("Checksums are right for all units and sizes") { CHECK(checksums_of_all_units_are_right()); }

constexpr bool time_goes_on_across_the_wrap()
{
    pcapng_blocks blocks;
    static_cast<void>(blocks.begin({}, {.unix_microseconds = 1'000, .at = instant{0xFFFF'FFFF}}));
    auto const time_of = [&](std::uint32_t at) {
        byte_view const block = blocks.packet({.bytes = request, .at = instant{at}});
        return std::uint64_t{number_at(block, 12)} << 32U | number_at(block, 16);
    };
    bool is_right = time_of(4) == 1'005;
    is_right = is_right and time_of(4U + 0x7FFF'FFFFU) == 1'005 + 0x7FFF'FFFFULL; // half a turn ahead
    is_right = is_right and time_of(4U + 0x7FFF'FFFEU) == 1'004 + 0x7FFF'FFFFULL; // a little older
    blocks.advance(instant{0xFFFF'0000U});
    blocks.advance(instant{0x7000'0000U});
    return is_right and time_of(0x7000'0001U) == 1'000ULL + 1 + 0x1'0000'0000ULL + 0x7000'0001ULL;
}
PROOF("32 bits of time become 64, over pauses of half a turn", time_goes_on_across_the_wrap)

constexpr bool a_long_piece_keeps_256_bytes()
{
    std::array<std::byte, 300> bytes{};
    pcapng_blocks blocks;
    static_cast<void>(blocks.begin({}, {.at = instant{0}}));
    byte_view const block = blocks.packet({.bytes = bytes, .at = instant{0}, .verdict = frame_verdict::damaged});
    return number_at(block, 20) == 28 + 256 and number_at(block, 24) == 28 + 300 and
           number_at(block, 4) == block.size() and number_at(block, block.size() - 4) == block.size();
}
PROOF("A piece above 256 bytes is cut, and the packet tells its size", a_long_piece_keeps_256_bytes)

/// With the longest name, comments and frame of every form, each block still ends with its length.
TEST_CASE("The largest blocks have room")
{
    std::string_view const name{"0123456789012345678901234567890123456789012345678901234567890123456789"};
    std::array<std::byte, 256> bytes{};
    for (auto const form :
         {capture_form::udp, capture_form::user0, capture_form::rtac_serial, capture_form::upper_pdu}) {
        pcapng_blocks blocks;
        byte_view const begin =
            blocks.begin({.form = form, .interface_name = name, .bits_per_second = 115'200}, {.at = instant{0}});
        std::uint32_t const section = number_at(begin, 4);
        CHECK(section + number_at(begin, section + 4) == begin.size());
        CHECK(number_at(begin, begin.size() - 4) == number_at(begin, section + 4));
        CHECK(number_at(begin, section + 16) == (std::uint32_t{63} << 16U | 2U));
        byte_view const packet = blocks.packet(
            {.bytes = bytes, .at = instant{0}, .role = frame_role::response, .verdict = frame_verdict::damaged});
        CHECK(number_at(packet, 4) == packet.size());
        CHECK(number_at(packet, packet.size() - 4) == packet.size());
    }
}

struct collector {
    std::vector<std::size_t>* sizes;
    void operator()(byte_view block) const noexcept { sizes->push_back(block.size()); }
};
static_assert(frame_sink<pcapng_writer<collector>>);

TEST_CASE("A writer is a sink that gives whole blocks, and none before it has begun")
{
    std::vector<std::size_t> sizes;
    pcapng_writer writer{collector{&sizes}};
    writer.take({.bytes = request, .at = instant{0}});
    CHECK(sizes.empty());
    writer.begin({.form = capture_form::user0}, {.at = instant{0}});
    writer.take({.bytes = request, .at = instant{0}});
    writer.advance(instant{5});
    CHECK(sizes == std::vector<std::size_t>{76, 52});
}

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Captures read back: what the writer writes, files as other programs write them, and wrong ones.
#include "../../tools/rtuwire/capture/capture_reader.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/trace.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace tool;

namespace {

using byte_list = std::vector<std::byte>;

void add(byte_list& to, byte_view bytes) { to.insert(to.end(), bytes.begin(), bytes.end()); }

struct read_frame {
    captured_frame captured;
    byte_list bytes;
};

struct read_file {
    std::vector<read_frame> frames;
    capture_error error;
    std::uint32_t skipped{0};
};

/// Reads a file in pieces of a size, each in memory of its own that ends with it.
read_file read(byte_view file, std::size_t step = 4096)
{
    capture_reader reader;
    read_file found;
    for (std::size_t at = 0; at < file.size(); at += step) {
        byte_view const rest = file.subspan(at);
        byte_list const piece(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>((std::min)(step, rest.size())));
        reader.receive(piece);
        while (auto const next = reader.next()) {
            found.frames.push_back({*next, {next->frame.bytes.begin(), next->frame.bytes.end()}});
        }
    }
    reader.finish();
    found.error = reader.error();
    found.skipped = reader.skipped();
    return found;
}

constexpr auto asked = "07 03 0C 82 00 01 27 0C"_hex;
constexpr capture_form forms[] = {capture_form::udp, capture_form::user0, capture_form::rtac_serial,
                                  capture_form::upper_pdu};

TEST_CASE("Every role, verdict, direction and size comes back, in every form and in any pieces")
{
    for (auto const form : forms) {
        std::vector<traced_frame> written;
        std::array<std::byte, 256> bytes{std::byte{7}, std::byte{3}};
        std::uint32_t at = 0xFFFF'FFF0U;
        pcapng_blocks blocks;
        byte_list file;
        add(file, blocks.begin({.form = form, .interface_name = "line", .bits_per_second = 19'200},
                               {.unix_microseconds = 1'700'000'000'000'000, .at = instant{at}}));
        for (unsigned role = 0; role < 3; ++role) {
            for (unsigned verdict = 0; verdict < 6; ++verdict) {
                for (bool const is_own : {false, true}) {
                    written.push_back({.bytes = byte_view{bytes}.first(written.size() * 7 + 1),
                                       .at = instant{++at},
                                       .role = static_cast<frame_role>(role),
                                       .verdict = static_cast<frame_verdict>(verdict),
                                       .is_own = is_own});
                    add(file, blocks.packet(written.back()));
                }
            }
        }
        for (std::size_t const step : {1U, 2U, 3U, 17U, 4096U}) {
            auto const found = read(file, step);
            CHECK(found.error == capture_error{});
            REQUIRE(found.frames.size() == written.size());
            for (std::size_t i = 0; i < written.size(); ++i) {
                auto const& [captured, kept] = found.frames[i];
                CHECK(same_bytes(kept, written[i].bytes));
                CHECK(captured.frame.role == written[i].role);
                CHECK(captured.frame.verdict == written[i].verdict);
                CHECK(captured.frame.is_own == written[i].is_own);
                CHECK(captured.full_size == written[i].bytes.size());
                CHECK(captured.unix_microseconds == 1'700'000'000'000'001 + i);
                CHECK(captured.frame.at == instant{static_cast<std::uint32_t>(captured.unix_microseconds)});
                CHECK(captured.bits_per_second == 19'200);
            }
        }
    }
}

TEST_CASE("A file ends well between blocks only")
{
    for (auto const form : forms) {
        pcapng_blocks blocks;
        byte_list file;
        add(file, blocks.begin({.form = form}, {.at = instant{0}}));
        std::size_t const section = to_u8(file[4]);
        std::size_t const head = file.size();
        add(file, blocks.packet({.bytes = asked, .at = instant{0}}));
        for (std::size_t size = 0; size <= file.size(); ++size) {
            auto const found = read(byte_view{file}.first(size));
            bool const is_whole = size == section or size == head or size == file.size();
            std::uint64_t const start = size < section ? 0 : size < head ? section : head;
            CHECK(found.error == (is_whole ? capture_error{} : capture_error{capture_errc::cut_short, start}));
            CHECK(found.frames.size() == (size == file.size() ? 1U : 0U));
        }
    }
}

// Files as other programs and other machines write them.

constexpr auto pcap_of_a_big_machine = "A1B2C3D4 0002 0004 00000000 00000000 0000FFFF 00000093"
                                       "0000000A 00000007 00000008 00000008 07030C820001270C"_hex;
constexpr auto pcap_in_nanoseconds = "4D3CB2A1 0200 0400 00000000 00000000 FFFF0000 93000000"
                                     "0A000000 581B0000 08000000 0A000000 07030C820001270C"_hex;
// Nanoseconds, a start in 1970 plus 2 s, an unknown block, an obsolete packet and a simple one.
constexpr auto pcapng_of_a_big_machine =
    "0A0D0D0A 0000001C 1A2B3C4D 0001 0000 FFFFFFFFFFFFFFFF 0000001C"
    "00000001 0000002C 0093 0000 00000008 0009 0001 09000000 000E 0008 0000000000000002 00000000 0000002C"
    "0BAD0000 00000010 12345678 00000010"
    "00000BAD 0000000C 0000000C"
    "00000002 00000028 0000 0000 00000000 00001B58 00000008 00000008 07030C820001270C 00000028"
    "00000003 00000018 0000000A 07030C820001270C 00000018"_hex;

TEST_CASE("Captures of both byte orders and resolutions are read, also those of old programs")
{
    for (std::size_t const step : {1U, 5U, 100U}) {
        auto const big = read(pcap_of_a_big_machine, step);
        REQUIRE((big.error == capture_error{} and big.frames.size() == 1));
        CHECK(same_bytes(big.frames[0].bytes, asked));
        CHECK(big.frames[0].captured.unix_microseconds == 10'000'007);
        CHECK(big.frames[0].captured.frame.role == frame_role::unknown);
        auto const fine = read(pcap_in_nanoseconds, step);
        REQUIRE((fine.error == capture_error{} and fine.frames.size() == 1));
        CHECK(fine.frames[0].captured.unix_microseconds == 10'000'007);
        CHECK(fine.frames[0].captured.full_size == 10); // of which 8 bytes were kept
        auto const section = read(pcapng_of_a_big_machine, step);
        REQUIRE((section.error == capture_error{} and section.frames.size() == 2));
        CHECK(section.frames[0].captured.unix_microseconds == 2'000'007);
        CHECK(section.frames[1].captured.unix_microseconds == 0);
        CHECK((section.frames[1].bytes.size() == 8 and section.frames[1].captured.full_size == 10));
    }
}

constexpr bool times_of_every_resolution()
{
    constexpr auto time = [](std::uint8_t resolution, std::uint64_t steps, std::uint64_t offset = 0) {
        return capture_interface{.resolution = resolution, .offset = offset}.microseconds_of(steps);
    };
    return time(0, 3) == 3'000'000 and time(3, 1'500) == 1'500'000 and time(6, 7) == 7 and time(9, 7'999) == 7 and
           time(19, 18'000'000'000'000'000'000U) == 1'800'000 and time(0x81, 3) == 1'500'000 and
           time(0x8A, 512) == 500'000 and time(0xA0, std::uint64_t{5} << 31U) == 2'500'000 and
           time(0xBF, std::uint64_t{3} << 62U) == 1'500'000 and time(6, 7, 2) == 2'000'007 and
           time(6, 1'000'007, ~std::uint64_t{0}) == 7;
}
PROOF("Times of every resolution become microseconds", times_of_every_resolution)

// What is wrong: the first bytes of each file are right.

constexpr auto section = "0A0D0D0A 1C000000 4D3C2B1A 0100 0000 FFFFFFFFFFFFFFFF 1C000000"_hex; // 28 bytes
constexpr auto user0_line = "01000000 14000000 9300 0000 00000000 14000000"_hex;               // 20 bytes
constexpr auto udp_line = "01000000 14000000 E400 0000 00000000 14000000"_hex;

byte_list behind(byte_view line, byte_view last)
{
    byte_list file;
    add(file, section);
    add(file, line);
    add(file, last);
    return file;
}

template <std::size_t Size>
void is_wrong(std::array<std::byte, Size> const& last, capture_errc why, byte_view line = user0_line)
{
    byte_list const file = behind(line, last);
    for (std::size_t const step : {1U, 7U, 4096U}) {
        auto const found = read(file, step);
        CHECK(found.error == capture_error{why, 48});
        CHECK(found.frames.empty());
    }
}

TEST_CASE("What is wrong in a file is told, with the offset of its block")
{
    CHECK(read("50 4B 03 04 00 00"_hex).error == capture_error{capture_errc::not_a_capture, 0});
    CHECK(read("0A0D0D0A 1C000000 4D3C2B1B"_hex).error == capture_error{capture_errc::not_a_capture, 0});
    CHECK(read("0A0D0D0A 1C000000 4D3C2B1A 0200 0000 FFFFFFFFFFFFFFFF 1C000000"_hex).error ==
          capture_error{capture_errc::unsupported_version, 0});
    CHECK(read("D4C3B2A1 0300 0400 00000000 00000000 FFFF0000 93000000"_hex).error ==
          capture_error{capture_errc::unsupported_version, 0});
    CHECK(
        read("D4C3B2A1 0200 0400 00000000 00000000 FFFF0000 93000000 00000000 00000000 F10F0000 F10F0000"_hex).error ==
        capture_error{capture_errc::block_too_long, 24});
    // Lengths: below 12, no multiple of four, another at the end, of a known and an unknown block.
    is_wrong("05000000 08000000 08000000"_hex, capture_errc::wrong_block_length);
    is_wrong("05000000 0D000000 0D000000 00"_hex, capture_errc::wrong_block_length);
    is_wrong("05000000 10000000 00000000 14000000"_hex, capture_errc::wrong_block_length);
    is_wrong("05000000 0C000000 10000000"_hex, capture_errc::wrong_block_length);
    is_wrong("03000000 10000000 00000000 14000000"_hex, capture_errc::wrong_block_length);
    // Too short for what every block of the type has.
    is_wrong("06000000 10000000 00000000 10000000"_hex, capture_errc::wrong_block_length);
    is_wrong("01000000 10000000 93000000 10000000"_hex, capture_errc::wrong_block_length);
    is_wrong("03000000 0C000000 0C000000"_hex, capture_errc::wrong_block_length);
    // A packet of more bytes than its block, and one whose length would wrap.
    is_wrong("06000000 24000000 00000000 00000000 00000000 05000000 05000000 07030C82 24000000"_hex,
             capture_errc::wrong_block_length);
    is_wrong("06000000 24000000 00000000 00000000 00000000 FFFFFFFF FFFFFFFF 07030C82 24000000"_hex,
             capture_errc::wrong_block_length);
    is_wrong("03000000 14000000 05000000 07030C82 14000000"_hex, capture_errc::wrong_block_length);
    is_wrong("06000000 04100000 00000000"_hex, capture_errc::block_too_long);
    is_wrong("06000000 20000000 01000000 00000000 00000000 00000000 00000000 20000000"_hex,
             capture_errc::no_such_interface);
    // Options: longer than the block, of a wrong size.
    is_wrong("06000000 28000000 00000000 00000000 00000000 00000000 00000000 0100 0500 61626364 28000000"_hex,
             capture_errc::wrong_option);
    is_wrong("06000000 28000000 00000000 00000000 00000000 00000000 00000000 0200 0300 00000000 28000000"_hex,
             capture_errc::wrong_option);
    is_wrong("01000000 1C000000 93000000 00000000 0900 0200 06060000 1C000000"_hex, capture_errc::wrong_option);
    is_wrong("01000000 1C000000 93000000 00000000 0800 0400 00000000 1C000000"_hex, capture_errc::wrong_option);
    is_wrong("01000000 1C000000 93000000 00000000 0900 0100 14000000 1C000000"_hex, capture_errc::wrong_resolution);
    is_wrong("01000000 1C000000 93000000 00000000 0900 0100 C0000000 1C000000"_hex, capture_errc::wrong_resolution);
    // Kept more than there was.
    is_wrong("06000000 24000000 00000000 00000000 00000000 04000000 03000000 07030C82 24000000"_hex,
             capture_errc::wrong_packet);
}

/// A packet of 28 bytes in a block.
byte_list packet_of(byte_view packet)
{
    byte_list block;
    std::uint32_t const length = 32 + 28;
    add(block, "06000000 3C000000 00000000 00000000 00000000 1C000000 1C000000"_hex);
    add(block, packet);
    add(block, "3C000000"_hex);
    CHECK(block.size() == length);
    return behind(udp_line, block);
}

TEST_CASE("Wrong headers of a packet are told, and packets that are no frame of Modbus are counted")
{
    auto const check = [](byte_view packet, capture_errc why, std::uint32_t skipped, std::size_t frames) {
        auto const found = read(packet_of(packet));
        CHECK(found.error.why == why);
        CHECK(found.skipped == skipped);
        CHECK(found.frames.size() == frames);
    };
    using enum capture_errc;
    // An empty frame; a header of 24 bytes; sizes that are too large or too small.
    check("4500001C 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, none, 0, 1);
    check("4600001C 00000000 4011 0000 0A0000FE 0A000007 00000000 C350 05DE"_hex, wrong_packet, 0, 0);
    check("4500001D 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, wrong_packet, 0, 0);
    check("45000013 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, wrong_packet, 0, 0);
    check("4400001C 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, wrong_packet, 0, 0);
    check("4500001C 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0009 0000"_hex, wrong_packet, 0, 0);
    check("4500001C 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0007 0000"_hex, wrong_packet, 0, 0);
    // IPv6, a fragment, TCP, other ports.
    check("6500001C 00000000 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, none, 1, 0);
    check("4500001C 00000001 4011 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, none, 1, 0);
    check("4500001C 00000000 4006 0000 0A0000FE 0A000007 C350 05DE 0008 0000"_hex, none, 1, 0);
    check("4500001C 00000000 4011 0000 0A0000FE 0A000007 C350 0035 0008 0000"_hex, none, 1, 0);
}

TEST_CASE("Interfaces of other kinds are left out, and too many are refused")
{
    byte_list file;
    add(file, section);
    add(file, "01000000 14000000 0100 0000 00000000 14000000"_hex); // Ethernet
    add(file, "06000000 20000000 00000000 00000000 00000000 00000000 00000000 20000000"_hex);
    CHECK(read(file).skipped == 1);
    CHECK(read(file).error == capture_error{});
    for (std::size_t i = 1; i < capture_reader::most_lines; ++i) {
        add(file, user0_line);
    }
    CHECK(read(file).error == capture_error{});
    add(file, section);
    add(file, user0_line); // a section has interfaces of its own
    CHECK(read(file).error == capture_error{});
    for (std::size_t i = 0; i < capture_reader::most_lines; ++i) {
        add(file, user0_line);
    }
    CHECK(read(file).error == capture_error{capture_errc::too_many_interfaces, file.size() - 20});
}

constexpr bool a_whole_capture_in_a_constant_expression()
{
    pcapng_blocks blocks;
    capture_reader reader;
    reader.receive(blocks.begin({}, {.at = instant{0}}));
    bool is_right = not reader.next();
    reader.receive(blocks.packet({.bytes = asked, .at = instant{9}, .role = frame_role::request}));
    auto const read = reader.next();
    is_right = is_right and read and same_bytes(read->frame.bytes, asked) and read->unix_microseconds == 9 and
               read->frame.role == frame_role::request and not reader.next();
    reader.finish();
    return is_right and reader.error() == capture_error{};
}
PROOF("A capture is written and read while the compiler runs", a_whole_capture_in_a_constant_expression)

} // namespace

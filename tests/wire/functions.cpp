// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long a frame is, from its first bytes.
#include <rtuwire/wire/functions.hpp>

#include <array>

#include "support/length.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::is_ended_by_silence;
using rtuwire::test::is_told;

namespace {

constexpr auto asks = direction::request;
constexpr auto answers = direction::response;

STATIC_CHECK(is_told(asks, "02 03 0C 1E 00 04 27 6C"_hex));
STATIC_CHECK(is_told(answers, "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex));
STATIC_CHECK(is_told(asks, "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(is_told(answers, "02 06 23 29 00 0D 92 70"_hex));
STATIC_CHECK(is_told(asks, "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex));
STATIC_CHECK(is_told(answers, "02 10 23 29 00 02 9B B7"_hex));
STATIC_CHECK(is_told(asks, "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex));
STATIC_CHECK(is_told(answers, "02 17 06 02 37 05 DC 00 00 00 6A"_hex));
STATIC_CHECK(is_told(asks, "02 2B 0E 01 00 34 77"_hex));
STATIC_CHECK(is_told(answers, "02 2B 0E 01 02 00 00 02 00 02 41 42 01 01 43 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 83 02 30 F1"_hex));
STATIC_CHECK(is_told(asks, "02 08 00 0B 00 00 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 18 00 06 00 02 01 B8 12 84 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 07 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 07 00 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 0B 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 0B 00 00 00 00 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 16 00 04 00 F2 00 25 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 18 00 04 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 0F 00 00 00 08 01 FF 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 14 01 00 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 14 02 01 06 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 15 03 06 00 04 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 15 03 06 00 04 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 01 00 13 00 25 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 01 05 CD 6B B2 0E 1B 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 02 00 C4 00 16 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 02 03 AC DB 35 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 04 00 08 00 01 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 04 02 00 0A 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 05 00 AC FF 00 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 05 00 AC FF 00 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 0C 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 0C 08 00 00 01 08 01 21 20 00 00 00"_hex));
STATIC_CHECK(is_told(asks, "02 11 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 11 02 42 FF 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 0F 00 13 00 0A 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 16 00 04 00 F2 00 25 00 00"_hex));
STATIC_CHECK(is_told(answers, "02 08 00 0B 00 2A 00 00"_hex));

// Where more can be said, and no later.
constexpr length_hint more_at(std::uint16_t size) { return {size, false}; }
STATIC_CHECK(frame_length(asks, "02"_hex) == more_at(2));
STATIC_CHECK(frame_length(asks, "02 08 00"_hex) == more_at(4));
STATIC_CHECK(frame_length(asks, "02 10 00"_hex) == more_at(7));
STATIC_CHECK(frame_length(answers, "02 18"_hex) == more_at(4));
STATIC_CHECK(frame_length(answers, "02 2B"_hex) == more_at(3));
STATIC_CHECK(frame_length(answers, "02 2B 0E"_hex) == more_at(8));
STATIC_CHECK(frame_length(answers, "02 2B 0E 01 01 00 00 01"_hex) == more_at(10));

// Only silence ends these.
constexpr length_hint silence{};
STATIC_CHECK(frame_length(asks, "02 08 00 00"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 41"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 83"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 2B 0D"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 00"_hex) == silence);
// More than a frame can hold: FC16 with 255 bytes of data, FC43 with objects past the end.
STATIC_CHECK(frame_length(asks, "02 10 00 00 00 7B FF"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 03 FC"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 18 FF FF"_hex) == silence);
STATIC_CHECK(is_ended_by_silence(asks, "02 08 00 00 A5 37 DA BE"_hex, 4));
STATIC_CHECK(is_ended_by_silence(asks, "02 2B 0D 00 00 00"_hex, 3));
// 255 objects that are announced and not there: more is asked for until the first of them says no.
STATIC_CHECK(is_ended_by_silence(answers, "02 2B 0E 01 01 00 00 FF 00 F8 41"_hex, 10));

constexpr bool knows_nineteen_functions()
{
    constexpr std::array<std::uint8_t, 19> known{1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 15, 16, 17, 20, 21, 22, 23, 24, 43};
    std::size_t at = 0;
    for (std::uint32_t code = 0; code <= 0xFF; ++code) {
        bool const is_known = at < known.size() and known[at] == code;
        at += is_known ? 1U : 0U;
        std::array<std::byte, 2> const head{std::byte{2}, to_byte(code)};
        length_hint const asked = frame_length(asks, head);
        length_hint const answered = frame_length(answers, head);
        bool const is_refusal = code >= 0x80;
        if ((asked != silence) != is_known or (answered != silence) != (is_known or is_refusal) or
            (is_refusal and answered != length_hint{5, true})) {
            return false;
        }
    }
    return at == known.size();
}
PROOF("nineteen functions have a length rule, a refusal has five bytes, all else ends by silence",
      knows_nineteen_functions)

/// Where a frame's size stands, by the clause of the specification that gives the frame: its size where that is fixed,
/// else the byte that counts and the size without what it counts.
struct size_rule {
    std::uint8_t code;
    std::size_t fixed;
    std::size_t at{0};
    std::size_t base{0};
};
constexpr std::size_t counted = 0;
constexpr std::array<size_rule, 16> request_sizes{{{1, 8},
                                                   {2, 8},
                                                   {3, 8},
                                                   {4, 8},
                                                   {5, 8},
                                                   {6, 8},
                                                   {7, 4},
                                                   {11, 4},
                                                   {12, 4},
                                                   {15, counted, 6, 9},
                                                   {16, counted, 6, 9},
                                                   {17, 4},
                                                   {20, counted, 2, 5},
                                                   {21, counted, 2, 5},
                                                   {22, 10},
                                                   {23, counted, 10, 13}}};
constexpr std::array<size_rule, 16> response_sizes{{{1, counted, 2, 5},
                                                    {2, counted, 2, 5},
                                                    {3, counted, 2, 5},
                                                    {4, counted, 2, 5},
                                                    {5, 8},
                                                    {6, 8},
                                                    {7, 5},
                                                    {11, 8},
                                                    {12, counted, 2, 5},
                                                    {15, 8},
                                                    {16, 8},
                                                    {17, counted, 2, 5},
                                                    {20, counted, 2, 5},
                                                    {21, counted, 2, 5},
                                                    {22, 10},
                                                    {23, counted, 2, 5}}};

/// Whether a rule holds at every number of bytes that have arrived and every byte count.
constexpr bool is_obeyed(direction way, size_rule const& rule)
{
    for (std::uint32_t count = 0; count <= 0xFF; ++count) {
        test::exact_bytes head{12, std::byte{0x33}};
        head.span()[1] = to_byte(rule.code);
        bool const is_fixed = rule.fixed != counted;
        if (not is_fixed) {
            head.span()[rule.at] = to_byte(count);
        }
        std::size_t const size = is_fixed ? rule.fixed : rule.base + count;
        length_hint const told = size > 256 ? silence : length_hint{size, true};
        for (std::size_t there = 2; there <= head.view().size(); ++there) {
            bool const is_known = is_fixed or there > rule.at;
            if (frame_length(way, head.view().first(there)) != (is_known ? told : length_hint{rule.at + 1, false})) {
                return false;
            }
        }
        if (is_fixed) {
            return true;
        }
    }
    return true;
}

} // namespace

TEST_CASE("every function's frames have the size that the specification gives them, up to 256 bytes")
{
    for (size_rule const& rule : request_sizes) {
        CAPTURE(unsigned{rule.code});
        CHECK(is_obeyed(asks, rule));
    }
    for (size_rule const& rule : response_sizes) {
        CAPTURE(unsigned{rule.code});
        CHECK(is_obeyed(answers, rule));
    }
}

TEST_CASE("the size of a queue's response stands in two bytes")
{
    unsigned wrong = 0;
    for (std::uint32_t count = 0; count <= 0xFFFF; ++count) {
        std::array<std::byte, 4> const head{std::byte{2}, std::byte{24}, to_byte(count >> 8U), to_byte(count)};
        auto const size = static_cast<std::size_t>(6 + count);
        wrong += frame_length(answers, head) == (count > 250 ? silence : length_hint{size, true}) ? 0U : 1U;
    }
    CHECK(wrong == 0);
    CHECK(frame_length(asks, "02 18"_hex) == length_hint{6, true});
}

TEST_CASE("whatever the bytes say, a final size is one that a frame can have")
{
    test::random random{7};
    std::array<std::byte, 256> bytes{};
    unsigned wrong = 0;
    for (unsigned round = 0; round < 20'000; ++round) {
        random.fill(bytes);
        test::exact_bytes const exact{byte_view{bytes}.first(random.below(257))};
        byte_view const part = exact.view();
        for (direction const way : {asks, answers}) {
            length_hint const known = frame_length(way, part);
            if (known.is_final() and (known.size() < 4 or known.size() > 256)) {
                ++wrong;
            }
            if (not known.is_final() and known.size() != 0 and known.size() <= part.size()) {
                ++wrong;
            }
        }
    }
    CHECK(wrong == 0);
}

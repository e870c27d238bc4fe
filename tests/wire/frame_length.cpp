// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long a frame is, from its first octets.
#include <rtuwire/wire/frame_length.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

/// Whether each prefix either asks for more than it has or, at the end only, says the size; and no
/// prefix is left waiting for fewer octets than it has.
constexpr bool is_told(direction way, byte_view frame)
{
    std::size_t look_at = 2;
    for (std::size_t size = 0; size <= frame.size(); ++size) {
        length_so_far const known = frame_length(way, frame.first(size));
        if (known.is_final and known.size != frame.size()) {
            return false;
        }
        if (not known.is_final and known.size <= size) {
            return false;
        }
        if (size == look_at) {
            look_at = known.size;
        }
    }
    return look_at == frame.size();
}

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

// Only silence ends these.
constexpr length_so_far silence{};
STATIC_CHECK(frame_length(asks, "02 08 00 00"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 41"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 83"_hex) == silence);
STATIC_CHECK(frame_length(asks, "02 2B 0D"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 00"_hex) == silence);
// More than a frame can hold: FC16 with 255 octets of data, FC43 with objects past the end.
STATIC_CHECK(frame_length(asks, "02 10 00 00 00 7B FF"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 03 FC"_hex) == silence);
STATIC_CHECK(frame_length(answers, "02 18 FF FF"_hex) == silence);

} // namespace

TEST_CASE("whatever the octets say, a final size is one that a frame can have")
{
    test::random random{7};
    std::array<std::byte, 256> octets{};
    unsigned wrong = 0;
    for (unsigned round = 0; round < 20'000; ++round) {
        random.fill(octets);
        auto const part = byte_view{octets}.first(random.below(257));
        for (direction const way : {asks, answers}) {
            length_so_far const known = frame_length(way, part);
            if (known.is_final and (known.size < 4 or known.size > 256)) {
                ++wrong;
            }
            if (not known.is_final and known.size != 0 and known.size <= part.size()) {
                ++wrong;
            }
        }
    }
    CHECK(wrong == 0);
}

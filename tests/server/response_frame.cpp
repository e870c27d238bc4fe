// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A frame in, a frame out, in one place.
#include <rtuwire/server/respond.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr unit_id one{1};
constexpr device_object objects[] = {{vendor_name, "rtuwire"}};
constexpr server_profile profile{.identity = identity_of<objects>};

/// A server of three registers, 5555 in each, and what it answered last.
struct small {
    word_bank<3> bank{};
    std::array<std::byte, max_adu_size> place{};

    constexpr small()
    {
        for (std::uint16_t at = 0; at < 3; ++at) {
            static_cast<void>(bank.set(at, 0x5555));
        }
    }
    template <std::size_t Size> constexpr byte_view ask(std::array<std::byte, Size> const& frame)
    {
        for (std::size_t i = 0; i < Size; ++i) {
            place[i] = frame[i];
        }
        no_diagnostics none;
        return response_frame(place, Size, one, bank, profile, none);
    }
};

template <std::size_t Size, std::size_t AnswerSize>
constexpr bool answers(std::array<std::byte, Size> const& request, std::array<std::byte, AnswerSize> const& response)
{
    small unit;
    return same_bytes(unit.ask(request), response);
}
template <std::size_t Size> constexpr bool is_silent(std::array<std::byte, Size> const& request)
{
    small unit;
    return unit.ask(request).empty() and unit.bank.get(1) == 0x5555;
}

STATIC_CHECK(answers("01 03 00 00 00 02 C4 0B"_hex, "01 03 04 55 55 55 55 04 80"_hex));
STATIC_CHECK(answers("01 03 00 02 00 02 65 CB"_hex, "01 83 02 C0 F1"_hex));
STATIC_CHECK(answers("01 06 00 01 00 05 18 09"_hex, "01 06 00 01 00 05 18 09"_hex));
STATIC_CHECK(answers("01 08 00 00 A5 37 DA 8D"_hex, "01 88 01 87 C0"_hex));
STATIC_CHECK(answers("01 2B 0E 04 00 73 27"_hex, "01 2B 0E 04 81 00 00 01 00 07 72 74 75 77 69 72 65 E3 F7"_hex));

STATIC_CHECK(is_silent("02 03 00 00 00 02 C4 38"_hex)); // another unit
STATIC_CHECK(is_silent("01 06 00 01 00 05 18 0A"_hex)); // damaged
STATIC_CHECK(is_silent("01 06 00"_hex));
STATIC_CHECK(is_silent("00 03 00 00 00 02 C5 DA"_hex)); // a request to everyone

constexpr bool obeys_everyone_in_silence()
{
    small unit;
    return unit.ask("00 06 00 01 12 34 D4 AC"_hex).empty() and unit.bank.get(1) == 0x1234;
}
PROOF("a broadcast is obeyed and not answered", obeys_everyone_in_silence)

constexpr bool listens_only()
{
    small unit;
    serial_diagnostics counts;
    auto const ask = [&](auto const& frame) {
        for (std::size_t i = 0; i < frame.size(); ++i) {
            unit.place[i] = frame[i];
        }
        return response_frame(unit.place, frame.size(), one, unit.bank, profile, counts);
    };
    return ask("01 08 00 04 00 00 A1 CA"_hex).empty() and counts.is_listen_only();
}
PROOF("what wants no response gets none", listens_only)

} // namespace

TEST_CASE("whatever it is asked, its response is a frame of its unit, or nothing")
{
    test::random random{31};
    small unit;
    std::array<std::byte, max_adu_size> request{};
    unsigned answers = 0;
    for (unsigned round = 0; round < 20'000; ++round) {
        std::size_t const pdu_size = 1 + random.below(40);
        random.fill(byte_span{request}.first(1 + pdu_size));
        request[0] = static_cast<std::byte>(random.below(3));
        request[1] = static_cast<std::byte>(random.below(50));
        byte_view const frame = append_crc(request, pdu_size);
        for (std::size_t i = 0; i < frame.size(); ++i) {
            unit.place[i] = frame[i];
        }
        serial_diagnostics counts;
        byte_view const response = response_frame(unit.place, frame.size(), one, unit.bank, profile, counts);
        if (response.empty()) {
            continue;
        }
        ++answers;
        auto const read = decode_adu(response);
        REQUIRE(read);
        REQUIRE(request[0] == std::byte{1});
        REQUIRE(read->unit() == 1);
        REQUIRE((read->wire_code() & 0x7FU) == to_u8(request[1]));
    }
    CHECK(answers > 1'000);
}

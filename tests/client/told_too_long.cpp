// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A response that silence cut, and whose CRC is right there by chance: whatever size its own bytes tell, it is no
// answer. Asked with functions that only the length rule knows.
#include "support/manual_unit.hpp"

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/wire/raw.hpp>

namespace {

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

/// What a request gets whose response is these bytes and their CRC, and then silence.
template <std::size_t N> errc outcome_of(std::uint8_t function, std::array<std::byte, N> bytes)
{
    auto const crc = crc16(byte_view{bytes}.first(N - 2));
    bytes[N - 2] = std::byte(crc & 0xFFU);
    bytes[N - 1] = std::byte(crc >> 8U);
    constexpr auto data = "00 00 00 01"_hex;
    manual_unit unit{{.retries = 0}};
    single_request ask{unit_id{1}, raw_pdu{static_cast<function_code>(function), data}};
    unit.run(ask, milliseconds(1));
    unit.say(bytes);
    unit.run(ask, milliseconds(5'000));
    return ask.settled() ? ask.outcome().error() : errc::busy;
}

} // namespace

TEST_CASE("a raw request takes no response that silence cut", "[client]")
{
    using frame = std::array<std::byte, 8>;
    auto const counted = [](unsigned count) {
        return outcome_of(
            17, frame{std::byte{1}, std::byte{17}, std::byte(count), std::byte{1}, std::byte{2}, std::byte{3}});
    };
    CHECK(counted(3) == errc::none);
    // 251 bytes of data are the most a frame has room for; 252 to 255 are more than any frame can hold.
    for (unsigned const count : {0U, 2U, 4U, 7U, 251U, 252U, 253U, 254U, 255U}) {
        INFO("byte count " << count);
        CHECK(counted(count) == errc::wrong_length);
    }
}

TEST_CASE("a raw request takes no queue that silence cut", "[client]")
{
    using frame = std::array<std::byte, 10>;
    auto const counted = [](unsigned count) {
        // A queue of one register, which takes four bytes with its count.
        return outcome_of(24, frame{std::byte{1}, std::byte{24}, std::byte(count >> 8U), std::byte(count & 0xFFU),
                                    std::byte{0}, std::byte{1}});
    };
    CHECK(counted(4) == errc::none);
    for (unsigned const count : {2U, 6U, 250U, 251U, 252U, 0xFFFFU}) {
        INFO("byte count " << count);
        CHECK(counted(count) == errc::wrong_length);
    }
}

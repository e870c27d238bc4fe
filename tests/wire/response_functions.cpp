// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A response is held against the whole request: the functions beside those of registers.
#include <rtuwire/wire/response.hpp>

#include "support/proof.hpp"
#include "support/verdict.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::verdict;

namespace {

// The last two bytes of each request stand for its CRC.
constexpr auto coils = "02 01 00 13 00 13 00 00"_hex;
constexpr auto inputs = "02 02 00 C4 00 16 00 00"_hex;
constexpr auto registers = "02 04 00 08 00 01 00 00"_hex;
constexpr auto coil = "02 05 00 AC FF 00 00 00"_hex;
constexpr auto status = "02 07 00 00"_hex;
constexpr auto counter = "02 0B 00 00"_hex;
constexpr auto log = "02 0C 00 00"_hex;
constexpr auto block = "02 0F 00 13 00 0A 02 CD 01 00 00"_hex;
constexpr auto id = "02 11 00 00"_hex;
constexpr auto records = "02 14 07 06 00 04 00 01 00 02 00 00"_hex;
constexpr auto file = "02 15 09 06 00 04 00 07 00 01 06 AF 00 00"_hex;
constexpr auto mask = "02 16 00 04 00 F2 00 25 00 00"_hex;
constexpr auto queue = "02 18 04 DE 00 00"_hex;

/// Whether this is a response to that request, and to none else: neither from another unit, nor of another function,
/// nor a byte shorter or longer where the request tells the size; and an exception is one.
template <std::size_t Asked, std::size_t Told>
constexpr bool answers(std::array<std::byte, Asked> const& asked, std::array<std::byte, Told> const& told)
{
    auto other = told;
    other[0] = other[0] ^ std::byte{0x40};
    std::array<std::byte, 2> const refusal{told[0] | std::byte{0x80}, std::byte{2}};
    using test::is;
    return is(verdict(asked, told) == errc::none, "the response") and
           is(verdict(asked, told, 3) == errc::wrong_unit, "another unit") and
           is(verdict(asked, other) == errc::wrong_function, "another function") and
           is(verdict(asked, refusal) == errc::illegal_data_address, "an exception") and
           is(verdict(asked, byte_view{refusal}.first(1)) == errc::wrong_length, "an exception without a code");
}
STATIC_CHECK(answers(coils, "01 03 CD 6B 05"_hex));
STATIC_CHECK(answers(inputs, "02 03 AC DB 35"_hex));
STATIC_CHECK(answers(registers, "04 02 00 0A"_hex));
STATIC_CHECK(answers(coil, "05 00 AC FF 00"_hex));
STATIC_CHECK(answers(status, "07 6D"_hex));
STATIC_CHECK(answers(counter, "0B FF FF 01 08"_hex));
STATIC_CHECK(answers(log, "0C 08 00 00 01 08 01 21 20 00"_hex));
STATIC_CHECK(answers(block, "0F 00 13 00 0A"_hex));
STATIC_CHECK(answers(id, "11 03 12 FF 34"_hex));
STATIC_CHECK(answers(records, "14 06 05 06 0D FE 00 20"_hex));
STATIC_CHECK(answers(file, "15 09 06 00 04 00 07 00 01 06 AF"_hex));
STATIC_CHECK(answers(mask, "16 00 04 00 F2 00 25"_hex));
STATIC_CHECK(answers(queue, "18 00 06 00 02 01 B8 12 84"_hex));

// Late responses to another quantity: bits count in whole bytes.
STATIC_CHECK(verdict(coils, "01 02 CD 6B"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(coils, "01 04 CD 6B 05 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(coils, "01 03 CD 6B"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(coils, "01 02 CD 6B 05"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(inputs, "02 02 AC DB"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(inputs, "02 04 AC DB 35 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(registers, "04 04 00 0A 00 0B"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(registers, "04 02 00 0A 00"_hex) == errc::wrong_length);

// Writes are repeated.
STATIC_CHECK(verdict(coil, "05 00 AC 00 00"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(coil, "05 00 AD FF 00"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(coil, "05 00 AC FF"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(block, "0F 00 13 00 09"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(block, "0F 00 14 00 0A"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(block, "0F 00 13 00 0A 02"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(file, "15 09 06 00 04 00 07 00 01 06 AE"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(file, "15 09 06 00 04 00 08 00 01 06 AF"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(file, "15 0B 06 00 04 00 07 00 02 06 AF 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(mask, "16 00 04 00 F2 00 24"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(mask, "16 00 05 00 F2 00 25"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(mask, "16 00 04 00 F3 00 25"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(mask, "16 00 04 00 F2 00"_hex) == errc::wrong_length);

// What comes back is told from a response wherever the two can differ.
STATIC_CHECK(verdict(coils, "01 00 13 00 13"_hex) == errc::line_echo);
STATIC_CHECK(verdict(inputs, "02 00 C4 00 16"_hex) == errc::line_echo);
STATIC_CHECK(verdict(registers, "04 00 08 00 01"_hex) == errc::line_echo);
STATIC_CHECK(verdict(block, "0F 00 13 00 0A 02 CD 01"_hex) == errc::line_echo);
STATIC_CHECK(verdict(status, "07"_hex) == errc::line_echo);
STATIC_CHECK(verdict(counter, "0B"_hex) == errc::line_echo);
STATIC_CHECK(verdict(log, "0C"_hex) == errc::line_echo);
STATIC_CHECK(verdict(id, "11"_hex) == errc::line_echo);
STATIC_CHECK(verdict(records, "14 07 06 00 04 00 01 00 02"_hex) == errc::line_echo);
STATIC_CHECK(verdict(queue, "18 04 DE"_hex) == errc::line_echo);

// The response of a function that nobody knows may be its request, whether its code is among the public ones or not.
STATIC_CHECK(verdict("02 0A 12 34 00 00"_hex, "0A 12 34"_hex) == errc::none);
STATIC_CHECK(verdict("02 41 12 34 00 00"_hex, "41 12 34"_hex) == errc::none);

// A request for 17 bits from 0300 on begins as its own response of three bytes would.
constexpr auto alike = "02 01 03 00 00 11 00 00"_hex;
STATIC_CHECK(verdict(alike, "01 03 00 00 11"_hex) == errc::line_echo);
STATIC_CHECK(verdict(alike, "01 03 00 00 10"_hex) == errc::none);

// How much room a response needs, and whether its bytes tell its end.
STATIC_CHECK(longest_response(coils) == length_hint{8, true} and longest_response(inputs) == length_hint{8, true});
STATIC_CHECK(longest_response(registers) == length_hint{7, true} and longest_response(coil) == length_hint{8, true});
STATIC_CHECK(longest_response(status) == length_hint{5, true} and longest_response(counter) == length_hint{8, true});
STATIC_CHECK(longest_response(log) == length_hint{256, true} and longest_response(id) == length_hint{256, true});
STATIC_CHECK(longest_response(block) == length_hint{8, true} and longest_response(mask) == length_hint{10, true});
STATIC_CHECK(longest_response(records) == length_hint{11, true} and longest_response(file) == length_hint{14, true});
constexpr auto most_records = "02 14 07 06 00 04 00 01 00 79 00 00"_hex;
constexpr auto too_many_records = "02 14 07 06 00 04 00 01 00 7A 00 00"_hex;
constexpr auto two_runs = "02 14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02 00 00"_hex;
STATIC_CHECK(response_size(most_records) == 249 and response_size(too_many_records) == 256);
STATIC_CHECK(longest_response(two_runs) == length_hint{256, true});
STATIC_CHECK(longest_response(queue) == length_hint{256, true});
constexpr auto all_coils = "02 01 00 00 07 D0 00 00"_hex;
constexpr auto too_many_coils = "02 01 00 00 07 D9 00 00"_hex;
STATIC_CHECK(response_size(all_coils) == 255 and response_size(too_many_coils) == 256);

/// Every quantity of bits: its byte count is accepted, and no other.
constexpr bool compares_byte_counts()
{
    constexpr std::array<unsigned, 8> quantities{1, 7, 8, 9, 1023, 1024, 1993, 2000};
    for (unsigned const quantity : quantities) {
        auto request = all_coils;
        request[4] = to_byte(quantity >> 8U);
        request[5] = to_byte(quantity);
        for (unsigned bytes = 0; bytes <= 251; ++bytes) {
            std::array<std::byte, 253> told{std::byte{1}, to_byte(bytes)};
            errc const expected = bytes == (quantity + 7) / 8 ? errc::none : errc::wrong_length;
            if (verdict(request, byte_view{told}.first(2 + bytes)) != expected) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

TEST_CASE("a response of bits has a byte for each eight that were asked") { CHECK(compares_byte_counts()); }

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An answer is held against the whole question.
#include <rtuwire/wire/answer.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

template <std::size_t Size, std::size_t AnswerSize>
constexpr errc verdict(std::array<std::byte, Size> const& question,
                       std::array<std::byte, AnswerSize> const& answer_pdu, std::uint8_t unit = 2)
{
    return check_answer(question, adu{unit, answer_pdu});
}

constexpr auto read = "02 03 0C 81 00 01 D7 41"_hex;
STATIC_CHECK(verdict(read, "03 02 12 34"_hex) == errc::none);
STATIC_CHECK(verdict(read, "03 02 12 34"_hex, 3) == errc::wrong_unit);
STATIC_CHECK(verdict(read, "03 04 12 34 56 78"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "03 02 12"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "03"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "04 02 12 34"_hex) == errc::wrong_function);
STATIC_CHECK(verdict(read, "83 02"_hex) == errc::illegal_data_address);
STATIC_CHECK(verdict(read, "83 7F"_hex) == static_cast<errc>(0x7F));
STATIC_CHECK(verdict(read, "83 00"_hex) == errc::unlisted_exception);
STATIC_CHECK(verdict(read, "83"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "86 02"_hex) == errc::wrong_function);

constexpr auto write = "02 06 21 35 00 0F D3 CF"_hex;
STATIC_CHECK(verdict(write, "06 21 35 00 0F"_hex) == errc::none);
STATIC_CHECK(verdict(write, "06 21 35 00 0E"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(write, "06 21 36 00 0F"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(write, "06 21 35 00"_hex) == errc::wrong_length);

constexpr auto block = "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex;
STATIC_CHECK(verdict(block, "10 23 29 00 02"_hex) == errc::none);
STATIC_CHECK(verdict(block, "10 23 29 00 01"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(block, "10 23 28 00 02"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(block, "10 23 29 00 02 04"_hex) == errc::wrong_length);

constexpr auto exchange = "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex;
STATIC_CHECK(verdict(exchange, "17 06 02 37 05 DC 00 00"_hex) == errc::none);
STATIC_CHECK(verdict(exchange, "17 04 02 37 05 DC"_hex) == errc::wrong_length);

constexpr auto loop = "02 08 00 00 A5 37 DA BE"_hex;
STATIC_CHECK(verdict(loop, "08 00 00 A5 37"_hex) == errc::none);
STATIC_CHECK(verdict(loop, "08 00 00 A5 36"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(loop, "08 00 0B A5 37"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(loop, "08 00 00"_hex) == errc::wrong_length);
constexpr auto count = "02 08 00 0B 00 00 00 00"_hex;
STATIC_CHECK(verdict(count, "08 00 0B 12 34"_hex) == errc::none);

constexpr auto identify = "02 2B 0E 01 00 34 77"_hex;
STATIC_CHECK(verdict(identify, "2B 0E 01 01 00 00 01 00 01 41"_hex) == errc::none);
STATIC_CHECK(verdict(identify, "2B 0E 02 01 00 00 01 00 01 41"_hex) == errc::wrong_echo);
STATIC_CHECK(verdict(identify, "2B 0E 01 01 00 00 02 00 01 41"_hex) == errc::malformed);

// A raw question may be shorter than its function allows.
STATIC_CHECK(verdict("02 03 00 00"_hex, "03 02 12 34"_hex) == errc::none);
STATIC_CHECK(verdict("02 2B 00 00"_hex, "2B 01"_hex) == errc::none);
STATIC_CHECK(verdict("02 03 00 00 00 00 00"_hex, "03 00"_hex) == errc::none);

STATIC_CHECK(answer_size(read) == 7 and answer_size(write) == 8 and answer_size(block) == 8);
STATIC_CHECK(answer_size(exchange) == 11 and answer_size(loop) == 8);
STATIC_CHECK(answer_size(identify) == 256);
STATIC_CHECK(answer_size("02 03 00 00"_hex) == 256);
STATIC_CHECK(answer_size("02 03 00 00 FF FF 00 00"_hex) == 256);

} // namespace

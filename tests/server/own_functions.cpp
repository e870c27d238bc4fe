// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A function of the bank's own: it answers, refuses, or leaves it to the server; and a client asks for it.
#include <rtuwire/server/server.hpp>

#include <algorithm>
#include <optional>

#include "support/catch.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/sim/bench.hpp>
#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Function 41 (hexadecimal) adds two bytes.
struct adding_bank : word_bank<4> {
    static constexpr std::optional<errc> respond(function_code function, pdu_buffer& pdu)
    {
        if (function != static_cast<function_code>(0x41)) {
            return std::nullopt;
        }
        if (pdu.size != 3) {
            return errc::illegal_data_value;
        }
        pdu.bytes[1] = to_byte(std::uint32_t{to_u8(pdu.bytes[1])} + to_u8(pdu.bytes[2]));
        pdu.size = 2;
        return errc::none;
    }
};

/// Its request and its response, of the same kind as those of the public functions.
struct sum_of_two {
    static constexpr std::size_t max_size = 2;
    std::uint8_t sum;

    [[nodiscard]] static constexpr result<sum_of_two> decode(byte_view pdu)
    {
        return pdu.size() == max_size ? result<sum_of_two>{sum_of_two{to_u8(pdu[1])}} : errc::wrong_length;
    }
};
struct add_two {
    using response = sum_of_two;
    static constexpr std::size_t max_size = 3;
    std::uint8_t left;
    std::uint8_t right;

    [[nodiscard]] constexpr errc check() const { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const { return max_size; }
    constexpr void write(byte_writer& out) const
    {
        out.u8(0x41);
        out.u8(left);
        out.u8(right);
    }
};

/// Answers whatever it is asked with one byte, and counts.
struct eager_bank : word_bank<4> {
    int asked{0};

    std::optional<errc> respond(function_code, pdu_buffer& pdu)
    {
        ++asked;
        pdu.bytes[1] = std::byte{0xEE};
        pdu.size = 2;
        return errc::none;
    }
};

constexpr line_timing timing{19'200, character_format::even_8_1};

template <std::size_t Size> unsigned exception_to(std::array<std::byte, Size> const& asked)
{
    adding_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    byte_view const told = respond(asked, bank, server_profile{}, place);
    return told.size() == 2 and to_u8(told[0]) >= 0x80 ? to_u8(told[1]) : 0U;
}

} // namespace

TEST_CASE("a client asks for a function of the bank's own, as bytes and by a type")
{
    adding_bank bank;
    static_cast<void>(bank.set(2, 7));
    sim::bench bench{timing, bank_at{unit_id{3}, bank}};
    constexpr auto operands = "12 34"_hex;
    single_request raw{unit_id{3}, raw_pdu{static_cast<function_code>(0x41), operands}};
    auto const told = bench.run(raw);
    REQUIRE(told);
    CHECK(same_bytes(told->pdu(), "41 46"_hex));

    single_request typed{unit_id{3}, add_two{3, 4}};
    auto const sum = bench.run(typed)->to<add_two>();
    REQUIRE(sum);
    CHECK(sum->sum == 7);

    single_request read{unit_id{3}, read_holding_registers{2, 1}};
    CHECK(bench.run(read)->to<read_holding_registers>()->registers[0] == 7);
}

TEST_CASE("what the bank refuses or does not know is an exception")
{
    CHECK(exception_to("41 12 34"_hex) == 0);
    CHECK(exception_to("41 12"_hex) == 3);
    CHECK(exception_to("42 12 34"_hex) == 1);
    CHECK(exception_to("01 00 00 00 01"_hex) == 1);
    CHECK(exception_to("03 00 00 00 01"_hex) == 0);
}

TEST_CASE("a bank is asked for what the server has not itself, and only where the profile allows a public function")
{
    eager_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    auto const told = [&](auto const& asked, server_profile const& profile = {}) {
        return respond(asked, bank, profile, place);
    };
    CHECK(same_bytes(told("03 00 00 00 01"_hex), "03 02 00 00"_hex));
    CHECK(same_bytes(told("06 00 01 12 34"_hex), "06 00 01 12 34"_hex));
    CHECK(same_bytes(told("10 00 02 00 01 02 56 78"_hex), "10 00 02 00 01"_hex));
    CHECK(same_bytes(told("17 00 01 00 02 00 03 00 01 02 9A BC"_hex), "17 04 12 34 56 78"_hex));
    CHECK(same_bytes(told("08 00 00 12 34"_hex), "08 00 00 12 34"_hex));
    CHECK(same_bytes(told("2B 0E 01 00"_hex), "AB 01"_hex));
    CHECK(bank.get(3) == 0x9ABC);
    CHECK(bank.asked == 0);

    CHECK(same_bytes(told("01 00 00 00 01"_hex), "01 EE"_hex));
    CHECK(same_bytes(told("42 12"_hex), "42 EE"_hex));
    CHECK(bank.asked == 2);

    server_profile const none{.functions = function_set{}};
    CHECK(same_bytes(told("03 00 00 00 01"_hex, none), "83 01"_hex));
    CHECK(same_bytes(told("01 00 00 00 01"_hex, none), "81 01"_hex));
    CHECK(bank.asked == 2);
    CHECK(same_bytes(told("42 12"_hex, none), "42 EE"_hex));
}

namespace {

/// Says that its response is longer than its memory.
struct overlong_bank : word_bank<4> {
    std::size_t size;

    explicit overlong_bank(std::size_t says) : size{says} {}
    [[nodiscard]] std::optional<errc> respond(function_code, pdu_buffer& pdu) const
    {
        pdu.size = size;
        return errc::none;
    }
};

} // namespace

TEST_CASE("a response of a function of the bank's own that is longer than a PDU is exception 04")
{
    constexpr auto asked = "41 01"_hex;
    constexpr auto refusal = "C1 04"_hex;
    constexpr std::size_t sizes[] = {254, 255, 256, 100'000};
    std::array<std::byte, max_pdu_size> place{};
    for (std::size_t const size : sizes) {
        overlong_bank bank{size};
        byte_view const told = respond(asked, bank, server_profile{}, place);
        CHECK(std::equal(told.begin(), told.end(), refusal.begin(), refusal.end()));
    }
    overlong_bank longest{max_pdu_size};
    CHECK(respond(asked, longest, server_profile{}, place).size() == max_pdu_size);
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Banks at the last address there is, and functions that a device lacks.
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/typed_bank.hpp>

#include "support/catch.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

template <typename Bank, std::size_t Size>
std::uint32_t exception_to(std::array<std::byte, Size> const& request, Bank& bank, server_profile const& profile = {})
{
    std::array<std::byte, max_pdu_size> place{};
    byte_view const response = respond(request, bank, profile, place);
    return response.size() == 2 and to_u8(response[0]) >= 0x80 ? to_u8(response[1]) : 0U;
}

constexpr reg<count16> first{.code = "FST", .address = 0};
constexpr reg<count16> last{.code = "LST", .address = 65535};

constexpr auto read_65530_16 = "03 FF FA 00 10"_hex;
constexpr auto read_65530_7 = "03 FF FA 00 07"_hex;
constexpr auto read_65530_6 = "03 FF FA 00 06"_hex;
constexpr auto read_65535_2 = "03 FF FF 00 02"_hex;
constexpr auto write_65535_2 = "10 FF FF 00 02 04 00 01 00 02"_hex;
constexpr auto write_65534_2 = "10 FF FE 00 02 04 00 01 00 02"_hex;
constexpr auto exchange_65535_2 = "17 FF FF 00 02 FF FF 00 01 02 00 05"_hex;

constexpr server_profile no_read{.limits = {0, 61, 4, 4}};
constexpr server_profile no_write{.limits = {63, 0, 4, 4}};
constexpr server_profile no_exchange_read{.limits = {63, 61, 0, 4}};
constexpr server_profile no_exchange_write{.limits = {63, 61, 4, 0}};
constexpr auto read_none = "03 00 00 00 00"_hex;
constexpr auto read_one = "03 00 00 00 01"_hex;
constexpr auto write_one = "10 00 00 00 01 02 00 07"_hex;
constexpr auto write_short = "10 00 00"_hex;
constexpr auto exchange_one = "17 00 00 00 01 00 00 00 01 02 00 07"_hex;
constexpr auto exchange_none = "17 00 00 00 00 00 00 00 00 00"_hex;

} // namespace

TEST_CASE("defect: D14 no bank reads or writes past address 65535")
{
    word_bank<16> bank{65530};
    CHECK(exception_to(read_65530_16, bank) == 2);
    CHECK(exception_to(read_65530_7, bank) == 2);
    CHECK(exception_to(read_65530_6, bank) == 0);
    CHECK(exception_to(read_65535_2, bank) == 2);
    CHECK(exception_to(write_65535_2, bank) == 2);
    CHECK(exception_to(exchange_65535_2, bank) == 2);
    CHECK(bank.get(65535) == 0); // nothing was written in part
    CHECK(exception_to(write_65534_2, bank) == 0);
    CHECK(bank.get(65535) == 2);
    CHECK(bank.check_read(65530, 6) == errc::none);
    CHECK(bank.check_read(65530, 7) == errc::illegal_data_address);
    CHECK(bank.check_read(65530, 16) == errc::illegal_data_address);
    CHECK(bank.check_read(65535, std::size_t{0} - 1) == errc::illegal_data_address);
    CHECK(bank.check_read(65529, 1) == errc::illegal_data_address);

    rtuwire::bank<first, last> typed;
    CHECK(exception_to(read_65535_2, typed) == 2);
    CHECK(exception_to(write_65535_2, typed) == 2);
    CHECK(typed.get<first>() == typed.get<last>());
}

TEST_CASE("defect: (d) a limit of zero is a function that is not there")
{
    word_bank<4> bank;
    CHECK(exception_to(read_one, bank, no_read) == 1);
    CHECK(exception_to(read_none, bank, no_read) == 1);
    CHECK(exception_to(write_one, bank, no_read) == 0);
    CHECK(exception_to(write_one, bank, no_write) == 1);
    CHECK(exception_to(write_short, bank, no_write) == 1);
    CHECK(exception_to(read_one, bank, no_write) == 0);
    for (auto const& profile : {no_exchange_read, no_exchange_write}) {
        CHECK(exception_to(exchange_one, bank, profile) == 1);
        CHECK(exception_to(exchange_none, bank, profile) == 1);
        CHECK(exception_to(read_one, bank, profile) == 0);
        CHECK(exception_to(read_none, bank, profile) == 3);
        CHECK(exception_to(write_one, bank, profile) == 0);
        CHECK(exception_to(write_short, bank, profile) == 3);
    }
    CHECK(exception_to(exchange_one, bank, no_read) == 0);
    CHECK(exception_to(exchange_one, bank, no_write) == 0);
}

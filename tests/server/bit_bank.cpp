// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bits of a server that do not begin at address 0, at both of their ends; and a bank of one's own, which only sets bits.
#include <rtuwire/server/banks.hpp>

#include <array>

#include "support/fact.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/respond.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::is;

namespace {

/// Ten bits from 100 on, of which 100, 103 and 109 are set.
constexpr bit_bank<10> ten()
{
    bit_bank<10> bank{100};
    static_cast<void>(bank.set(100, true));
    static_cast<void>(bank.set(103, true));
    static_cast<void>(bank.set(109, true));
    return bank;
}

constexpr bool has_its_addresses()
{
    auto bank = ten();
    bool ok = true;
    for (std::uint32_t at = 0; at <= 0xFFFF; at += at < 200 ? 1U : 77U) {
        auto const address = static_cast<std::uint16_t>(at);
        bool const is_there = at >= 100 and at < 110;
        bool const is_on = at == 100 or at == 103 or at == 109;
        ok = ok and bank.contains(address) == is_there and bank.get(address) == is_on;
        ok = ok and (bank.set(address, is_on) ? is_there : not is_there);
    }
    return ok;
}
PROOF("bits from 100 on are at 100 to 109 and nowhere else", has_its_addresses)

constexpr bool checks_its_ends()
{
    auto const bank = ten();
    auto const is_allowed = [&](std::uint16_t start, std::size_t count) {
        return bank.check_read(start, count) == errc::none;
    };
    return is(is_allowed(100, 10) and is_allowed(109, 1), "all") and
           is(not is_allowed(99, 1) and not is_allowed(99, 2) and not is_allowed(0, 1), "before") and
           is(not is_allowed(100, 11) and not is_allowed(109, 2) and not is_allowed(110, 1), "behind") and
           is(not is_allowed(65'535, 1) and not is_allowed(65'535, 200), "the last address");
}
PROOF("a range lies inside, or it does not", checks_its_ends)

constexpr bool reads_and_writes()
{
    auto bank = ten();
    std::array<std::byte, 2> told{};
    bool ok = bank.read(100, 10, told) == errc::none and told == "09 02"_hex;
    constexpr auto both = "03"_hex;
    ok = ok and bank.write(108, bit_view{both, 2}) == errc::none;
    told = {};
    return ok and bank.read(103, 7, told) == errc::none and told == "61 00"_hex;
}
PROOF("bits are read and written from where they are", reads_and_writes)

// The last address of all.
constexpr bool reaches_the_end()
{
    bit_bank<8> bank{65'530};
    return bank.check_read(65'530, 6) == errc::none and bank.check_read(65'530, 7) == errc::illegal_data_address and
           bank.set(65'535, true) and bank.get(65'535) and not bank.get(0);
}
PROOF("bits past address 65535 are never reached", reaches_the_end)

/// All are off, so that reading them does nothing; the same memory held a request.
struct dark {
    static constexpr errc check_read(std::uint16_t, std::size_t) { return errc::none; }
    static constexpr errc read(std::uint16_t, std::size_t, byte_span) { return errc::none; }
};
struct dark_device {
    dark bits{};
    constexpr dark& coils() { return bits; }
};

constexpr auto ask_31 = "01 FF E1 00 1F"_hex;
constexpr auto all_off = "01 04 00 00 00 00"_hex;

} // namespace

TEST_CASE("a bank of bits finds its place filled with zeros")
{
    dark_device device;
    server_profile const profile{};
    std::array<std::byte, max_pdu_size> place{};
    CHECK(same_bytes(respond<function_list<read_coils>>(ask_31, device, profile, place), all_off));
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The index that finds a register by its address or its mnemonic, against going through the list.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

#include <rtuwire/core/units.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

template <std::size_t Size> using addresses = std::array<std::uint16_t, Size>;

/// Different addresses, many of which want the same slot.
template <std::size_t Size> addresses<Size> crowd(test::random& random, std::uint32_t from)
{
    addresses<Size> made{};
    for (std::size_t i = 0; i < Size;) {
        auto const address = static_cast<std::uint16_t>(from + random.below(3 * Size));
        if (std::find(made.begin(), made.begin() + i, address) == made.begin() + i) {
            made[i++] = address;
        }
    }
    return made;
}

template <std::size_t Size> bool finds_as_a_search_does(addresses<Size> const& list)
{
    key_index<std::uint16_t, Size> const index{list};
    std::vector<std::size_t> place(0x1'0000, Size);
    for (std::size_t i = 0; i < Size; ++i) {
        place[list[i]] = i;
    }
    for (std::uint32_t address = 0; address <= 0xFFFF; ++address) {
        if (index.find(static_cast<std::uint16_t>(address)) != place[address]) {
            return false;
        }
    }
    return index.duplicate().second == 0;
}

/// The first place whose key is there before, found by looking at every pair.
template <std::size_t Size> index_pair first_pair(addresses<Size> const& list)
{
    for (std::size_t second = 1; second < Size; ++second) {
        for (std::size_t first = second; first-- > 0;) {
            if (list[first] == list[second]) {
                return {first, second};
            }
        }
    }
    return {};
}

} // namespace

TEST_CASE("every address is found in its place, and no other is found")
{
    test::random random{2026};
    CHECK(finds_as_a_search_does(addresses<1>{0}));
    CHECK(finds_as_a_search_does(addresses<2>{65535, 0}));
    CHECK(finds_as_a_search_does(crowd<40>(random, 65'000)));
    CHECK(finds_as_a_search_does(crowd<63>(random, 3201)));
    CHECK(finds_as_a_search_does(crowd<64>(random, 0)));
}

TEST_CASE("every mnemonic is found in its place, and no other is found")
{
    constexpr std::array<literal, 5> names{"ETA", "TEA", "AET", "E", "ETAD"};
    key_index<literal, 5> const index{names};
    for (std::size_t i = 0; i < names.size(); ++i) {
        CHECK(index.find(names[i]) == i);
    }
    for (literal const other : {literal{}, literal{"ET"}, literal{"ETI"}, literal{"ATE"}, literal{"D"}}) {
        CHECK(index.find(other) == names.size());
    }
    CHECK(first_duplicate(names).second == 0);
    index_pair const twice = first_duplicate(std::array<literal, 4>{"CMD", "LFR", "ETA", "LFR"});
    CHECK(twice.first == 1);
    CHECK(twice.second == 3);
}

TEST_CASE("the first key that is there twice is told, with the place where it was before")
{
    test::random random{2026};
    for (unsigned round = 0; round < 500; ++round) {
        addresses<9> list{};
        for (std::uint16_t& each : list) {
            each = static_cast<std::uint16_t>(random.below(20));
        }
        index_pair const expected = first_pair(list);
        index_pair const told = first_duplicate(list);
        REQUIRE(told.second == expected.second);
        REQUIRE(told.first == expected.first);
    }
}

namespace {

inline constexpr reg<count16> here{.code = "HERE", .address = 7};
inline constexpr reg<count16> there{.code = "THERE", .address = 9};

} // namespace

TEST_CASE("a table has the addresses of its registers")
{
    using both = table<here, there>;
    for (std::uint32_t address = 0; address <= 0xFFFF; ++address) {
        REQUIRE(both::has_address(static_cast<std::uint16_t>(address)) == (address == 7 or address == 9));
    }
}

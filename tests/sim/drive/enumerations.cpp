// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every word there is, written to every enumeration of every simulated drive: one that means nothing is refused.
#include <rtuwire/sim/drive/drive.hpp>

#include "support/catch.hpp"
#include "support/drives.hpp"

#include <vector>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// The words that a standing drive takes at an address; all others must be exception 03.
template <typename Device> std::vector<std::uint32_t> taken_at(std::uint16_t address)
{
    detail::simulated_drive<Device> drive{instant{0}};
    std::vector<std::uint32_t> taken;
    std::size_t refused = 0;
    for (std::uint32_t word = 0; word < 0x1'0000; ++word) {
        register_block const value{static_cast<std::uint16_t>(word)};
        errc const verdict = drive.check_write(address, value);
        if (verdict == errc::none) {
            taken.push_back(word);
        }
        refused += verdict == errc::illegal_data_value ? 1U : 0U;
    }
    REQUIRE(taken.size() + refused == 0x1'0000);
    return taken;
}

struct tally {
    unsigned registers{0};
    unsigned words{0};
    unsigned nameless{0};
};

template <typename Device> void try_all(tally& sum)
{
    Device::registers::for_each([&]<auto const & R>() {
        using value = value_of<R>;
        if constexpr (register_enumeration<value>) {
            if (R.mode != access::read_only) {
                ++sum.registers;
                for (std::uint32_t const word : taken_at<Device>(R.address)) {
                    ++sum.words;
                    sum.nameless += name_of(static_cast<value>(word)).size() == 0 ? 1U : 0U;
                }
            }
        }
    });
}

} // namespace

TEST_CASE("no simulated drive takes an enumeration's word without a meaning")
{
    tally sum;
    test::all_drives::for_each([&]<typename Device>() { try_all<Device>(sum); });
    CHECK(sum.registers > 50);
    CHECK(sum.words > 250);
    CHECK(sum.nameless == 0);
}

TEST_CASE("an enumeration takes what its manual lists, and all of it")
{
    using words = std::vector<std::uint32_t>;
    CHECK(taken_at<atv12::device>(6003) == words{24, 28, 32, 36});
    CHECK(taken_at<atv310::device>(6004) == words{2, 3, 4, 5});
    CHECK(taken_at<atv310::device_2026>(7010) == words{0, 1, 4});
    CHECK(taken_at<atv320::device>(7010) == words{0, 1, 2, 4, 5, 6, 7, 8});
    CHECK(taken_at<atv320::device>(8401) == words{1, 2, 3});
    CHECK(taken_at<atv320::device>(8424) == words{1, 2, 3, 10, 20, 30});
    CHECK(taken_at<atv28::device>(16) == words{7, 8});
    CHECK(taken_at<atv28::device>(150) == words{0, 1, 2});
}

TEST_CASE("a scanner word does not carry a meaningless word to an enumeration, either")
{
    detail::simulated_drive<atv320::device> drive{instant{0}};
    auto const tell = [&](std::uint16_t address, std::uint16_t word) {
        register_block const value{word};
        REQUIRE(drive.check_write(address, value) == errc::none);
        static_cast<void>(drive.write(address, value));
    };
    tell(12723, 9020); // NCA3: INR
    tell(12763, 2);
    CHECK(drive.word("INR") == 2);
    tell(12763, 3);
    CHECK(drive.word("INR") == 2);
}

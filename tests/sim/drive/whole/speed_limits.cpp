// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// LSP <= HSP <= TFR at any time, whatever is written: one of them, several by one request, one through the scanner. The
// model here knows the three numbers alone.
#include <rtuwire/sim/drive/image.hpp>

#include "sim/drive/whole/whole_drives.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr std::uint16_t tfr_address = 3103; // HSP and LSP follow
constexpr std::uint16_t third_target = 12'723, third_output = 12'763;

/// TFR, HSP and LSP, in the order of their addresses.
using three = std::array<std::uint16_t, 3>;

bool fit(three const& of) { return of[2] <= of[1] and of[1] <= of[0]; }

/// What the registers of an ATV12 take by themselves; the other drives leave it open.
bool are_inside(three const& of, bool is_limited)
{
    return not is_limited or (of[0] >= 100 and of[0] <= 4'000 and of[1] <= 4'000 and of[2] <= 4'000);
}

template <typename Device> three held_by(test::drive_bench<Device> const& it)
{
    return {it.word("TFR"), it.word("HSP"), it.word("LSP")};
}

/// A write of `count` of them, from the one at `first` on.
template <typename Device>
errc write(test::drive_bench<Device>& it, three const& wanted, std::size_t first, std::size_t count)
{
    auto const start = static_cast<std::uint16_t>(tfr_address + first);
    register_block const one{wanted[first]};
    register_block const two{wanted[first], wanted[first + 1 < 3 ? first + 1 : first]};
    register_block const all{wanted[0], wanted[1], wanted[2]};
    register_view const values = count == 3 ? register_view{all} : count == 2 ? register_view{two} : register_view{one};
    errc const verdict = it.drive().check_write(start, values);
    return verdict == errc::none ? it.drive().write(start, values) : verdict;
}

template <typename Device> void keeps_their_order(bool is_limited)
{
    test::drive_bench<Device> it;
    test::random random{7};
    unsigned taken = 0;
    for (unsigned round = 0; round < 20'000; ++round) {
        three const before = held_by(it);
        std::size_t const first = random.below(3);
        std::size_t const count = 1 + random.below(static_cast<std::uint32_t>(3 - first));
        three wanted = before;
        for (std::size_t i = first; i < first + count; ++i) {
            wanted[i] = static_cast<std::uint16_t>(random.below(50) * 100);
        }
        bool const is_taken = write(it, wanted, first, count) == errc::none;
        REQUIRE(is_taken == (fit(wanted) and are_inside(wanted, is_limited)));
        REQUIRE(held_by(it) == (is_taken ? wanted : before));
        taken += is_taken ? 1U : 0U;
    }
    CHECK(taken > 1'000);
}

/// Through the third output word of the scanner, which drops what its target would refuse.
template <typename Device> void keeps_it_through_the_scanner()
{
    test::drive_bench<Device> it;
    REQUIRE(write(it, {600, 500, 100}, 0, 3) == errc::none);
    REQUIRE(it.tell(third_target, tfr_address + 1) == errc::none);
    for (auto const& [word, expected] :
         {std::pair<std::uint16_t, std::uint16_t>{600, 600}, {601, 600}, {99, 600}, {100, 100}}) {
        REQUIRE(it.tell(third_output, word) == errc::none);
        CHECK(it.word("HSP") == expected);
    }
}

} // namespace

TEST_CASE("LSP, HSP and TFR keep their order through random writes, one by one and together")
{
    test::whole_drives::for_each(
        []<typename Device>() { keeps_their_order<Device>(Device::name == literal{"atv12"}); });
}

TEST_CASE("the scanner does not bring LSP, HSP and TFR out of order, either")
{
    test::whole_drives::for_each([]<typename Device>() { keeps_it_through_the_scanner<Device>(); });
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each command word does in each state, of five simulated drives: 405 cells. What is expected comes from the
// manuals' tables of bit patterns, printed here as data; neither the library's chart nor its decoders are asked.
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/sim/drive/drive.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// One change of the chart, by the numbers of its states in the manuals: 2 switch on disabled, 3 ready, 4 switched
/// on, 5 operation enabled, 6 quick stop active, 8 fault.
struct change {
    int from;
    int to;
};

/// A row of "Command word description": the bits that count, and where the command leads. Bit 7 is printed x for
/// all of them: the reset's row alone has an edge there, and leads on from a fault only.
struct row {
    char const* command;
    std::uint16_t counts;
    std::uint16_t pattern;
    std::array<change, 4> changes;
};
constexpr std::array<row, 6> table{{
    {"shutdown x x 1 1 0", 0x07, 0x06, {{{2, 3}, {4, 3}, {5, 3}}}},
    {"switch on x x 1 1 1", 0x07, 0x07, {{{3, 4}}}},
    {"enable operation x 1 1 1 1", 0x0F, 0x0F, {{{4, 5}}}},
    {"disable operation x 0 1 1 1", 0x0F, 0x07, {{{5, 4}}}},
    {"disable voltage x x x 0 x", 0x02, 0x00, {{{3, 2}, {4, 2}, {5, 2}, {6, 2}}}},
    {"quick stop x x 0 1 x", 0x06, 0x02, {{{3, 2}, {4, 2}, {5, 6}}}},
}};

int changed(row const& by, int from)
{
    for (change const& each : by.changes) {
        if (each.from == from) {
            return each.to;
        }
    }
    return from;
}

/// The state after a word whose bit 7 was low before. Two rows fit 000F: "switch on" leads from 3 to 4, and by
/// level "enable operation" on from there; on drives with a transition 3B it is that.
int expected(int from, std::uint16_t word)
{
    if (from == 8) {
        return (word & 0x80) != 0 ? 2 : 8;
    }
    int at = from;
    for (row const& each : table) {
        if ((word & each.counts) == each.pattern) {
            at = changed(each, at);
        }
    }
    return at;
}

/// The state that a status word shows, by the columns "bit 6 .. bit 0" of "Status word description" without bit 4;
/// 0 for none.
int shown(std::uint16_t eta)
{
    switch (eta & 0x4F) {
    case 0x40: return 2;
    case 0x08: return 8;
    default: break;
    }
    switch (eta & 0x6F) {
    case 0x21: return 3;
    case 0x23: return 4;
    case 0x27: return 5;
    case 0x07: return 6;
    default: return 0;
    }
}

constexpr std::array<std::uint16_t, 15> words{0x0006, 0x0007, 0x000F, 0x080F, 0x010F, 0x0000, 0x0002, 0x000B,
                                              0x0080, 0x0086, 0x0087, 0x008F, 0x0082, 0x0001, 0x000D};

template <typename Device> class bench {
public:
    bench() { wait(10); }

    void wait(std::uint32_t time_ms)
    {
        now_ = now_ + milliseconds(time_ms);
        drive_.advance(now_);
    }
    void tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(drive_.check_write(address, value) == errc::none);
        REQUIRE(drive_.write(address, value) == errc::none);
    }
    void command(std::uint16_t word) { tell(Device::layout.cmd, word); }
    int state() const { return shown(drive_.word("ETA")); }

    /// Takes it there by the words that the manuals' examples use; in 5 and 6 the motor turns.
    void reach(int goal)
    {
        if (goal == 8) {
            drive_.inject_fault(9);
            wait(10);
            drive_.clear_cause();
            command(0x0000);
            return;
        }
        tell(Device::frequency_reference.address, 200);
        constexpr std::array<std::uint16_t, 3> up{0x0006, 0x0007, 0x000F};
        for (int at = 2; at < goal and at < 5; ++at) {
            command(up[static_cast<std::size_t>(at - 2)]);
        }
        wait(1'000);
        if (goal == 6) {
            command(0x0002);
        }
    }

private:
    instant now_{0};
    detail::simulated_drive<Device> drive_{now_};
};

struct tally {
    unsigned cells{0};
    unsigned right{0};
    std::string wrong{};
};

/// One cell: at once for a quick stop, after the motor has come to rest for where it ends. A drive whose chart has
/// transition 12 by itself goes from 6 to 2 then (ATV12, ATV310); the others wait.
template <typename Device> void try_cell(int from, std::uint16_t word, bool leaves_6, tally& sum)
{
    bench<Device> it;
    it.reach(from);
    REQUIRE(it.state() == from);
    int const goal = expected(from, word);
    it.command(word);
    int const first = it.state();
    it.wait(3'000);
    it.wait(10);
    int const last = it.state();
    bool const is_right = last == (goal == 6 and leaves_6 ? 2 : goal) and (goal != 6 or first == 6);
    ++sum.cells;
    sum.right += is_right ? 1U : 0U;
    if (not is_right) {
        std::string const name{Device::name.begin(), Device::name.end()};
        char cell[80];
        std::snprintf(cell, sizeof cell, " %s %d+%04X: %d not %d;", name.c_str(), from, unsigned{word}, last, goal);
        sum.wrong += cell;
    }
}

template <typename Device> void try_drive(bool leaves_6, tally& sum)
{
    for (int const from : {2, 3, 4, 5, 6, 8}) {
        for (std::uint16_t const word : words) {
            if (from != 6 or not leaves_6) {
                try_cell<Device>(from, word, leaves_6, sum);
            }
        }
    }
}

} // namespace

TEST_CASE("motion law: state matrix of 27 states and 15 words")
{
    tally sum;
    // Which drives wait in state 6 once the motor stands comes from the manuals; the layouts are not asked.
    using stay_in_6 = test::drive_list<atv28::device, atv320::device>;
    test::all_drives::for_each([&]<typename Device>() { try_drive<Device>(not stay_in_6::contains<Device>, sum); });
    INFO(sum.right << " of " << sum.cells << " cells;" << sum.wrong);
    CHECK(sum.cells == 405);
    CHECK(sum.right == 405);
}

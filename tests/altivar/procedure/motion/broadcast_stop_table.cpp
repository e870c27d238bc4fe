// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a stop of all drives: each stage and whatever comes of its broadcast, as they stand beside the code.
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "altivar/procedure/motion/broadcast_stop_by_hand.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv28::device> fan{unit_id{3}};
constexpr station<atv12::device> hoist{unit_id{4}};

// What is sent to all drives, at the 8501 of later Altivars and at the 400 of an ATV28; and to one drive alone.
constexpr std::string_view all_new = "00 06 21 35 00 02", all_old = "00 06 01 90 00 02";
constexpr std::string_view own_hoist = "04 06 21 35 00 02", look_at_hoist = "04 03 0C 81 00 02";
constexpr std::string_view own_fan = "03 06 01 90 00 02", nothing, x = "never";

/// The cells of a stage: what is sent at once; after this was sent, or was lost; and where it can still not be sent
/// 999 ms and 1 s later.
struct stage {
    char const* name;
    std::string_view there; ///< s: sent or confirmed, l: lost, w: 1 s later, d: "switch on disabled" was read
    std::array<std::string_view, 5> cells;
    bool is_urgent;
    effect intent;
    bool is_over{false};
};
constexpr std::array<char const*, 5> answers{"at once", "sent", "lost", "999 ms later", "1 s later"};
constexpr effect stops = effect::stopping, waits = effect::none;

// clang-format off
constexpr std::array<stage, 8> one_family{{
    // stage, and the way there
    //   at once, sent, lost, 999 ms later, 1 s later
    {"the first round", "", {all_new, all_new, all_new, all_new, all_new}, true, stops},
    {"the second round", "s", {all_new, nothing, nothing, all_new, all_new}, true, stops},
    {"the second round after one that was lost", "l", {all_new, nothing, nothing, all_new, all_new}, true, stops},
    {"a wait", "ss", {nothing, x, x, nothing, all_new}, true, waits},
    {"the last round", "ssw", {all_new, own_hoist, own_hoist, all_new, all_new}, true, stops},
    {"the second round, late", "sw", {all_new, all_new, all_new, all_new, all_new}, true, stops},
    {"each drive", "ssws", {own_hoist, look_at_hoist, nothing, own_hoist, own_hoist}, false, stops},
    {"the end", "sswssd", {nothing, x, x, nothing, nothing}, false, waits, true},
}};
constexpr std::array<stage, 8> two_families{{
    {"the first round, ATV28", "", {all_old, all_new, all_new, all_old, all_old}, true, stops},
    {"the first round, later drives", "s", {all_new, all_old, all_old, all_new, all_new}, true, stops},
    {"the second round, ATV28", "sl", {all_old, all_new, all_new, all_old, all_old}, true, stops},
    {"the second round, later drives", "sss", {all_new, nothing, nothing, all_new, all_new}, true, stops},
    {"a wait", "ssss", {nothing, x, x, nothing, all_old}, true, waits},
    {"the last round, ATV28", "ssssw", {all_old, all_new, all_new, all_old, all_old}, true, stops},
    {"the last round, later drives", "sssswl", {all_new, own_hoist, own_hoist, all_new, all_new}, true, stops},
    {"each drive", "sssswls", {own_hoist, own_fan, own_fan, own_hoist, own_hoist}, false, stops},
}};
constexpr std::array<stage, 4> one_left_out{{
    {"the first round, ATV28", "", {all_old, all_old, all_old, all_old, all_old}, true, stops},
    {"a wait", "ss", {nothing, x, x, nothing, all_old}, true, waits},
    {"the last round, ATV28", "ssw", {all_old, own_hoist, own_hoist, all_old, all_old}, true, stops},
    {"each drive", "ssws", {own_hoist, own_fan, own_fan, own_hoist, own_hoist}, false, stops},
}};
constexpr std::array<stage, 2> all_left_out{{
    {"each drive", "", {own_hoist, look_at_hoist, nothing, own_hoist, own_hoist}, false, stops},
    {"the end", "sd", {nothing, x, x, nothing, nothing}, false, waits, true},
}};
// clang-format on

template <std::size_t Drives> void take(test::everyone_by_hand<Drives>& it, char what)
{
    switch (what) {
    case 's':
        static_cast<void>(it.asks());
        it.confirm();
        break;
    case 'l':
        static_cast<void>(it.asks());
        it.all.accept(errc::transmit_stalled);
        break;
    case 'w': it.wait(1'000); break;
    default:
        static_cast<void>(it.asks());
        it.hear(0x0250);
        break;
    }
}

/// Checks each cell, and names the one that is wrong.
template <std::size_t Drives, std::size_t Rows>
void check_stages(test::everyone_by_hand<Drives> const& fresh, std::array<stage, Rows> const& rows)
{
    for (stage const& row : rows) {
        test::everyone_by_hand<Drives> there = fresh;
        for (char const what : row.there) {
            take(there, what);
        }
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (row.cells[i] == x) {
                continue;
            }
            INFO(row.name << ", " << answers[i]);
            test::everyone_by_hand<Drives> it = there;
            if (i == 1 or i == 2) {
                take(it, i == 1 ? 's' : 'l');
            }
            it.wait(i == 3 ? 999 : i == 4 ? 1'000 : 0);
            if (row.there.empty()) {
                static_cast<void>(std::move(it).with_known_words()); // what was read counts for half a second
            }
            CHECK(it.asks() == row.cells[i]);
        }
        INFO(row.name);
        static_cast<void>(there.asks());
        CHECK(there.all.is_urgent() == row.is_urgent);
        CHECK(there.all.intent() == row.intent);
        CHECK(there.all.settled() == row.is_over);
    }
}

/// The drives of a line, and what is sent to all of them.
struct line {
    char const* name;
    broadcast_stop_options options;
    std::array<drive_layout const*, 3> drives;
    std::array<std::uint16_t, 2> addresses; ///< of one round
    std::uint16_t word;
};
constexpr drive_layout const *old = &atv28::device::layout, *later = &atv12::device::layout;
constexpr drive_layout const *third = &atv320::device::layout, *none = nullptr;

constexpr std::array<line, 6> lines{{
    {"later drives", {}, {later, later, none}, {8501, 8501}, 0x0002},
    {"ATV28s", {}, {old, old, none}, {400, 400}, 0x0002},
    {"both", {}, {old, later, none}, {400, 8501}, 0x0002},
    {"three", {}, {later, old, third}, {8501, 400}, 0x0002},
    {"all coast", {.freewheel = true}, {old, later, none}, {400, 8501}, 0x0000},
    {"one address is left out", {.left_out = 8501}, {old, later, none}, {400, 400}, 0x0002},
}};

} // namespace

TEST_CASE("a stop of all drives does in each stage, whatever comes of its broadcast, what its table says")
{
    check_stages(test::everyone_by_hand<1>{hoist}.with_known_words(), one_family);
    check_stages(test::everyone_by_hand<2>{fan, hoist}.with_known_words(), two_families);
    check_stages(test::everyone_by_hand<2>{broadcast_stop_options{.left_out = 8501}, fan, hoist}.with_known_words(),
                 one_left_out);
    check_stages(test::everyone_by_hand<1>{broadcast_stop_options{.left_out = 8501}, hoist}.with_known_words(),
                 all_left_out);
}

TEST_CASE("a stop of all drives sends one word, three times to each address")
{
    for (line const& each : lines) {
        INFO(each.name);
        broadcast_rounds rounds{each.options};
        for (drive_layout const* drive : each.drives) {
            if (drive != nullptr) {
                rounds.add(drive->cmd);
            }
        }
        unsigned const in_a_round = each.addresses[0] == each.addresses[1] ? 1 : 2;
        for (unsigned i = 0; i < 3 * in_a_round; ++i) {
            CHECK_FALSE(rounds.is_over());
            CHECK(rounds.is_last_round() == (i >= 2 * in_a_round));
            CHECK(rounds.request().address == each.addresses[i % 2]);
            CHECK(rounds.request().value == each.word);
            rounds.next();
        }
        CHECK(rounds.is_over());
        CHECK(rounds.coasts() == (each.word == 0));
    }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A reference of 0, and one that is less than a step of the drive: with LSP above 0 the motor turns at LSP, in the
// direction that was asked for and no other. Judged by the motor alone.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::cut_after;
using test::frame_bytes;
using test::plant;
using test::seen_frequencies;
using test::usual_limit;
using test::within_limits;
using kind = outcome_kind;

namespace {

constexpr auto forward = run_direction::forward, reverse = run_direction::reverse;

template <typename Device>
inline constexpr std::uint16_t lsp_address = std::is_same_v<Device, atv28::device> ? 251 : 3105;

/// A drive whose motor turns at this frequency at least, in 0.1 Hz.
template <typename Device> struct slow_plant : plant<Device> {
    explicit slow_plant(std::uint16_t lsp) { this->tell(lsp_address<Device>, lsp); }
};

/// Whether a motor that had this frequency at first never turned in another direction than `way`, and no faster than at
/// first or at LSP.
bool kept_to(run_direction way, seen_frequencies const& seen, std::int32_t first, std::int32_t lsp)
{
    std::int32_t const most = std::max(first < 0 ? -first : first, lsp);
    std::int32_t const least_allowed = way == reverse ? -most : std::min(first, 0);
    std::int32_t const most_allowed = way == reverse ? std::max(first, 0) : most;
    return seen.lowest >= least_allowed and seen.highest <= most_allowed;
}

/// A conversation and its motor, 5 s long: it ends at LSP in this direction, and is told so. An ATV28 trips after 7 s.
template <typename Device, typename Conversation>
void check_end(plant<Device>& it, Conversation conversation, run_direction way)
{
    constexpr std::int32_t lsp = 10'000;
    std::int32_t const first = it.millihertz();
    seen_frequencies const seen = it.watch(conversation, milliseconds(5'000));
    CHECK(it.millihertz() == (way == reverse ? -lsp : lsp));
    CHECK(kept_to(way, seen, first, lsp));
    CHECK(conversation.reason().kind == kind::reference_limited);
}

template <typename Device> struct zero_cycle : slow_plant<Device> {
    cyclic<Device> loop{station<Device>{unit_id{3}}, {.supervision = test::within_limits}};

    explicit zero_cycle(std::uint16_t lsp) : slow_plant<Device>{lsp} { this->watch(loop, milliseconds(1'000)); }

    /// In steps of the cycle's reference: 1 rpm, or 0.1 Hz.
    bool order(std::int16_t steps, run_direction way)
    {
        using at = setting<cycle_layout<Device>::reference>;
        return loop.run(*at::checked(typename at::value_type{steps}), way);
    }
    static constexpr std::int16_t at_30_hertz = cycle_layout<Device>::has_scanner ? 900 : 300;
};

} // namespace

TEST_CASE("motion law: S31 a start at 0 turns at LSP, forward or in reverse as it was asked")
{
    test::all_drives::for_each([]<typename Device>() {
        for (run_direction const way : {forward, reverse}) {
            slow_plant<Device> it{100};
            check_end(it, start{it.drive, 0_Hz, way, usual_limit, within_limits}, way);
            slow_plant<Device> by_speed{100};
            check_end(by_speed, start{by_speed.drive, 0_rpm, way, usual_limit, within_limits}, way);
        }
    });
}

TEST_CASE("motion law: S31 a change to 0 keeps the direction of a motor, however that was told")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const by_bit : {false, true}) {
            for (run_direction const way : {forward, reverse}) {
                slow_plant<Device> it{100};
                it.turn(way == reverse ? -30 : 30, by_bit);
                check_end(it, change_reference{it.drive, 0_Hz}, way);
                check_end(it, change_reference{it.drive, 0_rpm}, way);
                check_end(it, start{it.drive, 0_Hz, way}, way);
            }
        }
    });
}

TEST_CASE("motion law: S31 a cycle at 0 turns at LSP, forward or in reverse as it was asked")
{
    test::all_drives::for_each([]<typename Device>() {
        for (run_direction const way : {forward, reverse}) {
            for (bool const from_rest : {true, false}) {
                zero_cycle<Device> it{100};
                if (not from_rest) {
                    REQUIRE(it.order(it.at_30_hertz, way));
                    it.watch(it.loop, milliseconds(5'000));
                    REQUIRE(it.millihertz() == (way == reverse ? -30'000 : 30'000));
                }
                std::int32_t const first = it.millihertz();
                REQUIRE(it.order(0, way));
                seen_frequencies const seen = it.watch(it.loop, milliseconds(5'000));
                CHECK(it.millihertz() == (way == reverse ? -10'000 : 10'000));
                CHECK(kept_to(way, seen, first, 10'000));
                CHECK((it.loop.control().status() & reference_limited_bit) != 0);
            }
        }
    });
}

TEST_CASE("motion law: S42 no order of 0 turns a motor round that runs in reverse")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const by_bit : {false, true}) {
            slow_plant<Device> it{100};
            it.turn(-30, by_bit);
            check_end(it, start{it.drive, 0_Hz}, reverse);
            check_end(it, change_reference{it.drive, 0_Hz}, reverse);
            check_end(it, change_reference{it.drive, 0_rpm}, reverse);
        }
        zero_cycle<Device> it{100};
        REQUIRE(it.order(it.at_30_hertz, reverse));
        it.watch(it.loop, milliseconds(5'000));
        REQUIRE(it.millihertz() == -30'000);
        for (unsigned i = 0; i < 20; ++i) {
            REQUIRE(it.order(0, forward));
            CHECK(it.watch(it.loop, milliseconds(300)).highest < 0);
        }
        CHECK(it.millihertz() == -10'000);
    });
}

TEST_CASE("motion law: S42 the least speeds in reverse do not become 0 on their way")
{
    test::all_drives::for_each([]<typename Device>() {
        slow_plant<Device> one{100}, two{100}, tenth{100};
        check_end(one, start{one.drive, -1_rpm, forward, usual_limit, within_limits}, reverse);
        check_end(one, change_reference{one.drive, -2_rpm}, reverse);
        check_end(two, start{two.drive, 2_rpm, reverse, usual_limit, within_limits}, reverse);
        check_end(two, change_reference{two.drive, -1_rpm}, reverse);
        check_end(tenth, start{tenth.drive, signed_decihertz{-1}, forward, usual_limit, within_limits}, reverse);
        slow_plant<Device> ahead{100};
        ahead.turn(-30, true);
        check_end(ahead, start{ahead.drive, 1_rpm}, forward);
        zero_cycle<Device> cycle{100};
        REQUIRE(cycle.order(-1, forward));
        CHECK(cycle.watch(cycle.loop, milliseconds(5'000)).highest == 0);
        CHECK(cycle.millihertz() == -10'000);
    });
    slow_plant<atv28::device> direct{100};
    check_end(direct, atv28::direct_start{direct.drive, -1_rpm, usual_limit, within_limits}, reverse);
}

TEST_CASE("motion law: S42 the greatest reference in reverse is no less in reverse under the direction bit")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        it.turn(-30, true);
        change_reference all{it.drive, *setting<Device::speed_reference>::checked(signed_rpm{-32'768}),
                             milliseconds(30'000), beyond_limits::limit};
        CHECK(it.watch(all, milliseconds(5'000)).highest < 0);
        CHECK(all.reason().kind == kind::reference_limited);
        CHECK(it.millihertz() == -50'000);
    });
}

TEST_CASE("motion law: S42 with LSP at 0 a motor in reverse comes to a stand, and goes forward in no case")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const by_bit : {false, true}) {
            plant<Device> it;
            it.turn(-30, by_bit);
            change_reference down{it.drive, 0_Hz};
            CHECK(it.watch(down, milliseconds(5'000)).highest <= 0);
            CHECK(down.succeeded());
            CHECK(it.millihertz() == 0);
        }
        constexpr std::int32_t step = 100; // mHz, of LFR
        plant<Device> at_rest;
        start slowly{at_rest.drive, 0_Hz, reverse};
        seen_frequencies const seen = at_rest.watch(slowly, milliseconds(5'000));
        CHECK(slowly.running());
        CHECK((seen.highest == 0 and seen.lowest >= -step));
        zero_cycle<Device> cycle{0};
        REQUIRE(cycle.order(0, reverse));
        seen_frequencies const cycled = cycle.watch(cycle.loop, milliseconds(5'000));
        CHECK(cycle.loop.control().is_running());
        CHECK((cycled.highest == 0 and cycled.lowest >= -2 * step)); // it has not read what a hertz is in rpm
    });
}

TEST_CASE("motion law: S42 a drive that does not tell its LSP keeps its direction")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::uint16_t const lsp : std::array<std::uint16_t, 2>{100, 0}) {
            slow_plant<Device> it{lsp};
            it.turn(-30, false);
            bool is_asked_for_lsp = false;
            it.disturb([&](frame_bytes& frame, bool is_request) {
                if (is_request) {
                    is_asked_for_lsp = frame[1] == std::byte{3} and frame[2] == to_byte(lsp_address<Device> >> 8U) and
                                       frame[3] == to_byte(lsp_address<Device>);
                } else if (is_asked_for_lsp) {
                    frame = {frame[0], std::byte{0x83}, std::byte{2}};
                    std::uint16_t const crc = crc16(frame);
                    frame.push_back(to_byte(crc));
                    frame.push_back(to_byte(crc >> 8U));
                }
            });
            change_reference down{it.drive, 0_Hz};
            CHECK(it.watch(down, milliseconds(5'000)).highest < 0);
            CHECK(down.reason().kind == (lsp == 0 ? kind::succeeded : kind::reference_limited));
            CHECK(it.millihertz() == (lsp == 0 ? -100 : -10'000));
        }
    });
}

TEST_CASE("motion law: S42 cut after any of its frames, an order of 0 in reverse never turns a motor forward")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const only_answers : {false, true}) {
            for (bool const by_bit : {false, true}) {
                bool goes_on = true;
                for (unsigned frames = 0; goes_on and frames < 30; frames += test::one_in(5)) {
                    slow_plant<Device> running{100}, standing{100};
                    running.turn(-30, by_bit);
                    std::int32_t lowest = 0, highest = 0;
                    goes_on = cut_after(running, change_reference{running.drive, 0_Hz}, frames, only_answers, lowest,
                                        highest);
                    CHECK((lowest >= -30'000 and highest <= 0));
                    goes_on = cut_after(standing, start{standing.drive, 0_Hz, reverse, usual_limit, within_limits},
                                        frames, only_answers, lowest, highest) or
                              goes_on;
                    CHECK((lowest >= -10'000 and highest <= 0));
                }
            }
        }
    });
}

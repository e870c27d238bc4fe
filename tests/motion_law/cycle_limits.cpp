// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// References that a cycle is given beyond LSP and HSP: what is refused before a word leaves, and what never is because it
// slows a motor down. Judged by the motor and by the frames.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>
#include <cstdlib>

#include <rtuwire/altivar/cyclic/cyclic.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using kind = outcome_kind;

namespace {

/// A cycle of a drive with LSP 10 Hz and HSP 50 Hz, whose motor has two pairs of poles: 1 Hz is 30 rpm.
template <typename Device> struct limited_cycle : test::plant<Device> {
    cyclic<Device> loop;
    unsigned told{0}; ///< requests that wrote several words, one of them a reference other than 0

    explicit limited_cycle(supervision_options const& options = {})
        : loop{test::plant<Device>::drive, cyclic_options{.supervision = options}}
    {
        this->tell(Device::layout.lsp, 100);
        if (Device::layout.sds != 0) {
            this->tell(Device::layout.sds, 30);
        }
        pass(milliseconds(1'000));
        this->disturb([this](test::frame_bytes& frame, bool is_request) {
            std::size_t const at = frame[1] == std::byte{23} ? 13 : 9;
            bool const is_exchange = is_request and (frame[1] == std::byte{23} or frame[1] == std::byte{16});
            told += is_exchange and u16_at(byte_view{frame}, at) != 0 ? 1U : 0U;
        });
    }
    void pass(duration length) { this->watch(loop, length); }

    /// In 0.1 Hz, where the cycle's reference is a speed as rpm.
    bool order(int tenths, run_direction way = run_direction::forward)
    {
        using at = setting<cycle_layout<Device>::reference>;
        int const steps = cycle_layout<Device>::is_by_speed ? tenths * 3 : tenths;
        return loop.run(*at::checked(typename at::value_type{static_cast<std::int16_t>(steps)}), way);
    }
    bool refuses(int tenths, kind why, std::uint16_t limit, run_direction way = run_direction::forward)
    {
        bool const is_taken = order(tenths, way);
        pass(milliseconds(500));
        return not is_taken and loop.control().reason().kind == why and loop.control().reason().limit == limit;
    }
};

} // namespace

TEST_CASE("motion law: S43 a cycle takes no order beyond the limits for a motor at rest, either way")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_cycle<Device> it;
        for (int const sign : {1, -1}) {
            for (int const over : {501, 7'000}) {
                CHECK(it.refuses(sign * over, kind::above_hsp, 500));
            }
            for (int const under : {99, 1}) {
                CHECK(it.refuses(sign * under, kind::below_lsp, 100));
            }
        }
        CHECK(it.refuses(0, kind::below_lsp, 100));
        CHECK(it.refuses(0, kind::below_lsp, 100, run_direction::reverse));
        CHECK(it.refuses(600, kind::above_hsp, 500, run_direction::reverse));
        CHECK((it.told == 0 and it.millihertz() == 0));
        CHECK_FALSE(it.loop.control().is_ordered());
        for (int const at : {500, 100, -100, -500}) {
            CHECK(it.order(at));
            it.pass(milliseconds(10'000));
            CHECK(it.millihertz() == at * 100);
            CHECK(it.loop.control().reason().kind == kind::pending);
        }
    });
}

TEST_CASE(
    "motion law: S43 a cycle that is refused a faster reference keeps the one it has, and never refuses a slower one")
{
    test::all_drives::for_each([]<typename Device>() {
        for (int const sign : {1, -1}) {
            limited_cycle<Device> it;
            REQUIRE(it.order(sign * 400));
            it.pass(milliseconds(150)); // on its way up
            CHECK(it.order(sign * 300));
            CHECK(it.order(sign * 50));
            CHECK(it.order(sign * 400));
            it.pass(milliseconds(8'000));
            CHECK(it.refuses(sign * 600, kind::above_hsp, 500));
            CHECK(it.loop.control().is_ordered());
            CHECK(it.millihertz() == sign * 40'000);
            // Slower than LSP, and the least that it may be told: it turns at LSP, the same way.
            for (int const slow : {50, 0}) {
                CHECK(it.order(sign * slow));
                it.pass(milliseconds(8'000));
                CHECK(it.millihertz() == sign * 10'000);
                CHECK((it.loop.control().status() & reference_limited_bit) != 0);
            }
            // Somebody lowered HSP below what it has.
            CHECK(it.order(sign * 480));
            it.pass(milliseconds(8'000));
            it.tell(Device::layout.hsp, 300);
            CHECK(it.order(sign * 470));
            it.pass(milliseconds(4'000));
            CHECK(it.millihertz() == sign * 30'000);
            CHECK(it.order(sign * 200));
            it.pass(milliseconds(4'000));
            CHECK(it.millihertz() == sign * 20'000);
        }
    });
}

TEST_CASE("motion law: S43 a cycle whose user asks for it is limited by its drive")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_cycle<Device> it{{.beyond = beyond_limits::limit}};
        for (int const at : {600, -600}) {
            CHECK(it.order(at));
            it.pass(milliseconds(12'000));
            CHECK(it.millihertz() == (at < 0 ? -50'000 : 50'000));
        }
        CHECK(it.loop.supervision().limits.highest == reference_limits::unread);
    });
}

TEST_CASE("motion law: S43 a cycle uses the limits of its last check")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_cycle<Device> it;
        REQUIRE(it.order(450));
        it.pass(milliseconds(8'000));
        it.loop.stop();
        it.pass(milliseconds(8'000));
        it.tell(Device::layout.hsp, 300);
        // Its drive is away for a while.
        it.cut(0, true);
        it.pass(milliseconds(2'000));
        it.cut(0, false);
        it.pass(milliseconds(60'000));
        if (it.loop.control().state() == cia402::state::fault) {
            it.loop.reset_fault();
            it.pass(milliseconds(3'000));
        }
        CHECK(it.refuses(450, kind::above_hsp, 300));
        CHECK(it.order(290));
    });
}

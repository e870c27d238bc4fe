// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A check before an order whose last read cannot show what its first ones were told before a power cycle. Shown by the
// motor: who is told that it runs as ordered has it at that speed.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::plant;

namespace {

constexpr std::uint16_t lsp_at = 251; ///< of an ATV28: without its reference the motor turns at 10 Hz

/// A direct start whose drive loses its power.
struct direct_start_off : plant<atv28::device> {
    atv28::direct_start go;
    bool was_told{false};  ///< to run
    bool was_asked{false}; ///< whether it runs, after that

    // Not a member's initializer: Clang 14 would evaluate the reference at run time.
    direct_start_off() : go{drive, 20_Hz} {}

    /// Whether it lost it, before it was asked for the status that ends the start.
    bool loses_power_at(duration after)
    {
        tell(lsp_at, 100);
        disturb([this](test::frame_bytes const& frame, bool is_request) {
            byte_view const bytes{frame};
            was_told = was_told or (is_request and u16_at(bytes, 4) == 0x800A);
            was_asked = was_asked or (was_told and is_request and u16_at(bytes, 2) == atv28::eta.address);
        });
        instant const off = now() + after;
        bool was_off = false;
        while (not go.settled()) {
            step([&](instant now) { link().converse(go, now); }, milliseconds(1));
            if (not was_off and not was_asked and reached(now(), off)) {
                was_off = true;
                far().power_cycle(now());
            }
        }
        return was_off;
    }
};

} // namespace

TEST_CASE("defect: D29 a power cycle at any moment of a direct start is seen, or the motor has its speed")
{
    unsigned started = 0, refused = 0;
    for (std::uint32_t at = 1; at < 1'000; ++at) {
        direct_start_off it;
        if (not it.loses_power_at(milliseconds(at))) {
            break; // it was done before
        }
        ++(it.go.running() ? started : refused);
        if (it.go.running()) {
            it.idle(milliseconds(5'000)); // it trips after 7 s
            INFO(at << " ms");
            CHECK(it.millihertz() == 20'000);
        }
    }
    CHECK((started != 0 and refused != 0));
}

TEST_CASE("defect: D29 a motor that another master stops while a start takes it over is not run again")
{
    test::all_drives::for_each([]<typename Device>() {
        std::uint32_t stopped = 0;
        for (std::uint32_t at = 1; at < 2'000; at += 3) {
            plant<Device> it;
            it.turn(30, false);
            start go{it.drive, 20_Hz};
            bool was_met = false, has_reference = false, was_checked = false, was_stopped = false;
            it.disturb([&](test::frame_bytes const& frame, bool is_request) {
                bool const is_write = frame[1] == std::byte{6};
                was_met = was_met or not is_request;
                was_checked = was_checked or (has_reference and is_request and not is_write);
                has_reference = has_reference or (is_request and is_write);
            });
            instant const then = it.now() + milliseconds(at);
            while (not go.settled()) {
                it.step([&](instant now) { it.link().converse(go, now); }, milliseconds(1));
                if (not was_stopped and was_met and not was_checked and reached(it.now(), then)) {
                    was_stopped = true;
                    register_block const shutdown{std::uint16_t{0x0006}};
                    static_cast<void>(it.far().write(Device::layout.cmd, shutdown));
                }
            }
            if (not was_stopped) {
                break;
            }
            ++stopped;
            INFO(Device::layout.cmd << ", " << at << " ms");
            CHECK_FALSE(go.running());
            it.idle(milliseconds(200));
            CHECK_FALSE(cia402::has_power(it.far().state_machine().state()));
        }
        CHECK(stopped != 0);
    });
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// D26: a cycle that checks its drive anew goes by the last word of that check, a status, as by any other.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <functional>

#include <rtuwire/altivar/cyclic/cyclic.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

template <typename Device> struct checking : test::plant<Device> {
    cyclic<Device> loop{test::plant<Device>::drive};
    unsigned reads{0}; ///< since the lost response to the first 000F
    bool is_lost{false};

    void pass(duration length)
    {
        this->run([&](instant now) { this->link().converse(loop, now); }, [] { return false; }, length);
    }
    bool order()
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(900_rpm);
        } else {
            return loop.run(30_Hz);
        }
    }
    bool runs() { return this->far().state_machine().state() == cia402::state::operation_enabled; }

    /// Whether the request writes 000F as its control word.
    static bool enables(byte_view frame)
    {
        std::size_t const at = frame[1] == std::byte{23} ? 11 : frame[1] == std::byte{16} ? 7 : 4;
        return frame[1] != std::byte{3} and u16_at(frame, at) == 0x000F;
    }
};

/// The response to the first 000F is lost, and something happens to the drive just before the n-th read of the check that
/// follows. False where the cycle wrote before; a write behind a read may be too late to know.
template <typename Device> bool happens_before(unsigned nth, std::function<void(checking<Device>&)> const& what)
{
    checking<Device> it;
    bool has_happened = false;
    bool has_written = false;
    it.disturb([&](test::frame_bytes& frame, bool is_request) {
        if (is_request and not it.is_lost) {
            it.is_lost = it.enables(frame);
        } else if (not is_request and it.is_lost and it.reads == 0) {
            frame.clear();
            it.reads = 1;
        } else if (is_request and it.reads != 0 and not has_happened) {
            has_written = has_written or frame[1] != std::byte{3};
            if (not has_written and it.reads++ == nth) {
                has_happened = true;
                what(it);
            }
        }
    });
    it.pass(milliseconds(500));
    REQUIRE(it.order());
    bool had_power = false;
    for (unsigned i = 0; i < 400; ++i) {
        it.pass(milliseconds(10));
        had_power = had_power or (has_happened and it.runs());
    }
    if (not has_happened) {
        return false;
    }
    CHECK_FALSE(had_power);
    CHECK_FALSE(it.loop.control().is_ordered());
    return true;
}

} // namespace

TEST_CASE("defect: D26 what befell a drive while a cycle checked it anew is not overlooked")
{
    test::all_drives::for_each([]<typename Device>() {
        std::function<void(checking<Device>&)> const events[]{
            [](checking<Device>& it) { // another master
                register_block<1> const shutdown{6};
                it.far().write(Device::layout.cmd, shutdown);
            },
            [](checking<Device>& it) { it.far().press_stop(); },
            [](checking<Device>& it) { // its power was gone, and another master has begun
                it.far().power_cycle(it.now());
                register_block<1> const shutdown{6};
                it.far().write(Device::layout.cmd, shutdown);
            }};
        for (auto const& event : events) {
            INFO("event " << (&event - events));
            unsigned nth = 1;
            for (bool is_read = true; is_read; ++nth) {
                INFO("read " << nth);
                is_read = happens_before<Device>(nth, event);
            }
            CHECK(nth > 8); // the look and the whole check
        }
    });
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The scenes of all drives: what a person can do in any order leaves the motor as the law of motion wants it.
#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <memory>
#include <string>

#include "scene.hpp"
#include "transitions.hpp"

namespace {

using playground::cable;
using rtuwire::altivar::stop_by;

constexpr std::size_t drives = rtuwire::altivar::all_drives::size;

void wait(playground::scene& on, unsigned seconds)
{
    for (unsigned i = 0; i < seconds; ++i) {
        on.run(rtuwire::milliseconds(1'000));
    }
}

bool shows(playground::scene& on, std::string const& part) { return on.state().find(part) != std::string::npos; }

/// A small generator, so that each run presses the same.
class presses {
public:
    unsigned next(unsigned below)
    {
        state_ = state_ * 1'664'525U + 1'013'904'223U;
        return (state_ >> 16U) % below;
    }

private:
    std::uint32_t state_{1};
};

void press(playground::scene& on, presses& from)
{
    switch (from.next(11)) {
    case 0: return on.switch_mains(from.next(4) != 0);
    case 1: return on.cut(static_cast<cable>(from.next(4)));
    case 2: return on.make_fault(from.next(2) != 0);
    case 3: return on.set_local(from.next(2) != 0);
    case 4: return on.press_stop();
    case 5: return on.set_supervised(from.next(2) != 0);
    case 6: return on.start(static_cast<std::int16_t>(from.next(1'400)));
    case 7: return on.change(static_cast<std::int16_t>(from.next(600) - 300));
    case 8: return on.stop(static_cast<stop_by>(from.next(5)));
    case 9: return on.reset_fault();
    default: break;
    }
    std::byte const frame[]{std::byte{1}, std::byte{3}, static_cast<std::byte>(from.next(256)), std::byte{0}};
    on.send(frame);
}

} // namespace

TEST_CASE("a drive whose cable is cut trips, and stands when it is mended")
{
    for (std::size_t place = 0; place < drives; ++place) {
        playground::scene on{playground::make_drive(place)};
        on.switch_mains(true);
        wait(on, 1);
        on.start(300);
        wait(on, 6);
        REQUIRE(shows(on, "\"frequency\":30000"));
        on.cut(cable::cut);
        wait(on, 12);
        CHECK(shows(on, "\"frequency\":0,\"reference\":0"));
        on.cut(cable::whole);
        wait(on, 30);
        CHECK(shows(on, "\"frequency\":0,\"reference\":0"));
        CHECK(shows(on, "\"linked\":true"));
    }
}

TEST_CASE("whatever is pressed, a stop over a whole line ends with a motor that stands")
{
    presses from;
    for (std::size_t place = 0; place < drives; ++place) {
        playground::scene on{playground::make_drive(place)};
        for (unsigned i = 0; i < 150; ++i) {
            press(on, from);
            on.run(rtuwire::milliseconds(from.next(900)));
            CHECK_FALSE(on.frames().list(on.frames().end()).empty());
        }
        on.cut(cable::whole);
        on.switch_mains(true);
        wait(on, 1);
        on.stop(stop_by::ramp);
        wait(on, 40);
        INFO(place << ' ' << on.state());
        CHECK(shows(on, "\"frequency\":0,"));
    }
}

TEST_CASE("the drive's own transitions are those that a simulated drive takes")
{
    auto const all = playground::transitions_of({});
    auto const has = [&](rtuwire::cia402::transition number, rtuwire::cia402::state to) {
        for (auto const& each : all) {
            if (each.number == number and each.to == to) {
                return true;
            }
        }
        return false;
    };
    auto const drive = playground::make_drive(0);
    drive->power_cycle(rtuwire::instant{0});
    CHECK(has(drive->last_transition(), drive->state()));
    drive->advance(rtuwire::instant{1'000});
    CHECK(has(drive->last_transition(), drive->state()));
    drive->inject_fault(9);
    CHECK(has(drive->last_transition(), drive->state()));
    drive->advance(rtuwire::instant{2'000});
    CHECK(drive->state() == rtuwire::cia402::state::fault);
    CHECK(has(drive->last_transition(), drive->state()));
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit that is off beside drives that run: what it costs never lets one of them trip.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using device = atv320::device;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint8_t off = 9;

struct hall : test::simulated_bus<bus<5>, device> {
    std::array<cyclic<device>, 3> loops{cyclic<device>{station<device>{unit_id{1}}},
                                        cyclic<device>{station<device>{unit_id{2}}},
                                        cyclic<device>{station<device>{unit_id{3}}}};
    single_request<read_holding_registers> poll{unit_id{off}, read_holding_registers{3'201, 1}};
    unsigned probes{0};

    hall() : test::simulated_bus<bus<5>, device>{bus<5>{test::bus_timing, patient, {.silent_share = 50}}}
    {
        register_block const one_second{10};
        for (std::uint8_t i = 0; i < 3; ++i) {
            this->add(*unit_id::checked(i + 1U));
            static_cast<void>(this->drive(i).write(6'005, one_second));
        }
        // What is off has a time-out that takes most of theirs.
        this->link().set(4, {.with = {.response_timeout = milliseconds(700), .retries = 0}});
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            probes += is_request and frame[0] == std::byte{off} ? 1U : 0U;
        });
    }
    void pass(duration length)
    {
        this->run(
            [&](instant now) {
                for (std::size_t i = 0; i < loops.size(); ++i) {
                    this->link().converse(i, loops[i], now);
                }
                this->link().converse(4, poll, now);
                if (poll.settled()) {
                    poll.again();
                }
            },
            [] { return false; }, length);
    }
};

} // namespace

TEST_CASE("motion law: S36 a probe of a unit that is off goes out only where no ordered drive trips by it")
{
    hall it;
    it.pass(milliseconds(6'000));
    for (cyclic<device>& each : it.loops) {
        REQUIRE(each.run(1'000_rpm));
    }
    it.pass(milliseconds(2'000));
    it.probes = 0;
    it.pass(milliseconds(60'000));
    for (std::size_t i = 0; i < it.loops.size(); ++i) {
        INFO(i);
        CHECK(it.drive(i).state_machine().state() == state::operation_enabled);
        CHECK(it.loops[i].control().is_ordered());
    }
    CHECK(it.probes == 0);
    // Nothing is ordered any more: it is looked for again.
    for (cyclic<device>& each : it.loops) {
        each.stop();
    }
    it.pass(milliseconds(20'000));
    CHECK(it.probes > 5);
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long requests go to a drive on a bus whose responses get lost: from there on its own time-out runs. Held against what
// docs/what-stops-my-motor.md promises: 2 s + (r + 2) R + G + L behind the first request that has no response.
#include "support/catch.hpp"
#include "support/one_in.hpp"
#include "support/simulated_bus.hpp"

#include <algorithm>
#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr std::uint32_t timeout = 100'000, late = 200'000, period = 100'000, words = 2'000'000;
constexpr std::uint8_t retries = 2;
constexpr client_options policy{
    .response_timeout = microseconds(timeout), .late_response = microseconds(late), .retries = retries};
constexpr unit_id of_drive{3}, of_other{4}, of_silent{5};

/// A cycle and a poll of one drive, a poll of another one, and one of a unit that is off.
struct four_slots : test::simulated_bus<bus<4>, atv320::device> {
    cyclic<atv320::device> loop{station<atv320::device>{of_drive}, {.period = microseconds(period)}};
    single_request<read_holding_registers> poll{of_drive, read_holding_registers{3'202, 1}};
    single_request<read_holding_registers> other{of_other, read_holding_registers{3'202, 1}};
    single_request<read_holding_registers> silent{of_silent, read_holding_registers{3'202, 1}};
    bool is_cut{false};
    instant first{0}; ///< request without a response
    instant last{0};
    bool has_first{false};

    four_slots() : test::simulated_bus<bus<4>, atv320::device>{bus<4>{test::bus_timing, policy}}
    {
        add(of_drive);
        add(of_other);
        disturb([this](test::frame_bytes& frame, bool is_request) {
            bool const is_its_own = not frame.empty() and frame[0] == to_byte(of_drive.byte());
            if (not is_cut or not is_its_own) {
                return;
            }
            if (is_request) {
                first = has_first ? first : now();
                last = now();
                has_first = true;
            } else {
                frame.clear();
            }
        });
    }
    void live(std::uint32_t length)
    {
        for (instant const end = now() + microseconds(length); not reached(now(), end);) {
            step(
                [this](instant at) {
                    link().converse(0, loop, at);
                    std::size_t slot = 0;
                    for (auto* each : {&poll, &other, &silent}) {
                        each->settled() ? each->again() : void();
                        link().converse(++slot, *each, at);
                    }
                },
                milliseconds(10));
        }
    }
};

} // namespace

TEST_CASE("motion law: L4 on a bus requests to a drive that was lost end within the bound that is promised")
{
    constexpr std::uint32_t frames = 50'000;
    std::uint32_t const gap =
        std::max(period, longest_gap_of(4, microseconds(frames), microseconds(timeout * (retries + 1U))).microseconds);
    std::uint32_t longest = 0;
    for (std::uint32_t moment = 0; moment < 60; moment += test::one_in(7)) {
        four_slots it;
        it.live(2'000'000);
        REQUIRE(it.loop.run(600_rpm));
        it.live(2'000'000 + moment * 53'000);
        REQUIRE(it.loop.control().is_running());
        it.is_cut = true;
        it.live(8'000'000);
        REQUIRE(it.has_first);
        std::uint32_t const span = (it.last - it.first).microseconds;
        longest = std::max(longest, span);
        CHECK(span <= words + (retries + 2U) * timeout + gap + late + frames);
    }
    CAPTURE(longest);
    CHECK(longest > words + 2 * timeout); // which was promised before
}

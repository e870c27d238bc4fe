// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One simulated drive at a client, which another master may have left running in either way.
#pragma once

#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/ask/single_request.hpp>

namespace rtuwire::test {

inline constexpr client_options plant_policy{.response_timeout = milliseconds(100), .retries = 1};

/// A start from rest that the drive's limits may change.
inline constexpr duration usual_limit = milliseconds(3'000);
inline constexpr altivar::supervision_options within_limits{.beyond = altivar::beyond_limits::limit};

/// References of a drive in 0.1 Hz and in rpm, by numbers.
template <typename Device> auto tenths(int count)
{
    return *setting<Device::frequency_reference>::checked(signed_decihertz{static_cast<std::int16_t>(count)});
}
template <typename Device> auto speed(int count)
{
    return *setting<Device::speed_reference>::checked(signed_rpm{static_cast<std::int16_t>(count)});
}

/// The lowest and the highest frequency of a motor, in mHz.
struct seen_frequencies {
    std::int32_t lowest;
    std::int32_t highest;

    explicit seen_frequencies(std::int32_t first) : lowest{first}, highest{first} {}
    void add(std::int32_t next)
    {
        lowest = std::min(lowest, next);
        highest = std::max(highest, next);
    }
};

template <typename Device> struct plant : simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};

    plant() : simulated_bus<drive_client<4>, Device>{drive_client<4>{bus_timing, plant_policy}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    std::int32_t millihertz() { return far().motor().frequency(); }

    /// What somebody else writes to the drive.
    void tell(std::uint16_t address, std::uint16_t value)
    {
        single_request told{drive.unit(), write_single_register{address, value}};
        REQUIRE(this->run(told));
        REQUIRE(told.outcome());
    }

    /// Lets the motor run at a frequency as another master may have: its reference has the sign of the frequency, or the
    /// other one while the direction bit is set.
    void turn(std::int32_t hertz, bool by_bit)
    {
        std::uint16_t const bit = by_bit ? altivar::reverse_bit : std::uint16_t{0};
        for (auto const& [address, value] :
             {std::pair{Device::layout.cmd, std::uint16_t{6}}, std::pair{Device::layout.cmd, std::uint16_t{7}},
              std::pair{Device::frequency_reference.address,
                        static_cast<std::uint16_t>((by_bit ? -hertz : hertz) * 10)},
              std::pair{Device::layout.cmd, static_cast<std::uint16_t>(0x000F | bit)}}) {
            tell(address, value);
        }
        this->idle(milliseconds(6'000));
        REQUIRE(millihertz() == hertz * 1'000);
    }

    /// Lets a conversation run for a time, and the motor after it; what the motor did.
    template <typename Conversation> seen_frequencies watch(Conversation& conversation, duration length)
    {
        seen_frequencies seen{millihertz()};
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(
                [&](instant now) {
                    if (not conversation.settled()) {
                        this->link().converse(conversation, now);
                    }
                },
                milliseconds(50));
            seen.add(millihertz());
        }
        return seen;
    }
};

/// Runs a conversation whose requests are all lost from the n-th on, or only the responses; the frequencies of the
/// motor, lowest and highest, from then on. False where the conversation ended before.
template <typename Device, typename Conversation>
bool cut_after(plant<Device>& it, Conversation conversation, unsigned frames, bool only_answers, std::int32_t& lowest,
               std::int32_t& highest)
{
    unsigned passed = 0;
    it.disturb([&](frame_bytes& frame, bool is_request) {
        passed += is_request ? 1 : 0;
        if (passed > frames and is_request != only_answers) {
            frame.clear();
        }
    });
    seen_frequencies const seen = it.watch(conversation, milliseconds(8'000));
    lowest = seen.lowest;
    highest = seen.highest;
    return passed > frames;
}

} // namespace rtuwire::test

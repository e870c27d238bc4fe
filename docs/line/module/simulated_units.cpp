// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "simulated_units.hpp"

#include <bit>

#include <rtuwire/altivar/atv320.hpp>

namespace line_page {

namespace {

using rtuwire::instant;

constexpr rtuwire::unit_id drive_address{1}, meter_address{2};

/// Back and forth between 0 and 1, in so many seconds.
float wave(microseconds now, std::uint32_t seconds)
{
    auto const part = static_cast<float>(now % (seconds * 1'000'000ULL)) / (static_cast<float>(seconds) * 1e6F);
    float const up = part < 0.5F ? 2 * part : 2 - 2 * part;
    return up * up * (3 - 2 * up);
}

rtuwire::line_timing timing_of(line_setting how) { return {how.baud, how.format}; }

} // namespace

simulated_meter::simulated_meter(rtuwire::line_timing const& timing, instant now) : node_{meter_address, timing}
{
    node_.advance(now);
}

void simulated_meter::set(std::uint16_t address, float value)
{
    auto const bits = std::bit_cast<std::uint32_t>(value);
    static_cast<void>(bank_.values.set(address, static_cast<std::uint16_t>(bits >> 16U)));
    static_cast<void>(bank_.values.set(static_cast<std::uint16_t>(address + 1), static_cast<std::uint16_t>(bits)));
}

rtuwire::byte_view simulated_meter::pass(microseconds now)
{
    constexpr std::uint16_t voltage = 0, current = 6, power = 12, total_power = 52, frequency = 70, energy = 72;
    float total = 0;
    for (std::uint16_t phase = 0; phase < 3; ++phase) {
        auto const at = static_cast<std::uint16_t>(2 * phase);
        float const volts = 229 + 3 * wave(now, 17U + phase * 5U), amperes = 2 + 4 * wave(now, 23U + phase * 7U);
        set(voltage + at, volts);
        set(current + at, amperes);
        set(power + at, volts * amperes);
        total += volts * amperes;
    }
    set(total_power, total);
    set(frequency, 49.95F + 0.1F * wave(now, 11));
    set(energy, 1234.5F + static_cast<float>(now / 1'000'000U) / 600);
    node_.advance(instant_of(now));
    node_.serve(bank_, instant_of(now));
    rtuwire::byte_view const frame = node_.poll_transmit();
    if (not frame.empty()) {
        node_.sent(instant_of(now));
    }
    return frame;
}

struct simulated_units::drive {
    drive(rtuwire::line_timing const& timing, instant now) : unit{drive_address, timing, now} {}

    rtuwire::sim::unit<rtuwire::altivar::atv320::device> unit;
};

simulated_units::simulated_units(line_setting how, microseconds now)
    : drive_{std::make_unique<drive>(timing_of(how), instant_of(now))}, meter_{timing_of(how), instant_of(now)}
{
    drive_->unit.drive().power_cycle(instant_of(now));
    drive_->unit.advance(instant_of(now));
}

simulated_units::~simulated_units() = default;

void simulated_units::receive(rtuwire::byte_view bytes, microseconds now)
{
    drive_->unit.receive(bytes, instant_of(now));
    meter_.receive(bytes, instant_of(now));
}

rtuwire::byte_view simulated_units::pass(microseconds now)
{
    drive_->unit.advance(instant_of(now));
    rtuwire::byte_view const said = drive_->unit.poll_transmit();
    output_.assign(said.begin(), said.end());
    if (not said.empty()) {
        drive_->unit.sent(instant_of(now));
    }
    rtuwire::byte_view const measured = meter_.pass(now);
    output_.insert(output_.end(), measured.begin(), measured.end());
    return output_;
}

} // namespace line_page

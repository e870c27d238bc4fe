// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The conversations of a life. One place holds one after the other, in the same memory.
#pragma once

#include <cstdint>
#include <variant>

#include "lives/setting.hpp"

#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

namespace rtuwire::lives {

using namespace detail;

namespace a = altivar;

using poll = single_request<read_holding_registers>;
using freewheel = a::freewheel_request;

/// The usual words of two scanners.
using scanner_of_atv320 = a::configure_scanner<a::scanner_inputs<a::atv320::eta, a::atv320::rfrd>,
                                               a::scanner_outputs<a::atv320::cmd, a::atv320::lfrd>>;
using scanner_of_atv12 = a::configure_scanner<a::scanner_inputs<a::atv12::eta, a::atv12::rfrd>,
                                              a::scanner_outputs<a::atv12::cmd, a::atv12::lfrd>>;

using conversation =
    std::variant<std::monostate, a::start, a::stop, a::change_reference, a::reset_fault, a::save_to_eeprom,
                 scanner_of_atv320, scanner_of_atv12, poll, freewheel, a::atv28::direct_start,
                 a::cyclic<a::atv310::device>, a::cyclic<a::atv310::device_2026>, a::cyclic<a::atv320::device>,
                 a::cyclic<a::atv12::device>, a::cyclic<a::atv28::device>>;

template <typename T> inline constexpr bool is_cyclic = false;
template <typename Device> inline constexpr bool is_cyclic<a::cyclic<Device>> = true;
template <typename T>
inline constexpr bool is_start = std::is_same_v<T, a::start> or std::is_same_v<T, a::atv28::direct_start>;

template <typename Device> station<Device> station_of(drive_setting const& set)
{
    return *station<Device>::checked(set.address);
}

/// A stop of all drives of a life.
using everyone = std::variant<std::monostate, a::broadcast_stop<1>, a::broadcast_stop<2>>;

/// HSP of each drive, as delivered.
inline constexpr int highest_half_hertz = 100;

/// What an order asks for: a frequency in half hertz, and its direction, which 0 has, too.
struct asked_motion {
    int half_hertz{0};
    bool is_reverse{false};

    int signed_half_hertz() const { return is_reverse ? -half_hertz : half_hertz; }
    a::run_direction direction() const { return is_reverse ? a::run_direction::reverse : a::run_direction::forward; }
};

/// With its sign, which 0 has none of.
template <typename Device> a::reference<Device> reference_of(asked_motion asked)
{
    using hertz_setting = rtuwire::setting<Device::frequency_reference>;
    auto const count = static_cast<std::int16_t>(asked.signed_half_hertz() * 5);
    return hertz_setting::clamped(signed_decihertz{count});
}

/// What somebody takes upon himself who orders a drive that would run on without its line.
inline a::supervision_options risks_of(drive_setting const& set)
{
    a::supervision_options options;
    options.risks.accept_unsupervised = set.is_link_ignored;
    options.risks.accept_running_on = set.is_link_ignored;
    return options;
}

/// How a start is made; here alone.
template <typename Device> a::start make_start(drive_setting const& set, asked_motion asked, duration limit)
{
    return a::start{station_of<Device>(set), reference_of<Device>({asked.half_hertz}), asked.direction(), limit,
                    risks_of(set)};
}

/// How a cycle is made; here alone.
template <typename Device> a::cyclic<Device> make_cycle(drive_setting const& set, detail::random_source& chance)
{
    a::cyclic_options const options{.period = milliseconds(40 + chance.below(160)),
                                    .supervision = risks_of(set),
                                    .tolerated_misses = static_cast<std::uint8_t>(chance.below(2)),
                                    .by_function_23 = chance.below(4) != 0};
    return a::cyclic<Device>{station_of<Device>(set), options};
}

/// Orders a cycle to run; whether it was taken.
template <typename Device> bool run_cycle(a::cyclic<Device>& loop, asked_motion asked)
{
    using reference = rtuwire::setting<a::cycle_layout<Device>::reference>;
    constexpr int steps = a::cycle_layout<Device>::has_scanner ? 15 : 5;
    auto const count = static_cast<std::int16_t>(asked.half_hertz * steps);
    return loop.run(reference::clamped(typename reference::value_type{count}), asked.direction());
}

} // namespace rtuwire::lives

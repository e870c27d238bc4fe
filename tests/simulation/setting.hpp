// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What one simulated line is like: everything that may differ from life to life, drawn from one seed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/sim/line/line_faults.hpp>

#include "frames.hpp"

namespace rtuwire::simulation {

using namespace detail;

/// Which lives are wanted.
enum class choice : std::uint8_t {
    any,
    constant, ///< default options, one unit, always 1.005 to 1.9 s
};

/// How long a unit takes, from the moment it could begin to the first character of its response.
struct latency_law {
    moment least{0};
    moment most{0};
};

struct unit_setting {
    latency_law latency{};
    bool is_dead{false};
    bool waits_for_silence{true};  ///< before it sends; another sends into whatever there is
    bool forgets_when_busy{false}; ///< drops requests that come while it works on one
};

struct setting {
    static constexpr unsigned most_units = 4;
    static constexpr unsigned most_servers = 2;
    static constexpr unsigned most_conversations = 4;

    std::uint32_t seed{1};
    std::uint32_t bits_per_second{19'200};
    character_format format{character_format::even_8_1};
    bool is_host{false};
    bool is_bus{false};
    bool measures_share{false};       ///< a bus with dead units and nothing else wrong
    bool has_constant_latency{false}; ///< which a rule of time covers even where it is longer
    bool has_line_echo{false};
    client_options options{};
    std::uint32_t clock_start{0};

    unsigned units{1};
    unsigned servers{0};
    unsigned conversations{1};
    std::array<unit_setting, most_units> unit{};
    std::array<bool, most_servers> server_is_host{};

    // Chances in a million.
    std::uint32_t request_lost{0};
    std::uint32_t response_lost{0};
    std::uint32_t missed_by_one{0}; ///< a frame that one listener misses
    std::uint32_t damaged{0};
    std::uint32_t refuses_busy{0}; ///< exceptions 05, 06
    std::uint32_t refuses{0};      ///< other exceptions
    std::uint32_t sent_late{0};
    std::uint32_t sent_never{0};
    std::uint32_t cancels{0};
    std::uint32_t misuses{0}; ///< conversations destroyed, moved, begun again, away
    std::uint32_t served_late{0};
    std::uint32_t server_sent_missed{0};
    std::uint32_t noise{0}; ///< a burst from a transmitter that is no unit's

    moment sent_late_most{0};
    moment pass_late_most{0};  ///< how late the client's loop comes round
    moment adapter_latency{0}; ///< a host gets characters in lumps
    moment gap_most{0};        ///< and with gaps between the lumps
    bool is_late_in_lumps{false};

    /// Every other client of a host takes the times of one behind a USB adapter, which lets no fast line rest.
    bool has_usb_times() const { return is_host and seed % 2U == 0; }
    bool lets_line_rest() const { return not has_usb_times() or bits_per_second <= 38'400; }

    moment response_timeout() const { return options.response_timeout.microseconds; }
    moment late_response() const { return options.late_response.microseconds; }

    /// The longest that a debt may hold up a request, and then the request itself, roughly.
    moment longest_wait() const
    {
        moment const retry_state = options.retries + 1U;
        moment const pauses = 3U * 400'000U;
        moment const transaction = retry_state * (response_timeout() + 1'000'000) + pauses + sent_late_most;
        return retry_state * (transaction + late_response()) + 2 * transaction;
    }
};

inline line_timing timing_of(setting const& how, bool is_host)
{
    return is_host ? line_timing::host(how.bits_per_second, how.format) : line_timing{how.bits_per_second, how.format};
}

inline line_timing client_timing_of(setting const& how)
{
    return how.has_usb_times() ? line_timing::usb(how.bits_per_second, how.format) : timing_of(how, how.is_host);
}

inline setting setting_of(std::uint32_t seed, choice wanted)
{
    detail::random_source random_source{seed};
    auto const between = [&](std::uint32_t least, std::uint32_t most) {
        return least + random_source.below(most - least + 1);
    };
    auto const chance = [&](unsigned percent) { return random_source.below(100) < percent; };
    auto const stretch = [&](double least, double most) { // as often near one end as near the other
        return least * std::pow(most / least, random_source.below(1'000'000) / 1e6);
    };
    auto const rate = [&](unsigned percent, std::uint32_t most) {
        return chance(percent) ? random_source.below(most) : 0U;
    };

    setting all;
    all.seed = seed;
    constexpr std::uint32_t speeds[] = {9'600, 19'200, 19'200, 38'400, 115'200};
    all.bits_per_second = speeds[random_source.below(5)];
    all.format = chance(30) ? character_format::none_8_1 : character_format::even_8_1;
    all.clock_start = random_source.next();
    all.is_host = chance(35);
    all.is_bus = chance(30);
    all.has_line_echo = not all.is_host and chance(15);
    if (not chance(30)) { // otherwise what a user gets who says nothing
        auto const timeout = static_cast<std::uint32_t>(stretch(50'000, 1'000'000));
        all.options.response_timeout = microseconds(timeout);
        all.options.late_response = microseconds(static_cast<std::uint32_t>(timeout * stretch(0.02, 2)));
        all.options.retries = static_cast<std::uint8_t>(random_source.below(4));
        all.options.turnaround = milliseconds(between(5, 200));
    }
    all.options.has_line_echo = all.has_line_echo;
    double const timeout = double(all.response_timeout());

    all.units = between(1, setting::most_units);
    all.servers = chance(40) ? between(1, setting::most_servers) : 0U;
    all.conversations = chance(40) ? 1U : between(2, setting::most_conversations);
    for (unit_setting& each : all.unit) {
        auto const some = [&](double least, double most) {
            return static_cast<moment>(timeout * stretch(least, most));
        };
        moment const one = chance(50) ? some(1, 1 + 1.2 * double(all.late_response()) / timeout) : some(0.1, 3);
        switch (random_source.below(4)) {
        case 0: each.latency = {500, 5'000}; break;
        case 1: each.latency = {one, one}; break;
        case 2: each.latency = {one / 2, one}; break;
        default: each.latency = {500, some(0.5, 2)}; break;
        }
        each.is_dead = chance(8);
        each.waits_for_silence = chance(60);
        each.forgets_when_busy = chance(15);
    }
    for (bool& is_host : all.server_is_host) {
        is_host = chance(50);
    }

    all.request_lost = rate(40, 100'000);
    all.response_lost = rate(40, 100'000);
    all.missed_by_one = rate(20, 50'000);
    all.damaged = rate(30, 50'000);
    all.refuses_busy = rate(25, 200'000);
    all.refuses = rate(25, 100'000);
    all.sent_late = rate(25, 200'000);
    all.sent_never = rate(15, 20'000);
    all.cancels = rate(30, 300'000);
    all.misuses = rate(40, 400'000);
    all.served_late = rate(50, 200'000);
    all.server_sent_missed = rate(15, 20'000);
    all.noise = rate(15, 50'000);
    all.sent_late_most = static_cast<moment>(timeout * stretch(0.001, 0.5));
    all.pass_late_most = chance(25) ? static_cast<moment>(stretch(100, 20'000)) : 0U;
    all.is_late_in_lumps = chance(50);
    if (all.is_host) {
        all.adapter_latency = between(1'000, 16'000);
        all.gap_most = chance(50) ? between(16'000, 48'000) : 0U;
    }

    if (wanted == choice::constant) {
        setting count16;
        count16.seed = all.seed;
        count16.clock_start = all.clock_start;
        auto const one = static_cast<moment>(between(1'005'000, 1'900'000));
        count16.unit[0].latency = {one, one};
        count16.has_constant_latency = true;
        return count16;
    }
    if (all.is_bus and chance(5)) {
        setting calm;
        calm.seed = all.seed;
        calm.bits_per_second = all.bits_per_second;
        calm.format = all.format;
        calm.clock_start = all.clock_start;
        calm.options = all.options;
        calm.options.has_line_echo = false;
        calm.is_bus = true;
        calm.measures_share = true;
        calm.units = calm.conversations = setting::most_units;
        unsigned const dead = between(1, setting::most_units - 1);
        for (unsigned i = 0; i < setting::most_units; ++i) {
            calm.unit[i].is_dead = i < dead;
            calm.unit[i].latency = {500, 5'000};
        }
        return calm;
    }
    return all;
}

} // namespace rtuwire::simulation

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a life is like, from its seed.
#pragma once

#include <array>
#include <cstdint>

#include "lives/far_drive.hpp"

#include <rtuwire/client/needs.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/sim/line/line_faults.hpp>

namespace rtuwire::lives {

inline constexpr std::size_t most_drives = 2;

/// How a life ends.
enum class last_part : unsigned {
    controller_dies,
    each_is_stopped,
    everyone_is_stopped,
    answers_get_lost,
    requests_get_lost,
    motors_are_left,
    goes_on,
    count,
};

struct life_setting {
    std::uint32_t seed{0};
    bool is_bus{true};
    bool is_blocking{false};     ///< a client that waits, of one drive
    bool is_unsupervised{false}; ///< one of its drives is: only with the risk accepted
    bool is_event_driven{false}; ///< its drives sleep by their deadlines while the controller does
    std::size_t drives{1};
    std::array<drive_setting, most_drives> drive{};
    std::uint32_t bits_per_second{19'200};
    client_options options{};
    std::uint32_t late_in_a_million{0};
    std::uint32_t in_parts_in_a_million{0}; ///< responses that the receiver does not give whole and at once
    std::uint32_t start_count{0};           ///< of the clock
    unsigned moments{12};
    last_part end{last_part::goes_on};

    line_timing timing() const { return line_timing{bits_per_second, character_format::even_8_1}; }
    /// A late response comes before its unit is asked anew.
    std::uint32_t longest_lateness() const
    {
        return options.response_timeout.microseconds + options.late_response.microseconds - 20'000;
    }
};

inline drive_setting drive_of(detail::random_source& chance, std::uint8_t address, bool is_unsupervised)
{
    constexpr std::array<std::uint16_t, 5> trips{1, 1, 2, 6, 7};
    constexpr std::array<std::uint16_t, 3> runs_on{0, 4, 5};
    constexpr std::array<std::uint16_t, 8> times{1, 5, 10, 20, 30, 50, 100, 300};
    drive_setting set;
    set.which = static_cast<model>(chance.below(static_cast<std::uint32_t>(model::count)));
    set.address = address;
    set.sll = is_unsupervised ? runs_on[chance.below(3)] : trips[chance.below(5)];
    set.is_link_ignored = is_unsupervised;
    set.tto = chance.below(3) == 0 ? static_cast<std::uint16_t>(1 + chance.below(300)) : times[chance.below(8)];
    set.ramp = static_cast<std::uint16_t>(chance.below(4) == 0 ? 30 : 1 + chance.below(10));
    bool const has_lsp = chance.below(2) == 0;
    set.lsp = static_cast<std::uint16_t>(has_lsp ? 1 + chance.below(200) : 0);
    set.called = set.which;
    if (set.which == model::atv320 and chance.below(8) == 0) {
        constexpr std::array<model, 4> names{model::atv320, model::atv12, model::atv310_2014, model::atv310_2026};
        set.is_io = true;
        set.lsp = static_cast<std::uint16_t>(50 + chance.below(100)); // it turns by bit 0 alone
        set.called = names[chance.below(4)];
    }
    return set;
}

inline life_setting setting_of(std::uint32_t seed)
{
    detail::random_source chance{seed * 2'654'435'761U + 17U};
    constexpr std::array<std::uint32_t, 4> rates{9'600, 19'200, 19'200, 115'200};
    constexpr std::array<std::uint32_t, 4> retry_policy_ms{40, 100, 100, 300};
    life_setting how;
    how.seed = seed;
    how.is_bus = chance.below(2) == 0;
    how.is_unsupervised = chance.below(10) == 0;
    how.drives = 1 + chance.below(most_drives);
    for (std::size_t i = 0; i < how.drives; ++i) {
        how.drive[i] = drive_of(chance, static_cast<std::uint8_t>(3 + i), how.is_unsupervised);
    }
    how.bits_per_second = rates[chance.below(4)];
    how.options.response_timeout = milliseconds(retry_policy_ms[chance.below(4)]);
    how.options.retries = static_cast<std::uint8_t>(chance.below(3));
    how.late_in_a_million = chance.below(4) == 0 ? 50'000 : 0;
    bool const wraps = chance.below(4) == 0;
    how.start_count = wraps ? 0U - chance.below(8'000'000) : chance.next();
    how.moments = 6 + chance.below(12);
    how.is_event_driven = chance.below(2) == 0;
    auto const end = static_cast<last_part>(chance.below(static_cast<std::uint32_t>(last_part::count) + 1));
    how.end = end == last_part::count ? last_part::motors_are_left : end; // the one with the most ways
    how.is_blocking = chance.below(8) == 0;
    how.drives = how.is_blocking ? 1 : how.drives;
    how.in_parts_in_a_million = chance.below(3) == 0 ? 30'000 : 0;
    return how;
}

} // namespace rtuwire::lives

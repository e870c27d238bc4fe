// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Between which speeds a drive turns its motor, as it was read (LSP and HSP), and whether a reference is within them. A
// drive takes any reference and limits it: the motor then turns at another speed than was ordered. It knows no requests.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What becomes of a reference above HSP, or below LSP of a motor at rest.
enum class beyond_limits : std::uint8_t {
    refuse, ///< no word is sent: `above_hsp`, `below_lsp`, or `unknown_register` where the drive does not tell its limits
    limit, ///< it is sent without a look at these: the motor turns at HSP or LSP, `reference_limited`
};

/// The limits of one drive.
struct reference_limits {
    static constexpr std::uint16_t unread = 0xFFFF;

    // Two words, else a copy is a call of memcpy.
    alignas(4) std::uint16_t lowest{0}; ///< LSP, 0.1 Hz; 0 where it was not read
    std::uint16_t highest{unread};      ///< HSP, 0.1 Hz
    std::uint16_t per_hertz{0};         ///< what 1 Hz is in rpm, times `pairs`; 0 where it was not read
    std::uint16_t pairs{1};             ///< of the motor's poles, as the drive counts them

    /// `above_hsp`, `below_lsp`, or `succeeded`. A motor that turns slows down to any reference. In rpm the highest
    /// counts rounded up, the lowest rounded down; any speed is right where only the frequencies were read.
    [[nodiscard]] constexpr outcome_kind judge(reference_write what, bool is_at_rest) const noexcept
    {
        // Both sides times `step`: so nothing is divided.
        std::uint32_t const size = what.size(), step = what.is_speed ? 10U * pairs : 1U,
                            scale = what.is_speed ? per_hertz : 1U;
        bool const has_scale = scale != 0 and highest != unread;
        if (has_scale and size * step >= highest * scale + step) {
            return outcome_kind::above_hsp;
        }
        return is_at_rest and (size + 1) * step <= lowest * scale ? outcome_kind::below_lsp : outcome_kind::succeeded;
    }

    /// The limit that such an outcome names.
    [[nodiscard]] constexpr std::uint16_t named_by(outcome_kind found) const noexcept
    {
        return found == outcome_kind::above_hsp   ? highest
               : found == outcome_kind::below_lsp ? lowest
                                                  : std::uint16_t{0};
    }

    /// Those that refuse no reference. What a hertz is stays.
    [[nodiscard]] constexpr reference_limits without_frequencies() const noexcept
    {
        return {0, unread, per_hertz, pairs};
    }

    /// Whether what a drive was told for a reference is another speed, and nobody knows by how many of its steps.
    [[nodiscard]] constexpr bool is_guessed(reference_write told, reference_write asked) const noexcept
    {
        return told.is_speed and per_hertz == 0 and told.size() > asked.size();
    }

    /// The limit that a drive keeps to which says that it limits a reference: the nearer one. 0 where what was read does not tell.
    [[nodiscard]] constexpr std::uint16_t kept_for(reference_write told) const noexcept
    {
        std::uint32_t const scale = told.is_speed ? per_hertz : 1U, step = told.is_speed ? 10U * pairs : 1U;
        bool const is_told = highest != unread and scale != 0;
        bool const is_above = 2U * told.size() * step > (std::uint32_t{highest} + lowest) * scale;
        return not is_told ? std::uint16_t{0} : is_above ? highest : lowest;
    }

    /// The fewest rpm that are 0.1 Hz; where what a hertz is was not read, as of a motor with one pair of poles.
    [[nodiscard]] constexpr std::uint16_t least_speed() const noexcept
    {
        std::uint32_t const scale = per_hertz == 0 ? 60U : per_hertz;
        std::uint16_t least = 0;
        for (std::uint32_t counted = 0; counted < scale; counted += 10U * pairs) { // nothing is divided
            ++least;
        }
        return least;
    }

    /// The word of a reference, with its sign in the drive's steps, too.
    [[nodiscard, gnu::noinline]] constexpr std::uint16_t signed_for_drive(reference_write what) const noexcept
    {
        return what.at_least(least_speed()).word;
    }

    /// Takes what a hertz is in rpm: FRS and NSP give the pairs of poles, as the drive counts them; without FRS (0) it is
    /// SDS. False where the drive does not tell: NSP or SDS is 0, or there are more pairs of poles than any motor has.
    constexpr bool note_scale(std::uint16_t frs, std::uint16_t speed) noexcept
    {
        constexpr std::uint16_t most_pairs = 100;
        per_hertz = frs == 0 ? speed : 60;
        pairs = 1;
        for (std::uint32_t counted = frs * 6U + speed / 2U; counted >= 2U * speed and pairs <= most_pairs;
             counted -= speed) {
            ++pairs;
        }
        return speed != 0 and pairs <= most_pairs;
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

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

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// What becomes of a reference above HSP, or below LSP of a motor at rest.
enum class beyond_limits : std::uint8_t {
    refuse, ///< no word is sent: `above_hsp`, `below_lsp`, or `unknown_register` where the drive does not tell its limits
    limit, ///< it is sent without a look at them: the motor turns at HSP or LSP, `reference_limited`
};

/// The limits of one drive.
struct reference_limits {
    static constexpr std::uint16_t unread = 0xFFFF;

    std::uint16_t lowest{0};       ///< LSP, 0.1 Hz; 0 where it was not read
    std::uint16_t highest{unread}; ///< HSP, 0.1 Hz
    std::uint16_t lowest_speed{0}; ///< the same in rpm, rounded down; by the motor's poles as the drive counts them
    std::uint16_t highest_speed{unread}; ///< rounded up

    /// `above_hsp`, `below_lsp`, or `succeeded`. A motor that turns slows down to any reference.
    [[nodiscard]] constexpr outcome_kind judge(reference_write what, bool is_at_rest) const noexcept
    {
        std::uint16_t const size = what.size();
        if (size > (what.is_speed ? highest_speed : highest)) {
            return outcome_kind::above_hsp;
        }
        bool const is_below = is_at_rest and size < (what.is_speed ? lowest_speed : lowest);
        return is_below ? outcome_kind::below_lsp : outcome_kind::succeeded;
    }

    /// The limit that such an outcome names.
    [[nodiscard]] constexpr std::uint16_t named_by(outcome_kind found) const noexcept
    {
        return found == outcome_kind::above_hsp   ? highest
               : found == outcome_kind::below_lsp ? lowest
                                                  : std::uint16_t{0};
    }

    /// Takes what a hertz is in rpm, behind the frequencies: FRS and NSP give the pairs of poles, as the drive counts
    /// them; without FRS (0) it is SDS. False where the drive does not tell: NSP or SDS is 0.
    constexpr bool note_scale(std::uint16_t frs, std::uint16_t speed) noexcept
    {
        if (speed == 0) {
            return false;
        }
        std::uint32_t const counted = (std::uint32_t{frs} * 6 + speed / 2U) / speed;
        std::uint32_t const per_hertz = frs == 0 ? speed : 60, tenths = 10U * (frs == 0 or counted == 0 ? 1 : counted);
        lowest_speed = narrowed(lowest * per_hertz / tenths);
        highest_speed = highest == unread ? unread : narrowed((highest * per_hertz + tenths - 1) / tenths);
        return true;
    }

private:
    static constexpr std::uint16_t narrowed(std::uint32_t speed) noexcept
    {
        return speed < unread ? static_cast<std::uint16_t>(speed) : unread;
    }
};

} // namespace rtuwire::altivar

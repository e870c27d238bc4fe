// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What writes depend on beside their own register: the count of a ramp means nothing without the size of its steps, and
// LSP <= HSP <= TFR holds between any two writes.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The words of TFR, HSP, LSP, INR and INTP: what the drive holds of them, and what it shall hold.
class write_dependences {
public:
    /// Which of them a mnemonic is; `none` of another.
    [[nodiscard]] static constexpr std::size_t place_of(literal code) noexcept
    {
        std::size_t at = 0;
        while (at < none and codes[at] != code) {
            ++at;
        }
        return at;
    }
    static constexpr std::size_t tfr = 0, hsp = 1, lsp = 2, none = 5;

    /// A word that the restore wants; of a limit only where it may write it.
    constexpr void note_wanted(literal code, std::uint16_t word) noexcept
    {
        if (std::size_t const at = place_of(code); at < none) {
            wanted_[at] = word;
        }
    }

    /// The restore does not write a parameter that counts in the steps of this one: those must stay as they are.
    constexpr void note_left_alone(literal steps_set_by) noexcept
    {
        if (std::size_t const at = place_of(steps_set_by); at < none) {
            is_bound_[at] = true;
        }
    }

    /// What was read last, or written; empty where that is not known any more.
    constexpr void note_held(literal code, std::optional<std::uint16_t> word) noexcept
    {
        if (std::size_t const at = place_of(code); at < none) {
            held_[at] = word;
        }
    }

    /// Why a parameter must not be written; `planned` where nothing is in the way. `is_now` says that it is to be written
    /// now, beside what the drive holds of the others at this moment.
    [[nodiscard]] constexpr restore_outcome judge(parameter const& row, std::uint16_t held, std::uint16_t wanted,
                                                  bool is_now) const noexcept
    {
        std::size_t const at = place_of(row.code);
        bool const is_bound = at < none and is_bound_[at] and held != wanted;
        if (is_bound or (row.steps_set_by.size() != 0 and not has_steps(row.steps_set_by))) {
            return restore_outcome::other_steps;
        }
        bool const is_limit = at <= lsp and held != wanted;
        return is_limit and not(limits_fit() and (not is_now or are_in_order(with(at, wanted))))
                   ? restore_outcome::out_of_limits
                   : restore_outcome::planned;
    }

    /// Whether LSP <= HSP <= TFR holds once all is written.
    [[nodiscard]] constexpr bool limits_fit() const noexcept { return are_in_order(goal()); }

private:
    using words = std::array<std::optional<std::uint16_t>, none>;

    static constexpr std::array<literal, none> codes{"TFR", "HSP", "LSP", "INR", "INTP"};

    /// Whether the drive counts as the configuration does.
    [[nodiscard]] constexpr bool has_steps(literal code) const noexcept
    {
        std::size_t const at = place_of(code);
        return at < none and held_[at].has_value() and held_[at] == wanted_[at];
    }

    [[nodiscard]] constexpr words with(std::size_t at, std::uint16_t word) const noexcept
    {
        words all = held_;
        all[at] = word;
        return all;
    }

    /// What the drive holds in the end.
    [[nodiscard]] constexpr words goal() const noexcept
    {
        words all = held_;
        for (std::size_t at = tfr; at <= lsp; ++at) {
            all[at] = wanted_[at].has_value() ? wanted_[at] : held_[at];
        }
        return all;
    }

    static constexpr bool are_in_order(words const& all) noexcept
    {
        auto const fits = [&](std::size_t lower, std::size_t upper) {
            return not all[lower].has_value() or not all[upper].has_value() or *all[lower] <= *all[upper];
        };
        return fits(lsp, hsp) and fits(hsp, tfr) and fits(lsp, tfr);
    }

    words held_{};
    words wanted_{};
    std::array<bool, none> is_bound_{};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

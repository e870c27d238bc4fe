// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a client keeps what it knows of the units whose motors it commands. Events are ordered by stamps, which count
// up.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client/line/used_places.hpp>
#include <rtuwire/core/filled.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How the stop under way holds a unit.
enum class hold : std::uint8_t {
    by_its_stop,
    by_another_stop, ///< a stop whose unit had no place when this unit got one
    is_over,         ///< that stop has ended
};

/// What is known of one unit. All zero where nothing is known, so that a `constinit` client lives in .bss; the times
/// are written before they are read.
struct unit_order {
    instant words_end;
    instant silence_end;
    duration silence;
    std::uint32_t last_stop;  ///< the stamp of the last stop or loss
    std::uint32_t last_order; ///< of the last order to run; 0: none
    std::uint32_t last_fault; ///< of the last time that it was read in fault
    std::uint32_t rearranged; ///< of the last request that rearranged it
    std::uint32_t holder;     ///< of the stop under way; 0: none
    std::uint8_t unit;        ///< 0: a free place
    std::uint8_t misses;      ///< missing responses in a row
    std::uint8_t tolerated;
    bool is_ordered;
    bool is_lost;
    bool was_lost;    ///< the last stop was a loss
    bool may_be_told; ///< while it is lost: stop requests may still be sent
    hold held;
};
inline constexpr unit_order nothing_known{
    instant{0}, instant{0}, duration{}, 0, 0, 0, 0, 0, 0, 0, 0, false, false, false, false, hold::by_its_stop};

/// Whether an event came before another one.
[[nodiscard]] constexpr bool is_older(std::uint32_t stamp, std::uint32_t than) noexcept
{
    return static_cast<std::int32_t>(stamp - than) < 0;
}

/// Places for `Units` units, and one entry for all others together.
template <std::size_t Units> class order_places {
public:
    /// The unit's place; null where it has none.
    [[nodiscard]] constexpr unit_order* find(std::uint8_t unit) noexcept
    {
        std::size_t const at = index_of(unit);
        return at < Units ? &places_[at] : nullptr;
    }
    [[nodiscard]] constexpr unit_order const* find(std::uint8_t unit) const noexcept
    {
        std::size_t const at = index_of(unit);
        return at < Units ? &places_[at] : nullptr;
    }

    /// The same, or the entry of all units without a place: the latest stamp of each kind.
    [[nodiscard]] constexpr unit_order const& of(std::uint8_t unit) const noexcept
    {
        unit_order const* const own = find(unit);
        return own == nullptr ? others_ : *own;
    }
    [[nodiscard]] constexpr unit_order& others() noexcept { return others_; }

    /// Whether the unit neither has a place nor can get one.
    [[nodiscard]] constexpr bool is_full_for(std::uint8_t unit) const noexcept
    {
        return find(unit) == nullptr and free_place() == Units;
    }

    /// The unit's place, or a new one; null where there is none.
    [[nodiscard]] constexpr unit_order* make(std::uint8_t unit) noexcept
    {
        if (unit_order* const own = find(unit)) {
            return own;
        }
        std::size_t const at = free_place();
        if (at == Units) {
            return nullptr;
        }
        used_.set(Units - at > used_.count() ? Units - at : used_.count());
        forget(places_[at]);
        places_[at] = others_;
        places_[at].unit = unit;
        places_[at].held = others_.held == hold::by_its_stop ? hold::by_another_stop : others_.held;
        return &places_[at];
    }

    /// Those that were ever in use.
    [[nodiscard]] constexpr auto begin() noexcept { return places_.begin() + first_used(); }
    [[nodiscard]] constexpr auto end() noexcept { return places_.end(); }
    [[nodiscard]] constexpr auto begin() const noexcept { return places_.begin() + first_used(); }
    [[nodiscard]] constexpr auto end() const noexcept { return places_.end(); }

private:
    /// They are taken into use from the last one on.
    constexpr std::ptrdiff_t first_used() const noexcept { return static_cast<std::ptrdiff_t>(Units - used_.count()); }

    constexpr std::size_t index_of(std::uint8_t unit) const noexcept
    {
        std::size_t at = Units - used_.count();
        while (at < Units and (places_[at].unit != unit or unit == 0)) {
            ++at;
        }
        return at;
    }

    /// A place that is free, or whose unit is neither ordered, held nor lost; `Units` where there is none.
    constexpr std::size_t free_place() const noexcept
    {
        std::size_t const first = Units - used_.count();
        if (first != 0) {
            return first - 1;
        }
        std::size_t found = Units;
        for (std::size_t i = Units; i-- > 0;) {
            unit_order const& each = places_[i];
            if (each.unit == 0) {
                return i;
            }
            found = each.is_ordered or each.is_lost or each.holder != 0 ? found : i;
        }
        return found;
    }

    /// Of a unit that loses its place only the stamps are kept; they count for all units without a place.
    constexpr void forget(unit_order const& known) noexcept
    {
        others_.last_stop = later(others_.last_stop, known.last_stop);
        others_.last_fault = later(others_.last_fault, known.last_fault);
        others_.rearranged = later(others_.rearranged, known.rearranged);
    }
    static constexpr std::uint32_t later(std::uint32_t one, std::uint32_t other) noexcept
    {
        return is_older(one, other) ? other : one;
    }

    std::array<unit_order, Units> places_{filled<Units>(nothing_known)};
    unit_order others_{nothing_known};
    [[no_unique_address]] used_places<Units> used_{};
};

} // namespace rtuwire

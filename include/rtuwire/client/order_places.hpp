// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a client keeps what it knows of the units whose motors it commands (ask/unit_order.hpp), and of a stop of all of them.
// A file beside client/orders.hpp, which says what follows from it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/unit_order.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// How many of `Size` places are in use, so that nobody looks at the others. The only place of one counts as used, which takes
/// no memory.
template <std::size_t Size> class used_places {
public:
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
    constexpr void set(std::size_t count) noexcept { count_ = count; }

private:
    std::size_t count_{0};
};
template <> class used_places<1> {
public:
    [[nodiscard]] static constexpr std::size_t count() noexcept { return 1; }
    static constexpr void set(std::size_t) noexcept {}
};

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
    [[nodiscard]] constexpr unit_order& entry_of(std::uint8_t unit) noexcept
    {
        unit_order* const own = find(unit);
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

    /// The same, or the entry of all units without a place.
    [[nodiscard]] constexpr unit_order& make_entry(std::uint8_t unit) noexcept
    {
        unit_order* const own = make(unit);
        return own == nullptr ? others_ : *own;
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
        others_.last_stop = newer_of(others_.last_stop, known.last_stop);
        others_.last_fault = newer_of(others_.last_fault, known.last_fault);
        others_.rearranged = newer_of(others_.rearranged, known.rearranged);
    }

    std::array<unit_order, Units> places_{filled<Units>(nothing_known)};
    unit_order others_{nothing_known};
    [[no_unique_address]] used_places<Units> used_{};
};

/// The stop of all units that is under way: it holds all that no stop of their own holds.
class stop_of_all {
public:
    /// Its stamp; 0: there is none.
    [[nodiscard]] constexpr std::uint32_t stamp() const noexcept { return stamp_; }

    constexpr void begin(std::uint32_t stamp) noexcept
    {
        stamp_ = stamp;
        is_over_ = false; // if another one has just ended
    }

    /// It visits, or another one does. One of which the hold was released, or that outlives another one, takes it.
    constexpr void keep(std::uint32_t stamp, instant now) noexcept
    {
        if (stamp_ == 0 or is_over_) {
            begin(stamp);
        }
        is_shared_ = is_shared_ or stamp != stamp_;
        seen_ = step_of(now);
        passes_left_ = most_passes_missed;
    }

    /// It has ended. Its hold lasts until `let_go_if_over`.
    constexpr void end() noexcept { is_over_ = true; }
    constexpr void let_go_if_over() noexcept
    {
        if (is_over_ and not is_shared_) { // else the other one holds from its next visit on
            stamp_ = 0;
        }
        is_shared_ = false;
    }
    constexpr void let_go() noexcept { stamp_ = 0; }

    /// A pass, in which it may not have visited. True once: when it counts as given up.
    [[nodiscard]] constexpr bool has_missed(instant now) noexcept
    {
        return stamp_ != 0 and detail::has_missed(passes_left_, seen_, now);
    }

private:
    std::uint32_t stamp_{0};
    bool is_over_{false};
    bool is_shared_{false};       ///< another stop of all units visited since the last `let_go_if_over`
    std::uint8_t passes_left_{0}; ///< that it may miss
    std::uint16_t seen_{0};       ///< when it visited last
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Until when a unit gets no new request, because an outstanding response could be taken for the response to the new
// request: RTU responses carry no number.
//
// The rule, for a unit that answers its requests in their order and each within W = R + L of the moment at which it
// could begin (R: response time-out with the response's own characters, L: late_response):
//
//   ended by                              held until      why
//   the response to the only sending      not held        there is no other
//   a response at s, while k sendings     s + k (s-f+L)   whichever was answered, k may follow, each within what
//   have none, the first at f                             the first may have taken, s - f, and L; of s - f no more
//                                                         counts than what all sendings and their waits may take:
//                                                         the program may have been stopped for the rest
//   no response, or given up              b               at each sending at t: b = max(b, t) + W, for the unit
//                                                         begins when it has answered all before it
//
// A damaged response, or an exception that asks for time, counts as a response. No rule of time can tell apart the
// responses of a unit that is slower than W and never responded in time. Apart from the transaction, which has one of these:
// it holds for units of which no request is under way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// One unit (0: none), and until when it gets no new request.
struct quarantine_entry {
    instant end;
    std::uint8_t unit;
};

/// The places of several units, and how many are in use: nobody looks at the others. The only place of one counts as used, and
/// leaves its padding to its holder.
template <std::size_t Units> struct quarantine_places {
    constexpr quarantine_entry* data() noexcept { return entries.data(); }
    constexpr quarantine_entry const* data() const noexcept { return entries.data(); }

    std::array<quarantine_entry, Units> entries{filled<Units>(quarantine_entry{instant{0}, 0})};
    std::size_t count{0};
};
template <> struct quarantine_places<1> {
    constexpr quarantine_entry* data() noexcept { return &entry; }
    constexpr quarantine_entry const* data() const noexcept { return &entry; }

    [[no_unique_address]] quarantine_entry entry{instant{0}, 0};
    static constexpr std::size_t count = 1;
};

/// The times of up to `Units` units at once; where more have an outstanding response, the last place stands for every
/// unit.
template <std::size_t Units> class quarantine {
public:
    /// A unit gets no new request until `end`, or until the later end that it has already.
    constexpr void begin(std::uint8_t unit, instant end) noexcept
    {
        quarantine_entry& own = place_of(unit);
        if (own.unit == nobody or reached(end, own.end)) {
            own.end = end;
        }
        own.unit = own.unit == nobody or own.unit == unit ? unit : everybody;
    }

    /// Lets time pass. Returns whether one of the times was over.
    constexpr bool advance(instant now) noexcept
    {
        bool is_over = false;
        for (quarantine_entry& each : used()) {
            if (each.unit != nobody and reached(now, each.end)) {
                each.unit = nobody;
                is_over = true;
            }
        }
        if constexpr (Units > 1) {
            while (entries_.count > 0 and entries_.data()[entries_.count - 1].unit == nobody) {
                --entries_.count;
            }
        }
        return is_over;
    }

    /// Whether no unit is held.
    [[nodiscard]] constexpr bool is_empty() const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (each.unit != nobody) {
                return false;
            }
        }
        return true;
    }

    /// Whether a unit may not be asked yet; never for 0, the broadcast, which has no response.
    [[nodiscard, gnu::always_inline]] constexpr bool covers(std::uint8_t unit) const noexcept
    {
        if constexpr (Units == 1) {
            return unit != nobody and stands_for(*entries_.data(), unit);
        } else {
            return is_among(unit);
        }
    }

    /// Adds the times that are not over yet.
    constexpr void add_to(earliest& next) const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (each.unit != nobody) {
                next.add(each.end);
            }
        }
    }

private:
    static constexpr std::uint8_t nobody = 0;
    /// Stands for all units; no unit has it.
    static constexpr std::uint8_t everybody = 0xFF;

    static constexpr bool stands_for(quarantine_entry const& each, std::uint8_t unit) noexcept
    {
        return each.unit == unit or each.unit == everybody;
    }

    /// `covers` for several units. A function of its own: it is called in several places, and in more for each kind of
    /// conversation.
    constexpr bool is_among(std::uint8_t unit) const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (unit != nobody and stands_for(each, unit)) {
                return true;
            }
        }
        return false;
    }

    /// The unit's own place, or a free one, or the last.
    constexpr quarantine_entry& place_of(std::uint8_t unit) noexcept
    {
        if constexpr (Units == 1) {
            return *entries_.data();
        } else {
            std::size_t const used = entries_.count;
            std::size_t found = used < Units ? used : Units - 1;
            for (std::size_t i = used; i-- > 0;) {
                if (entries_.data()[i].unit == unit) {
                    return entries_.data()[i];
                }
                found = entries_.data()[i].unit == nobody ? i : found;
            }
            entries_.count = found < used ? used : found + 1;
            return entries_.data()[found];
        }
    }

    /// The entries up to the last one in use.
    constexpr std::span<quarantine_entry> used() noexcept { return std::span{entries_.data(), entries_.count}; }
    constexpr std::span<quarantine_entry const> used() const noexcept
    {
        return std::span{entries_.data(), entries_.count};
    }

    [[no_unique_address]] quarantine_places<Units> entries_{};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What counts, of what a client tells its observer: `basic_client<observed_by<unit_statistics<30>>>`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Counts since the last reset; each stops at its highest value.
struct counters {
    static constexpr std::size_t events = 13;
    static constexpr std::size_t codes = 12;

    std::array<std::uint32_t, events> by_event{};
    /// Exceptions 1 to 11; any other at 0.
    std::array<std::uint32_t, codes> by_exception{};
    /// From the end of a request to the end of its response. On a host the end of the request is computed; a response
    /// before it, on a line without wires, is not counted.
    duration worst_latency{};

    [[nodiscard]] constexpr std::uint32_t operator[](line_event what) const noexcept
    {
        return by_event[static_cast<std::size_t>(what)];
    }

    constexpr void note(line_event what) noexcept { increment(by_event[static_cast<std::size_t>(what)]); }
    constexpr void note_exception(errc code) noexcept
    {
        std::size_t const number = static_cast<std::uint8_t>(code);
        increment(by_exception[number < codes ? number : 0]);
    }
    constexpr void note_latency(duration latency) noexcept
    {
        if (static_cast<std::int32_t>(latency.microseconds) > static_cast<std::int32_t>(worst_latency.microseconds)) {
            worst_latency = latency;
        }
    }

    /// Notes a frame as what was found in it; of a response, how long after its request it came.
    constexpr void note_response(line_event what, errc found, duration latency) noexcept
    {
        if (what == line_event::exception) {
            note_exception(found);
        }
        if (what == line_event::reply or what == line_event::exception) {
            note_latency(latency);
        }
        note(what);
    }

private:
    static constexpr void increment(std::uint32_t& count) noexcept { count += count == 0xFFFF'FFFF ? 0 : 1; }
};

/// Counts for the line as a whole.
class line_statistics : public detail::no_observer {
public:
    constexpr void on_event(line_event what, std::uint8_t) noexcept { line_.note(what); }

    /// A request has left, or will have left by `at`.
    constexpr void on_sent(byte_view, frame_role, instant at) noexcept { asked_ = at; }

    /// What came in answer to it has arrived. Returns how long it took.
    constexpr duration on_response(line_event what, errc found, std::uint8_t, instant now) noexcept
    {
        duration const latency = now - asked_;
        line_.note_response(what, found, latency);
        return latency;
    }

    /// Counts bytes that belong to no response; `is_start`: the first of them came after silence. Bytes that begin
    /// with the address of a unit whose response is outstanding (`owing`, or 0) are one late response up to the next
    /// silence; others are noise, byte by byte. Returns whether a late response began here.
    constexpr bool on_stray(byte_view bytes, bool is_start, std::uint8_t owing) noexcept
    {
        if (is_start) {
            is_late_ = owing != 0;
        }
        for (std::size_t i = 0; i < bytes.size() and not is_late_; ++i) {
            line_.note(line_event::noise);
        }
        bool const begins = is_start and is_late_;
        if (begins) {
            line_.note(line_event::late);
        }
        return begins;
    }

    [[nodiscard]] constexpr counters const& line() const noexcept { return line_; }
    constexpr void reset() noexcept { line_ = {}; }

private:
    bool is_late_{false};
    instant asked_{0};
    counters line_{};
};

/// Counts for the line and for the first `Units` units that are asked. A frame that names no unit for sure counts for
/// the unit asked; bytes outside of transactions count for the line alone.
template <std::size_t Units> class unit_statistics : public detail::no_observer {
public:
    constexpr void on_event(line_event what, std::uint8_t unit) noexcept
    {
        line_.on_event(what, unit);
        if (what == line_event::request) {
            add(unit);
        }
        if (counters* const own = find(unit)) {
            own->note(what);
        }
    }

    constexpr void on_sent(byte_view frame, frame_role role, instant at) noexcept { line_.on_sent(frame, role, at); }

    constexpr void on_response(line_event what, errc found, std::uint8_t unit, instant now) noexcept
    {
        duration const latency = line_.on_response(what, found, unit, now);
        if (counters* const own = find(unit)) {
            own->note_response(what, found, latency);
        }
    }

    constexpr void on_stray(byte_view bytes, bool is_start, std::uint8_t owing) noexcept
    {
        counters* const own = find(owing);
        if (line_.on_stray(bytes, is_start, owing) and own != nullptr) {
            own->note(line_event::late);
        }
    }

    [[nodiscard]] constexpr counters const& line() const noexcept { return line_.line(); }

    /// A unit's counts; null for a unit that was not asked, or only after the table was full.
    [[nodiscard]] constexpr counters const* unit(std::uint8_t number) const noexcept
    {
        for (row const& each : rows_) {
            if (each.unit == number and number != 0) {
                return &each.counts;
            }
        }
        return nullptr;
    }

    constexpr void reset() noexcept
    {
        line_.reset();
        rows_ = {};
    }

private:
    struct row {
        counters counts{};
        std::uint8_t unit{0}; ///< 0 where the row is free; a broadcast has none
    };

    constexpr counters* find(std::uint8_t unit) noexcept
    {
        for (row& each : rows_) {
            if (each.unit == unit and unit != 0) {
                return &each.counts;
            }
        }
        return nullptr;
    }

    constexpr void add(std::uint8_t unit) noexcept
    {
        for (row& each : rows_) {
            if (each.unit == 0 or each.unit == unit) {
                each.unit = unit;
                return;
            }
        }
    }

    std::array<row, Units> rows_{}; // in front: two empty bases of one type would need two places
    line_statistics line_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

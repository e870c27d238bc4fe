// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client counts of its line, if its type says so: `basic_client<observed_by<unit_statistics<30>>>`. A client without
// statistics holds no byte of them and runs no instruction for them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What can be counted.
enum class line_event : std::uint8_t {
    request,    ///< a request left for the first time
    repetition, ///< a request left again
    reply,      ///< a response was accepted
    timeout,    ///< no response in time
    late,       ///< a response came after its time
    foreign,    ///< a response of another unit
    crc,        ///< a frame with a wrong CRC, or with a receive error
    length,     ///< a frame whose size is wrong
    mismatch,   ///< a good frame that is no response to the request
    exception,  ///< an exception response
    collision,  ///< our own transmission came back changed
    jam,        ///< the line did not fall silent
    noise,      ///< a byte that belonged to no response
};

/// What a frame counts as, by the error that was found in it.
/// Internal.
[[nodiscard]] constexpr line_event event_of(errc found) noexcept
{
    if (found == errc::none) {
        return line_event::reply;
    }
    if (is_exception(found)) {
        return line_event::exception;
    }
    if (found == errc::frame_too_short or found == errc::frame_too_long or found == errc::wrong_length) {
        return line_event::length;
    }
    if (found == errc::crc_mismatch or found == errc::uart_error) {
        return line_event::crc;
    }
    return found == errc::wrong_unit ? line_event::foreign : line_event::mismatch;
}

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

private:
    static constexpr void increment(std::uint32_t& count) noexcept { count += count == 0xFFFF'FFFF ? 0 : 1; }
};

/// Counts nothing.
/// Internal.
struct no_statistics {
    static constexpr void note(line_event, std::uint8_t) noexcept {}
    static constexpr void note_exception(errc, std::uint8_t) noexcept {}
    static constexpr void note_asked(instant) noexcept {}
    static constexpr void note_response(instant, std::uint8_t) noexcept {}
    static constexpr void note_stray(std::size_t, bool, std::uint8_t) noexcept {}
};

/// Counts for the line as a whole.
class line_statistics {
public:
    constexpr void note(line_event what, std::uint8_t) noexcept { line_.note(what); }
    constexpr void note_exception(errc code, std::uint8_t) noexcept { line_.note_exception(code); }
    /// A request has left, or will have left by `at`.
    constexpr void note_asked(instant at) noexcept { asked_ = at; }
    /// Its response has arrived. Returns how long it took.
    constexpr duration note_response(instant at, std::uint8_t) noexcept
    {
        duration const latency = at - asked_;
        line_.note_latency(latency);
        return latency;
    }

    /// Counts bytes that belong to no response; `is_start`: the first of them came after silence. Bytes that begin
    /// with the address of a unit whose response is outstanding (`owing`, or 0) are one late response up to the next
    /// silence; others are noise, byte by byte. Returns whether a late response began here.
    constexpr bool note_stray(std::size_t bytes, bool is_start, std::uint8_t owing) noexcept
    {
        if (is_start) {
            is_late_ = owing != 0;
        }
        for (std::size_t i = 0; i < bytes and not is_late_; ++i) {
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
template <std::size_t Units> class unit_statistics {
public:
    constexpr void note(line_event what, std::uint8_t unit) noexcept
    {
        line_.note(what, unit);
        if (what == line_event::request) {
            add(unit);
        }
        if (counters* const own = find(unit)) {
            own->note(what);
        }
    }
    constexpr void note_exception(errc code, std::uint8_t unit) noexcept
    {
        line_.note_exception(code, unit);
        if (counters* const own = find(unit)) {
            own->note_exception(code);
        }
    }
    constexpr void note_asked(instant at) noexcept { line_.note_asked(at); }
    constexpr void note_response(instant at, std::uint8_t unit) noexcept
    {
        duration const latency = line_.note_response(at, unit);
        if (counters* const own = find(unit)) {
            own->note_latency(latency);
        }
    }

    constexpr void note_stray(std::size_t bytes, bool is_start, std::uint8_t owing) noexcept
    {
        counters* const own = find(owing);
        if (line_.note_stray(bytes, is_start, owing) and own != nullptr) {
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

    line_statistics line_{};
    std::array<row, Units> rows_{};
};

/// Notes a frame that arrived by `now`, after a request to `unit`, by the error that was found in it.
/// Internal.
template <typename Statistics>
constexpr void note_frame(Statistics& to, line_event what, errc found, std::uint8_t unit, instant now) noexcept
{
    if (what == line_event::exception) {
        to.note_exception(found, unit);
    }
    if (what == line_event::reply or what == line_event::exception) {
        to.note_response(now, unit);
    }
    to.note(what, unit);
}

} // namespace rtuwire

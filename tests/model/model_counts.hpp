// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client counts (rules 25 to 27): a model that shares no code with the headers.
#pragma once

#include <array>
#include <map>

#include "model_line.hpp"

namespace model {

/// In the order of the library's own numbers.
enum event : std::size_t {
    a_request,
    a_repetition,
    a_reply,
    a_timeout,
    a_late,
    a_foreign,
    a_crc,
    a_length,
    a_mismatch,
    an_exception,
    a_collision,
    a_jam,
    a_noise,
    events
};

struct counts {
    std::array<unsigned, events> by_event{};
    std::array<unsigned, 12> by_exception{};
    microseconds worst_latency{0};
};

/// The counts of the line, and of the first units asked.
class statistics {
public:
    explicit statistics(std::size_t rows) : rows_{rows} {}

    void note(event what, std::uint8_t unit)
    {
        if (what == a_request and unit != 0 and units.size() < rows_) {
            units.try_emplace(unit);
        }
        each_of(unit, [&](counts& to) { ++to.by_event[what]; });
    }
    void note_line(event what) { ++line.by_event[what]; }
    void note_frame(fault found, std::uint8_t unit, microseconds latency)
    {
        event const what = event_of(found);
        note(what, unit);
        if (what == an_exception) {
            std::size_t const row = found < 12 ? static_cast<std::size_t>(found) : 0U;
            each_of(unit, [&](counts& to) { ++to.by_exception[row]; });
        }
        if (what == an_exception or what == a_reply) {
            microseconds const shown = static_cast<std::int32_t>(latency); // by the clock
            each_of(unit, [&](counts& to) { to.worst_latency = std::max(to.worst_latency, shown); });
        }
    }

    static event event_of(fault found)
    {
        if (found == none) {
            return a_reply;
        }
        if (found < 0x80) {
            return an_exception;
        }
        if (found == crc_mismatch or found == uart_error) {
            return a_crc;
        }
        if (found == frame_too_short or found == frame_too_long or found == wrong_length) {
            return a_length;
        }
        return found == wrong_unit ? a_foreign : a_mismatch;
    }

    counts line{};
    std::map<std::uint8_t, counts> units{};

private:
    template <typename Do> void each_of(std::uint8_t unit, Do what)
    {
        what(line);
        if (auto const own = units.find(unit); own != units.end()) {
            what(own->second);
        }
    }
    std::size_t rows_;
};

} // namespace model

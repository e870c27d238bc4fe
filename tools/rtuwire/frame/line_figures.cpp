// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/line_figures.hpp"

#include <algorithm>

namespace tool {

using rtuwire::frame_role;
using rtuwire::frame_verdict;

void line_figures::note_silence(std::uint64_t begin, rtuwire::line_timing const& wire)
{
    if (frames_ == 0 or begin <= last_) {
        return;
    }
    auto const silence = static_cast<double>(begin - last_);
    shortest_silence_ = shortest_silence_ == 0 ? silence : std::min(shortest_silence_, silence);
    too_close_ += silence < wire.t3_5().microseconds ? 1U : 0U;
}

void line_figures::note_response(unit_figures& unit, rtuwire::heard_frame const& heard)
{
    ++(heard.is_exception() ? unit.refused : unit.answered);
    if (heard.request.empty()) {
        return; // nobody knows how long it took
    }
    std::uint32_t const time = heard.response_time.microseconds;
    unit.response_times.add(time);
    auto const place = std::ranges::upper_bound(limits, time / 1'000U);
    ++histogram_[static_cast<std::size_t>(place - limits.begin())];
}

void line_figures::take(tapped_frame const& it)
{
    rtuwire::heard_frame const& heard = it.heard;
    if (heard.is_unanswered) {
        ++units_[heard.unit()].unanswered;
        return;
    }
    if (heard.frame.verdict == frame_verdict::echo) {
        return; // on the line once
    }
    std::size_t const size = heard.frame.bytes.size();
    std::uint32_t const length = it.wire.characters(size).microseconds;
    busy_ += length;
    if (heard.frame.verdict == frame_verdict::stray and heard.frame.role == frame_role::unknown) {
        stray_bytes_ += size;
        return;
    }
    note_silence(it.unix_microseconds - length, it.wire);
    first_ = frames_ == 0 ? it.unix_microseconds : first_;
    last_ = it.unix_microseconds;
    ++frames_;
    unit_figures& unit = units_[heard.unit()];
    if (heard.frame.verdict == frame_verdict::damaged) {
        ++unit.damaged;
    } else if (heard.frame.verdict == frame_verdict::stray) {
        stray_bytes_ += size; // a response to nothing that was asked
    } else if (heard.frame.role == frame_role::request) {
        ++unit.requests;
    } else if (heard.frame.role == frame_role::response) {
        note_response(unit, heard);
    }
}

double line_figures::seconds() const { return static_cast<double>(last_ - first_) / 1e6; }

double line_figures::load() const
{
    return seconds() > 0 ? std::min(1.0, static_cast<double>(busy_) / 1e6 / seconds()) : 0;
}

} // namespace tool

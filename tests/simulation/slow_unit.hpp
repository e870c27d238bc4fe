// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit of somebody else's make: it answers in order, and takes its time.
#pragma once

#include <algorithm>
#include <deque>

#include <rtuwire/sim/line/line_faults.hpp>

#include "setting.hpp"
#include "shared_line.hpp"

namespace rtuwire::simulation {

/// Takes whole requests, works on them one after the other, and needs its time for each from the moment it
/// could begin.
class slow_unit {
public:
    struct job {
        std::uint32_t transmission{0};
        frame request{};
        moment heard{0};
    };

    slow_unit() = default;
    slow_unit(std::uint8_t unit, unit_setting const& how) : unit_{unit}, how_{how} {}

    std::uint8_t unit() const { return unit_; }
    bool is_idle() const { return jobs_.empty(); }
    bool is_sending(moment from) const { return free_at_ > from; }
    void be_fast() { how_ = {.latency = {500, 2'000}}; }

    void take(job const& asked, detail::random_source& random_source)
    {
        if (how_.is_dead or (how_.forgets_when_busy and not jobs_.empty())) {
            return;
        }
        jobs_.push_back(asked);
        if (jobs_.size() == 1) {
            chain_ = asked.transmission;
            is_late_chain_ = is_late_chain_ and asked.heard < free_at_;
            begin(random_source);
        }
    }

    /// When it has a response to send.
    moment next() const { return jobs_.empty() ? never : ready_at_; }
    void wait_until(moment at) { ready_at_ = at; }
    bool waits_for_silence() const { return how_.waits_for_silence; }

    job const& current() const { return jobs_.front(); }
    frame_origin origin() const { return {jobs_.front().transmission, could_begin_, chain_, is_late_chain_}; }

    /// Its response leaves until then; `longest` is what the client was told that it may take.
    void leave(moment end, moment longest, detail::random_source& random_source)
    {
        is_late_chain_ = is_late_chain_ or end - could_begin_ > longest;
        free_at_ = end;
        jobs_.pop_front();
        if (not jobs_.empty()) {
            begin(random_source);
        }
    }

private:
    void begin(detail::random_source& random_source)
    {
        could_begin_ = std::max(jobs_.front().heard, free_at_);
        moment const spread = how_.latency.most - how_.latency.least;
        ready_at_ = could_begin_ + how_.latency.least + random_source.below(static_cast<std::uint32_t>(spread + 1));
    }

    std::uint8_t unit_{0};
    unit_setting how_{};
    std::deque<job> jobs_{};
    moment could_begin_{0};
    moment ready_at_{0};
    moment free_at_{0};
    std::uint32_t chain_{0};
    bool is_late_chain_{false};
};

} // namespace rtuwire::simulation

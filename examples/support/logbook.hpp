// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What was seen of a drive: samples over time, two of them a second as lines of a table, and the states it
// went through since a mark.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <rtuwire/drives.hpp>

#include "../../tools/support/say.hpp"
#include "plot.hpp"

namespace examples {

using namespace tool;

class logbook {
public:
    using state = rtuwire::cia402::state;

    /// A sample whose state was asked for at a time. Where another one was noted since, the sample has that: the answers of
    /// its other registers came later, and a row must not show an older state below a newer one.
    void add(sample at, double asked_at)
    {
        if (noted_at_ >= asked_at) {
            at.state = last_state_;
        }
        samples_.push_back(at);
        if (at.time >= next_row_) {
            next_row_ = at.time + 0.5;
            show(at);
        }
    }

    /// A state that was read; said when it is another than the last one.
    void note(state at, double time)
    {
        if (at != last_state_) {
            last_state_ = at;
            noted_at_ = time;
            states_.push_back(at);
            say("  %6.2f s  -> %s\n", time, words(name_of(at)).c_str());
        }
    }

    /// Forgets the states so far.
    void mark() { states_.clear(); }

    /// Whether the states since the mark were just these.
    bool has_passed(std::vector<state> const& expected) const
    {
        bool const is_right = states_ == expected or
                              // A drive may begin higher up.
                              (states_.size() < expected.size() and not states_.empty() and
                               std::equal(states_.rbegin(), states_.rend(), expected.rbegin()));
        if (not is_right) {
            say("   NOT the states that the manual tells\n");
        }
        return is_right;
    }

    history const& samples() const { return samples_; }

private:
    void show(sample const& at)
    {
        if (rows_++ == 0) {
            say("     time   state                   reference     output    current\n");
        }
        if (at.is_known) {
            say("  %6.2f s  %-22s  %6.1f Hz  %6.1f Hz  %6.1f A\n", at.time, words(name_of(at.state)).c_str(),
                at.reference, at.output, at.current);
        } else {
            say("  %6.2f s  no response\n", at.time);
        }
    }

    history samples_{};
    std::vector<state> states_{};
    state last_state_{state::unknown};
    double noted_at_{-1};
    double next_row_{0};
    int rows_{0};
};

} // namespace examples

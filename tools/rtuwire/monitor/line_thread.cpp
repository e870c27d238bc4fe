// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/line_thread.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "../support/platform.hpp"

namespace tool {

using clock = unit_reader::clock;

line_thread::line_thread(std::unique_ptr<open_line> line, std::vector<unit_reader> units, double period)
    : line_{std::move(line)}, device_{line_->port().device()}, readers_{std::move(units)}, period_{period}
{
    for (unit_reader const& each : readers_) {
        shown_.push_back(each.shown());
    }
    without_signals const kept;
    thread_ = std::thread{[this] { run(); }};
}

line_thread::~line_thread()
{
    shall_end_ = true;
    thread_.join();
}

std::vector<shown_unit> line_thread::units() const
{
    std::scoped_lock const held{guard_};
    return shown_;
}

std::string line_thread::failure() const
{
    std::scoped_lock const held{guard_};
    return failure_;
}

void line_thread::run()
{
    std::string why;
    try {
        rounds();
        return;
    } catch (std::exception const& error) {
        why = error.what();
    } catch (...) {
        why = "the line ended for a reason that nobody named";
    }
    std::scoped_lock const held{guard_};
    failure_ = why.empty() ? device_ + ": failed" : why;
}

void line_thread::rounds()
{
    while (not shall_end_) {
        auto const began = clock::now();
        for (std::size_t i = 0; i < readers_.size() and not shall_end_ and not is_paused_; ++i) {
            readers_[i].round(*line_, clock::now());
            publish(i);
        }
        wait_for_next(began);
    }
}

void line_thread::publish(std::size_t which)
{
    std::scoped_lock const held{guard_};
    shown_[which] = readers_[which].shown();
}

void line_thread::wait_for_next(clock::time_point began)
{
    // The period may change, and the pause begin or end, while it waits. At least one look at the port a round.
    do {
        auto const next = began + std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>{period_});
        auto const left = std::chrono::ceil<std::chrono::microseconds>(next - clock::now());
        line_->let_pass(std::clamp<std::chrono::microseconds>(left, std::chrono::microseconds{1'000},
                                                              std::chrono::microseconds{50'000}));
        if (not is_paused_ and clock::now() >= next) {
            return;
        }
    } while (not shall_end_);
}

} // namespace tool

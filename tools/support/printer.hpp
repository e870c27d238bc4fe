// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lines for a terminal, a pipe or a file that may take none for as long as it likes (Ctrl-S, a reader that
// sleeps, a disk that hangs). A thread of its own waits for it, so that whoever prints never does.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "platform.hpp"

namespace tool {

class printer {
public:
    explicit printer(int descriptor) : shared_{std::make_shared<shared>(descriptor)} {}

    /// Leaves a text to be written. Where too many are waiting it is dropped, and counted.
    void put(std::string text)
    {
        begin();
        std::lock_guard const hold{shared_->lock};
        if (shared_->failure != 0 or shared_->waiting.size() >= most_waiting) {
            ++shared_->dropped;
            return;
        }
        shared_->waiting.push_back(std::move(text));
        shared_->news.notify_all();
    }

    /// Waits until all is written, at most so long; whether it is.
    bool finish(std::chrono::milliseconds time_limit)
    {
        std::unique_lock hold{shared_->lock};
        return shared_->news.wait_for(hold, time_limit, [this] { return shared_->is_idle(); }) and
               shared_->failure == 0;
    }

    /// How many texts nobody got, those that still wait included.
    std::size_t missing() const
    {
        std::lock_guard const hold{shared_->lock};
        return shared_->dropped + shared_->waiting.size() + (shared_->is_writing ? 1 : 0);
    }

    /// The system's number of the first failure to write, 0 for none. Nothing is written after it.
    int failure() const
    {
        std::lock_guard const hold{shared_->lock};
        return shared_->failure;
    }

private:
    static constexpr std::size_t most_waiting = 64;

    struct shared {
        explicit shared(int number) : descriptor{number} {}
        bool is_idle() const { return waiting.empty() and not is_writing; }

        int const descriptor;
        std::mutex lock{};
        std::condition_variable news{};
        std::deque<std::string> waiting{};
        std::size_t dropped{0};
        int failure{0};
        bool is_writing{false};
    };

    /// The thread is never joined: it may wait for ever. What it uses lives as long as it does.
    void begin()
    {
        if (has_begun_) {
            return;
        }
        has_begun_ = true;
        without_signals const kept; // they are for the thread that minds the motor
        std::thread{[mine = shared_] { write_on(*mine); }}.detach();
    }

    [[noreturn]] static void write_on(shared& mine)
    {
        std::unique_lock hold{mine.lock};
        for (;;) {
            mine.news.wait(hold, [&mine] { return not mine.waiting.empty(); });
            std::string const text = std::move(mine.waiting.front());
            mine.waiting.pop_front();
            mine.is_writing = true;
            hold.unlock();
            int const failure = write_blocking(mine.descriptor, text);
            hold.lock();
            mine.is_writing = false;
            if (failure != 0) {
                mine.failure = failure;
                mine.dropped += 1 + mine.waiting.size();
                mine.waiting.clear();
            }
            mine.news.notify_all();
        }
    }

    std::shared_ptr<shared> shared_;
    bool has_begun_{false};
};

} // namespace tool

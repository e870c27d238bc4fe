// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What is done on a line, one request after another, written as one function that waits: a coroutine. It owns those that it
// waits for, so that whoever drops the outermost drops all.
#pragma once

#include <coroutine>
#include <cstdlib>
#include <utility>

namespace line_page {

class [[nodiscard]] steps {
public:
    struct promise_type {
        struct ending {
            static bool await_ready() noexcept { return false; }
            static void await_suspend(std::coroutine_handle<promise_type> ended) noexcept
            {
                if (auto const caller = ended.promise().caller) {
                    caller.resume();
                }
            }
            static void await_resume() noexcept {}
        };

        steps get_return_object() { return steps{std::coroutine_handle<promise_type>::from_promise(*this)}; }
        static std::suspend_always initial_suspend() noexcept { return {}; }
        static ending final_suspend() noexcept { return {}; }
        static void return_void() noexcept {}
        static void unhandled_exception() noexcept { std::abort(); }

        std::coroutine_handle<> caller{};
    };

    steps() = default;
    explicit steps(std::coroutine_handle<promise_type> own) noexcept : own_{own} {}
    steps(steps&& other) noexcept : own_{std::exchange(other.own_, {})} {}
    steps& operator=(steps&& other) noexcept
    {
        std::swap(own_, other.own_);
        return *this;
    }
    ~steps()
    {
        if (own_) {
            own_.destroy();
        }
    }

    /// Begins the outermost.
    void begin() { own_.resume(); }
    [[nodiscard]] bool is_over() const noexcept { return not own_ or own_.done(); }

    // As what another waits for.
    static bool await_ready() noexcept { return false; }
    void await_suspend(std::coroutine_handle<> caller)
    {
        own_.promise().caller = caller;
        own_.resume();
    }
    static void await_resume() noexcept {}

private:
    std::coroutine_handle<promise_type> own_{};
};

} // namespace line_page

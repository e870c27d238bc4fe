// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number that one thread tells another, which sleeps until it changes. It orders nothing else between them, so that the
// thread sanitizer still finds what the code under test leaves open: it does not look into this call of the system.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace rtuwire::test {

class told_number {
public:
    explicit told_number(std::uint32_t first) : value_{first} {}

    [[nodiscard]] std::uint32_t get() const { return value_.load(std::memory_order_relaxed); }

    void tell(std::uint32_t value)
    {
        value_.store(value, std::memory_order_relaxed);
#ifdef __linux__
        ::syscall(SYS_futex, &value_, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
#endif
    }

    /// Returns when the number is no longer `known`, or earlier. Looks some times before it sleeps: threads that never run
    /// at once would meet nowhere.
    void wait_behind(std::uint32_t known) const
    {
        for (int i = 0; i < 200; ++i) {
            if (get() != known) {
                return;
            }
        }
#ifdef __linux__
        ::syscall(SYS_futex, &value_, FUTEX_WAIT_PRIVATE, known, nullptr, nullptr, 0);
#else
        std::this_thread::yield();
#endif
    }

private:
    std::atomic<std::uint32_t> value_;
    static_assert(sizeof(std::atomic<std::uint32_t>) == 4 and std::atomic<std::uint32_t>::is_always_lock_free);
};

} // namespace rtuwire::test

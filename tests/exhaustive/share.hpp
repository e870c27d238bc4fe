// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The work of an exhaustive program, on every processor; PROGRAM [STRIDE] looks at each STRIDE-th case
// only, for a quick run.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace rtuwire::exhaustive {

/// Every how manieth case is looked at; 1 is all of them.
inline std::uint64_t stride_of(int argc, char** argv)
{
    std::uint64_t const stride = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
    return stride == 0 ? 1 : stride;
}

/// Calls `is_right(case)` for all cases below `count` by the stride; says how many were wrong, and returns
/// whether none was.
template <typename Right> bool holds(char const* what, std::uint64_t count, std::uint64_t stride, Right is_right)
{
    std::atomic<std::uint64_t> wrong{0};
    unsigned const workers = std::thread::hardware_concurrency() > 0 ? std::thread::hardware_concurrency() : 1U;
    auto const work = [&](std::uint64_t first) {
        std::uint64_t mine = 0;
        for (std::uint64_t at = first * stride; at < count; at += stride * workers) {
            mine += is_right(at) ? 0U : 1U;
        }
        wrong += mine;
    };
    std::vector<std::thread> pool;
    for (unsigned i = 0; i < workers; ++i) {
        pool.emplace_back(work, i);
    }
    for (std::thread& each : pool) {
        each.join();
    }
    std::printf("%s: %llu cases, %llu wrong\n", what, static_cast<unsigned long long>((count + stride - 1) / stride),
                static_cast<unsigned long long>(wrong.load()));
    return wrong == 0;
}

} // namespace rtuwire::exhaustive

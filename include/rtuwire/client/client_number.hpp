// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What tells a client from one that is made anew in its place (`emplace` of an optional, a local object of a function that
// is called again): a number from the one counter that all clients of a program share. A conversation may outlive its
// client, and the numbers that it holds are of that client's count.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Another number for each client, never 0. Two clients that two tasks make at once may get the same where a processor has
/// no operation for it; they are in two places then.
[[nodiscard]] inline std::uint32_t next_client_number() noexcept
{
    static constinit std::uint32_t given{0};
#ifdef __GCC_HAVE_SYNC_COMPARE_AND_SWAP_4
    std::uint32_t const number = __atomic_add_fetch(&given, 1, __ATOMIC_RELAXED);
#else
    std::uint32_t const number = ++given;
#endif
    return number == 0 ? 1 : number;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

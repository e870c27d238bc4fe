// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A number that one context stores and another one loads: an interrupt and a loop, or two threads.
//
// Uses atomic loads and stores only: a Cortex-M0+ has no other atomic instruction. They are the compiler's
// built-in functions, because <atomic> takes longer to compile than all else its users need and its
// objects cannot be used in a constant expression.
#pragma once

#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// Loads what the other side stores: an acquiring load sees all that was written before the releasing store it reads.
template <typename T> [[nodiscard]] constexpr T load(T const& from) noexcept
{
    return std::is_constant_evaluated() ? from : __atomic_load_n(&from, __ATOMIC_ACQUIRE);
}
template <typename T> constexpr void store(T& to, T value) noexcept
{
    if (std::is_constant_evaluated()) {
        to = value;
    } else {
        __atomic_store_n(&to, value, __ATOMIC_RELEASE);
    }
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

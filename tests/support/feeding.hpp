// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The ways in which the bytes of a frame arrive.
#pragma once

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::test {

enum class feeding {
    whole,   ///< all at once
    single,  ///< byte by byte
    growing, ///< one byte, then two, then three, and so on
};
inline constexpr feeding feedings[] = {feeding::whole, feeding::single, feeding::growing};

/// Hands bytes to `take`, chunk by chunk.
template <typename Take> constexpr void feed(byte_view bytes, feeding how, Take const& take)
{
    std::size_t chunk = how == feeding::whole ? bytes.size() : 1;
    while (not bytes.empty()) {
        std::size_t const size = chunk < bytes.size() ? chunk : bytes.size();
        take(bytes.first(size));
        bytes = bytes.subspan(size);
        chunk += how == feeding::growing ? 1U : 0U;
    }
}

} // namespace rtuwire::test

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whether the first bytes of a frame tell its size.
#pragma once

#include <cstddef>

#include "support/exact.hpp"

#include <rtuwire/wire/functions.hpp>

namespace rtuwire::test {

using namespace detail;

/// Whether each prefix either asks for more than it has or says the size of the whole; looking
/// again where it says leads to that size; and bytes behind the frame change nothing.
constexpr bool is_told(direction way, byte_view frame)
{
    std::size_t look_at = 2;
    for (std::size_t size = 0; size <= frame.size(); ++size) {
        exact_bytes const prefix{frame.first(size)};
        length_hint const known = frame_length(way, prefix.view());
        if (known.is_final() and known.size() != frame.size()) {
            return false;
        }
        if (not known.is_final() and known.size() <= size) {
            return false;
        }
        if (size == look_at) {
            look_at = known.size();
        }
    }
    exact_bytes longer{frame.size() + 1, std::byte{0xFF}};
    for (std::size_t i = 0; i < frame.size(); ++i) {
        longer.span()[i] = frame[i];
    }
    length_hint const whole{frame.size(), true};
    return look_at == frame.size() and frame_length(way, frame) == whole and frame_length(way, longer.view()) == whole;
}

/// Whether nothing but silence ends this frame, however much of it is there from the byte on that
/// decides so.
constexpr bool is_ended_by_silence(direction way, byte_view frame, std::size_t decided_at)
{
    for (std::size_t size = 0; size <= frame.size(); ++size) {
        exact_bytes const prefix{frame.first(size)};
        length_hint const known = frame_length(way, prefix.view());
        if (known.is_final() or (known.size() == 0) != (size >= decided_at) or
            (known.size() != 0 and known.size() <= size)) {
            return false;
        }
    }
    return true;
}

} // namespace rtuwire::test

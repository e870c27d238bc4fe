// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A frame that comes from a capture file.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A frame from a capture.
struct captured_frame {
    traced_frame frame;                 ///< its `at` are the low 32 bits of the time
    std::uint64_t unix_microseconds{0}; ///< its time
    std::uint32_t full_size{0};         ///< on the line; the file may hold fewer of its bytes
    std::uint32_t bits_per_second{0};   ///< of its line; 0 where the file does not say it
    std::uint16_t line{0};              ///< the number of its line in the file, from 0 on
};

} // namespace rtuwire

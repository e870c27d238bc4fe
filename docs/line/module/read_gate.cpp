// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "read_gate.hpp"

#include <cstddef>
#include <cstdint>

namespace line_page {

bool is_read(rtuwire::byte_view frame) noexcept
{
    constexpr std::size_t size_of_values = 8, size_of_identity = 7;
    auto const at = [&](std::size_t place) { return std::to_integer<std::uint8_t>(frame[place]); };
    if (frame.size() < size_of_identity or at(0) < 1 or at(0) > 247) {
        return false;
    }
    std::size_t const end = frame.size() - 2;
    bool const is_undamaged = rtuwire::crc16(frame.first(end)) == (at(end) | at(end + 1) << 8U);
    bool const reads_values = frame.size() == size_of_values and at(1) >= 1 and at(1) <= 4;
    bool const reads_identity = frame.size() == size_of_identity and at(1) == 43 and at(2) == 14;
    return is_undamaged and (reads_values or reads_identity);
}

} // namespace line_page

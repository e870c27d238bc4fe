// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A fuzzer's bytes, taken piece by piece; and what a target says when something does not hold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/wire/function.hpp>

namespace fuzz {

inline void require(bool holds)
{
    if (not holds) {
        std::abort();
    }
}

class input {
public:
    input(std::uint8_t const* data, std::size_t size) : bytes_{reinterpret_cast<std::byte const*>(data), size} {}

    bool is_empty() const { return bytes_.empty(); }

    /// The next byte; 0 when there is none.
    std::uint8_t u8()
    {
        if (bytes_.empty()) {
            return 0;
        }
        std::uint8_t const first = rtuwire::detail::to_u8(bytes_[0]);
        bytes_ = bytes_.subspan(1);
        return first;
    }

    std::uint16_t u16() { return static_cast<std::uint16_t>(u8() << 8U | u8()); }

    /// Up to `most` of the next bytes.
    rtuwire::byte_view some(std::size_t most)
    {
        std::size_t const count = most < bytes_.size() ? most : bytes_.size();
        rtuwire::byte_view const taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }

private:
    rtuwire::byte_view bytes_;
};

/// Bytes as a frame: as they are, or with the CRC that belongs to them.
class frame {
public:
    frame(rtuwire::byte_view bytes, bool has_crc)
    {
        constexpr std::size_t most = rtuwire::max_adu_size + 8;
        for (std::byte const byte : bytes.first(bytes.size() < most ? bytes.size() : most)) {
            place_[size_++] = byte;
        }
        if (has_crc) {
            std::uint16_t const crc = rtuwire::crc16(view());
            place_[size_++] = rtuwire::detail::to_byte(crc);
            place_[size_++] = rtuwire::detail::to_byte(std::uint32_t{crc} >> 8U);
        }
    }

    rtuwire::byte_view view() const { return rtuwire::byte_view{place_}.first(size_); }

private:
    std::array<std::byte, rtuwire::max_adu_size + 10> place_{};
    std::size_t size_{0};
};

} // namespace fuzz

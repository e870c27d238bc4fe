// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A USB serial adapter between a line and a host: bytes are buffered until the buffer is full or the latency timer
// ends, so that a frame arrives late, in chunks, and with gaps.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// One direction of an adapter.
class usb_adapter {
public:
    /// The timer runs from the first byte; common adapters have 16 ms.
    explicit constexpr usb_adapter(duration latency = milliseconds(16)) noexcept : latency_{latency} {}

    /// Receives a byte from the line.
    constexpr void take(std::byte byte, instant now) noexcept
    {
        if (size_ == 0) {
            release_at_ = now + latency_;
        }
        if (size_ < buffer_.size()) {
            buffer_[size_++] = byte;
        }
        if (size_ == buffer_.size()) {
            release_at_ = now;
        }
    }

    /// The bytes that the host gets now, valid until the next byte; empty while they are buffered.
    [[nodiscard]] constexpr byte_view give(instant now) noexcept
    {
        if (size_ == 0 or not reached(now, release_at_)) {
            return {};
        }
        byte_view const lump = byte_view{buffer_}.first(size_);
        size_ = 0;
        return lump;
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return size_ == 0 ? deadline{} : deadline{release_at_};
    }

private:
    std::array<std::byte, 62> buffer_{}; ///< as much as one USB packet of 64 bytes carries
    duration latency_;
    instant release_at_{0};
    std::size_t size_{0};
};

} // namespace rtuwire::sim

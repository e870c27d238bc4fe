// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A USB serial adapter between a line and a host: octets are kept until its buffer is full or its latency
// timer ends, so that a frame arrives late, in lumps, and with gaps.
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
    /// The timer runs from the first octet; common adapters have 16 ms.
    explicit constexpr usb_adapter(duration latency = milliseconds(16)) noexcept : latency_{latency}
    {}

    /// An octet comes off the line.
    constexpr void take(std::byte octet, instant now) noexcept
    {
        if (size_ == 0) {
            release_at_ = now + latency_;
        }
        if (size_ < buffer_.size()) {
            buffer_[size_++] = octet;
        }
        if (size_ == buffer_.size()) {
            release_at_ = now;
        }
    }

    /// What the host gets now, valid until the next octet; empty while it is kept.
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
    std::array<std::byte, 62> buffer_{}; ///< as much as one USB packet of 64 octets carries
    duration latency_;
    instant release_at_{0};
    std::size_t size_{0};
};

} // namespace rtuwire::sim

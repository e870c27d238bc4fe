// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A USB serial adapter between a line and a host: bytes are buffered until the buffer is full or the latency timer
// ends, so that a frame arrives late, in chunks, and with gaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace sim {

/// What an adapter's latency timer runs from. With `from_last_packet` it runs all the time, from the packet before on, whether
/// bytes have come or not, as FTDI's do (AN232B-04); other adapters' timers begin with a byte.
enum class usb_timer : std::uint8_t { from_first_byte, from_last_packet };

/// One direction of an adapter.
class usb_adapter {
public:
    /// Common adapters have a latency of 16 ms; above 0 with `from_last_packet`.
    explicit constexpr usb_adapter(duration latency = milliseconds(16),
                                   usb_timer timer = usb_timer::from_first_byte) noexcept
        : latency_{latency}, timer_{timer}
    {}

    /// Receives a byte from the line.
    constexpr void take(std::byte byte, instant now) noexcept
    {
        if (size_ == 0) {
            release_at_ = now + until_timer(now);
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
        last_packet_ = release_at_;
        return lump;
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return size_ == 0 ? deadline{} : deadline{release_at_};
    }

private:
    /// How long it is to the next end of the timer.
    constexpr duration until_timer(instant now) const noexcept
    {
        if (timer_ == usb_timer::from_first_byte) {
            return latency_;
        }
        return duration{latency_.microseconds - (now - last_packet_).microseconds % latency_.microseconds};
    }

    std::array<std::byte, 62> buffer_{}; ///< as much as one USB packet of 64 bytes carries
    duration latency_;
    usb_timer timer_;
    instant release_at_{0};
    instant last_packet_{0}; ///< or a time at which an empty one went
    std::size_t size_{0};
};

} // namespace sim
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

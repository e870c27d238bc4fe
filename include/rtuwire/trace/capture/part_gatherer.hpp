// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Puts the parts of a file together that come in pieces of any size. Knows nothing of what they are.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// One part at a time, of up to `Capacity` bytes.
template <std::size_t Capacity> class part_gatherer {
public:
    /// The first part has `needed` bytes.
    explicit constexpr part_gatherer(std::size_t needed) noexcept : needed_{needed} {}

    /// The next piece; it has to stay until `gather` says no.
    constexpr void receive(byte_view piece) noexcept { piece_ = piece; }

    /// Whether all bytes of the part are there.
    [[nodiscard]] constexpr bool gather() noexcept
    {
        skip_ -= static_cast<std::uint32_t>(take(skip_ < piece_.size() ? skip_ : piece_.size()).size());
        std::size_t const missing = needed_ - held_;
        for (std::byte const each : take(missing < piece_.size() ? missing : piece_.size())) {
            place_[held_++] = each;
        }
        return held_ == needed_;
    }

    /// The bytes of the part; they stay where they are until the next one is gathered.
    [[nodiscard]] constexpr byte_view held() const noexcept { return byte_view{place_}.first(held_); }

    /// The part goes on: it has `needed` bytes in all, up to the capacity.
    constexpr void extend(std::size_t needed) noexcept { needed_ = needed; }

    /// A new part, behind `skip` bytes that nobody looks at.
    constexpr void begin(std::size_t needed, std::uint32_t skip = 0) noexcept
    {
        needed_ = needed;
        skip_ = skip;
        held_ = 0;
    }

    /// Whether a part has begun, or bytes are being skipped.
    [[nodiscard]] constexpr bool is_inside() const noexcept { return held_ != 0 or skip_ != 0; }

    /// How many bytes of the file were taken.
    [[nodiscard]] constexpr std::uint64_t offset() const noexcept { return offset_; }

private:
    constexpr byte_view take(std::size_t size) noexcept
    {
        byte_view const taken = piece_.first(size);
        piece_ = piece_.subspan(size);
        offset_ += size;
        return taken;
    }

    byte_view piece_{};
    std::uint64_t offset_{0};
    std::uint32_t skip_{0};
    std::size_t held_{0};
    std::size_t needed_;
    std::array<std::byte, Capacity> place_{};
};

} // namespace rtuwire

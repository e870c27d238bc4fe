// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a listener keeps: the bytes that it has not handed out yet, each with the time when it had arrived, and between
// which of them damaged ones lay, in one piece, so that a view of a frame is one span; and a request that passed, for its
// response. Apart from the listener, which says what becomes of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// Room for two of the longest frames.
class heard_bytes {
public:
    static constexpr std::size_t capacity = 2 * max_adu_size;

    [[nodiscard]] constexpr std::size_t size() const noexcept { return end_ - begin_; }
    [[nodiscard]] constexpr bool is_empty() const noexcept { return begin_ == end_; }
    [[nodiscard]] constexpr bool is_full() const noexcept { return size() == capacity; }

    /// The first `count` of them; valid until a byte is pushed.
    [[nodiscard]] constexpr byte_view first(std::size_t count) const noexcept
    {
        return byte_view{bytes_}.subspan(begin_, count);
    }

    /// When one of them had arrived.
    [[nodiscard]] constexpr instant time(std::size_t at) const noexcept { return instant{times_[begin_ + at]}; }

    /// Appends one; there must be room.
    constexpr void push(std::byte byte, instant at) noexcept
    {
        if (end_ == capacity) {
            move_to_front();
        }
        bytes_[end_] = byte;
        times_[end_] = at.microseconds;
        ++end_;
    }

    /// A damaged byte, which is not kept, came behind the last one.
    constexpr void note_damage() noexcept
    {
        first_damage_ = has_damage_ ? first_damage_ : end_;
        last_damage_ = end_;
        has_damage_ = true;
    }

    [[nodiscard]] constexpr bool has_damage() const noexcept { return has_damage_; }

    /// Nothing that comes from here on belongs to what was damaged.
    constexpr void forget_damage() noexcept { has_damage_ = false; }

    /// Whether damaged bytes lay before the last of `count` bytes from `from`. Between the first damage and the last
    /// all count as damaged.
    [[nodiscard]] constexpr bool is_damaged(std::size_t from, std::size_t count) const noexcept
    {
        std::size_t const at = begin_ + from;
        return has_damage_ and first_damage_ < at + count and last_damage_ >= at;
    }

    /// Removes bytes from the front.
    constexpr void pop(std::size_t count) noexcept
    {
        begin_ += count;
        has_damage_ = has_damage_ and last_damage_ > begin_;
        first_damage_ = first_damage_ < begin_ ? begin_ : first_damage_;
    }

private:
    constexpr void move_to_front() noexcept
    {
        std::size_t const count = size();
        for (std::size_t i = 0; i < count; ++i) {
            bytes_[i] = bytes_[begin_ + i];
            times_[i] = times_[begin_ + i];
        }
        first_damage_ -= has_damage_ ? begin_ : 0;
        last_damage_ -= has_damage_ ? begin_ : 0;
        begin_ = 0;
        end_ = count;
    }

    std::array<std::byte, capacity> bytes_{};
    std::array<std::uint32_t, capacity> times_{};
    std::size_t begin_{0};
    std::size_t end_{0};
    std::size_t first_damage_{0}; ///< an index of the byte behind it
    std::size_t last_damage_{0};
    bool has_damage_{false};
};

/// The bytes of one frame, or none, and when it ended.
class passed_request {
public:
    constexpr void note(byte_view bytes, instant end) noexcept
    {
        size_ = static_cast<std::uint16_t>(bytes.size());
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes_[i] = bytes[i];
        }
        end_ = end;
    }
    constexpr void forget() noexcept { size_ = 0; }

    [[nodiscard]] constexpr bool is_any() const noexcept { return size_ != 0; }
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return byte_view{bytes_}.first(size_); }
    [[nodiscard]] constexpr instant end() const noexcept { return end_; }

private:
    std::array<std::byte, max_adu_size> bytes_{};
    std::uint16_t size_{0};
    instant end_{0};
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Bits in wire order, as coils and discrete inputs travel (AP 6.1): the first one is the lowest bit of the first byte,
// and what is left of the last byte is 0.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The bytes that so many bits take.
/// Internal.
[[nodiscard]] constexpr std::size_t bytes_of_bits(std::size_t count) noexcept { return (count + 7) / 8; }

/// The bit at an index of bytes in wire order; the caller has checked that it is there.
/// Internal.
[[nodiscard]] constexpr bool bit_at(byte_view bytes, std::size_t index) noexcept
{
    return ((std::uint32_t{to_u8(bytes[index / 8])} >> (index % 8)) & 1U) != 0;
}

/// Sets that bit.
/// Internal.
constexpr void put_bit(byte_span bytes, std::size_t index, bool value) noexcept
{
    std::byte const mask = to_byte(std::uint32_t{1} << (index % 8));
    bytes[index / 8] = value ? bytes[index / 8] | mask : bytes[index / 8] & ~mask;
}

/// Copies `count` bits from one place to another; the caller has checked that they are there.
/// Internal.
constexpr void copy_bits(byte_span to, std::size_t to_at, byte_view from, std::size_t from_at,
                         std::size_t count) noexcept
{
    for (; count > 0; --count) {
        put_bit(to, to_at++, bit_at(from, from_at++));
    }
}

/// A view of bits; valid as long as its bytes.
class bit_view {
public:
    constexpr bit_view() noexcept = default;

    /// The first `count` bits of these bytes, or all of them where there are fewer.
    constexpr bit_view(byte_view bytes, std::size_t count) noexcept
        : bytes_{bytes}, count_{count < 8 * bytes.size() ? count : 8 * bytes.size()}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return count_ == 0; }

    /// The bit at an index below `size()`; any other index is misuse, as in a `register_view`.
    [[nodiscard]] constexpr bool operator[](std::size_t index) const noexcept
    {
        require_register(index, count_);
        return bit_at(bytes_, index);
    }

    /// The bytes that hold them.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return bytes_.first(bytes_of_bits(count_)); }

    /// Whether they are the same bits, whatever stands behind the last one.
    friend constexpr bool operator==(bit_view left, bit_view right) noexcept
    {
        bool is_same = left.count_ == right.count_;
        for (std::size_t i = 0; is_same and i < left.count_; ++i) {
            is_same = bit_at(left.bytes_, i) == bit_at(right.bytes_, i);
        }
        return is_same;
    }

private:
    byte_view bytes_{};
    std::size_t count_{0};
};

/// `Count` bits in wire order, stored in place: `bit_block{true, false, true}`.
template <std::size_t Count> class bit_block {
public:
    constexpr bit_block() noexcept = default;

    /// One bit for each value.
    template <std::same_as<bool>... Values>
        requires(sizeof...(Values) == Count and Count > 0)
    constexpr bit_block(Values... values) noexcept
    {
        std::size_t index = 0;
        (put_bit(bytes_, index++, values), ...);
    }

    [[nodiscard]] static constexpr std::size_t size() noexcept { return Count; }

    /// The bit at an index below `Count`; any other is misuse.
    [[nodiscard]] constexpr bool operator[](std::size_t index) const noexcept
    {
        require_register(index, Count);
        return bit_at(bytes_, index);
    }

    /// Replaces the bit at an index below `Count`; any other is misuse.
    constexpr void set(std::size_t index, bool value) noexcept
    {
        require_register(index, Count);
        put_bit(bytes_, index, value);
    }

    /// The bits, valid while the block lives: a temporary block gives no view.
    [[nodiscard]] constexpr bit_view view() const& noexcept { return {bytes_, Count}; }
    [[nodiscard]] bit_view view() const&& = delete;
    constexpr operator bit_view() const& noexcept { return view(); }
    operator bit_view() const&& = delete;

    /// The bytes that hold them, valid while the block lives.
    [[nodiscard]] constexpr byte_view bytes() const& noexcept { return bytes_; }
    [[nodiscard]] byte_view bytes() const&& = delete;

    friend constexpr bool operator==(bit_block const&, bit_block const&) = default;

private:
    std::array<std::byte, bytes_of_bits(Count)> bytes_{};
};

template <std::same_as<bool>... Values> bit_block(Values...) -> bit_block<sizeof...(Values)>;

} // namespace rtuwire

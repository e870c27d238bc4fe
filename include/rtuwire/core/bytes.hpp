// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Byte views, big-endian cursors, and arrays in place: of bytes whose number is known only after encoding, of equal
// values. Never reads or writes outside a span; never allocates; knows no frame, no field and no protocol.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Bytes to be read, owned and kept alive elsewhere. Passed by value; by reference only on a client's deepest
/// call path, because a small processor puts each copy on its stack.
using byte_view = std::span<std::byte const>;

/// Bytes to be written, owned and kept alive elsewhere.
using byte_span = std::span<std::byte>;

namespace detail {

/// A value in a word of its own: with one short instruction a small processor reaches a word 124 bytes behind the start of an
/// object, a byte only 31. For members that are used often and stand behind those.
template <typename T> class in_word {
public:
    constexpr in_word(T held) noexcept : word_{static_cast<std::uint32_t>(held)} {}
    [[nodiscard]] constexpr operator T() const noexcept { return static_cast<T>(word_); }

private:
    std::uint32_t word_;
};

/// The low eight bits of a value as a byte.
[[nodiscard]] constexpr std::byte to_byte(std::uint32_t value) noexcept
{
    return static_cast<std::byte>(value & 0xFFU);
}

/// A byte as a number.
[[nodiscard]] constexpr std::uint8_t to_u8(std::byte value) noexcept { return static_cast<std::uint8_t>(value); }

#if defined(__ARM_ARCH) && !defined(__ARM_FEATURE_UNALIGNED)
#define RTUWIRE_LOADS_SINGLE_BYTES 1
#else
#define RTUWIRE_LOADS_SINGLE_BYTES 0
#endif
/// Whether this processor loads a word from any address as single bytes: a Cortex-M0+ does.
inline constexpr bool loads_single_bytes = RTUWIRE_LOADS_SINGLE_BYTES == 1;
#undef RTUWIRE_LOADS_SINGLE_BYTES

/// Two bytes, most significant first, as a number.
[[nodiscard]] constexpr std::uint16_t to_u16(std::byte high, std::byte low) noexcept
{
    // Of a shift and an OR compilers make a load of a word and a swap. Where the load is not one instruction, that is
    // longer by two; of a product they do not make it.
    std::uint32_t const upper = to_u8(high);
    std::uint32_t const word = loads_single_bytes ? upper * 256U + to_u8(low) : (upper << 8U) | to_u8(low);
    return static_cast<std::uint16_t>(word);
}

/// The big-endian word at an offset. The caller has checked that `offset + 2 <= bytes.size()`.
[[nodiscard]] constexpr std::uint16_t u16_at(byte_view bytes, std::size_t offset) noexcept
{
    // From one pointer: compilers then load both bytes at once.
    std::byte const* const at = bytes.data() + offset;
    return to_u16(at[0], at[1]);
}

/// Writes a word as two bytes, most significant first.
constexpr void put_u16(std::byte* at, std::uint16_t value) noexcept
{
    at[0] = to_byte(std::uint32_t{value} >> 8U);
    at[1] = to_byte(value);
}

/// Eight bytes, the first in the lowest bits.
[[nodiscard]] constexpr std::uint64_t word_at(std::byte const* at) noexcept
{
    return std::uint64_t{to_u8(at[0])} | std::uint64_t{to_u8(at[1])} << 8U | std::uint64_t{to_u8(at[2])} << 16U |
           std::uint64_t{to_u8(at[3])} << 24U | std::uint64_t{to_u8(at[4])} << 32U |
           std::uint64_t{to_u8(at[5])} << 40U | std::uint64_t{to_u8(at[6])} << 48U | std::uint64_t{to_u8(at[7])} << 56U;
}

/// Whether two views hold the same bytes.
[[nodiscard]] constexpr bool same_bytes(byte_view left, byte_view right) noexcept
{
    if (left.size() != right.size()) {
        return false;
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i] != right[i]) {
            return false;
        }
    }
    return true;
}

} // namespace detail

/// Writes big-endian fields to the front of a span. A field that does not fit is not written, nor is
/// any after it, and `ok()` turns false for good.
class byte_writer {
public:
    /// Writes from the begin of `target`, which must outlive it.
    explicit constexpr byte_writer(byte_span target) noexcept
        : begin_{target.data()}, next_{begin_}, end_{begin_ + target.size()}
    {}

    /// Appends the low eight bits.
    constexpr void u8(std::uint32_t value) noexcept
    {
        if (room_for(1)) {
            *next_++ = detail::to_byte(value);
        }
    }

    /// Appends the low sixteen bits, most significant byte first.
    constexpr void u16(std::uint32_t value) noexcept
    {
        if (room_for(2)) {
            detail::put_u16(next_, static_cast<std::uint16_t>(value));
            next_ += 2;
        }
    }

    /// Appends bytes; all of them or none.
    constexpr void bytes(byte_view source) noexcept
    {
        if (room_for(source.size())) {
            for (std::byte const byte : source) {
                *next_++ = byte;
            }
        }
    }

    /// Appends `count` bytes that the caller writes, at once; null, and not ok, when they do not fit. Force-inlined,
    /// which saves 26 instructions of a request's encoding on a Cortex-M3 at -Os.
    [[nodiscard, gnu::always_inline]] constexpr std::byte* take(std::size_t count) noexcept
    {
        if (not room_for(count)) {
            return nullptr;
        }
        next_ += count;
        return next_ - count;
    }

    /// What has been written, at the start of the target.
    [[nodiscard]] constexpr byte_span written() const noexcept { return {begin_, size()}; }

    /// How many bytes have been written.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(next_ - begin_); }

    /// Whether every field so far fitted.
    [[nodiscard]] constexpr bool ok() const noexcept { return ok_; }

private:
    /// After a field that does not fit, there is no room for any other.
    constexpr bool room_for(std::size_t count) noexcept
    {
        bool const fits = count <= static_cast<std::size_t>(end_ - next_);
        if (not fits) {
            end_ = next_;
            ok_ = false;
        }
        return fits;
    }

    std::byte* begin_;
    std::byte* next_;
    std::byte* end_;
    bool ok_{true};
};

namespace detail {

/// Up to `Capacity` bytes, stored in place.
template <std::size_t Capacity> class fixed_buffer {
    static_assert(Capacity <= 0xFFFF, "a fixed_buffer counts its bytes in sixteen bits");

public:
    /// An empty buffer.
    constexpr fixed_buffer() noexcept = default;

    /// All of the storage, to be filled from its start and then kept with `resize`.
    [[nodiscard]] constexpr byte_span storage() & noexcept { return storage_; }
    [[nodiscard]] byte_span storage() && = delete;

    /// Keeps the first `size` bytes; a size above the capacity keeps the capacity.
    constexpr void resize(std::size_t size) noexcept
    {
        size_ = static_cast<std::uint16_t>(size < Capacity ? size : Capacity);
    }

    /// The bytes held, valid while the buffer lives and is not resized.
    [[nodiscard]] constexpr byte_view view() const& noexcept { return byte_view{storage_}.first(size_); }

    /// The bytes held, for functions that take a view.
    constexpr operator byte_view() const& noexcept { return view(); }

    /// A temporary buffer gives no view, not even to a function that would read it only once:
    /// `byte_view bytes = *encode(...)` does not show that its bytes are gone after the statement.
    template <std::same_as<byte_view> View = byte_view> [[nodiscard]] constexpr View view() const&& noexcept
    {
        return view_of_none<View>();
    }
    template <std::same_as<byte_view> View> constexpr operator View() const&& noexcept { return view_of_none<View>(); }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] static constexpr std::size_t capacity() noexcept { return Capacity; }

    /// Byte-wise equality with anything that is a view of bytes.
    friend constexpr bool operator==(fixed_buffer const& left, byte_view right) noexcept
    {
        return same_bytes(left.view(), right);
    }

private:
    template <typename View> static constexpr View view_of_none() noexcept
    {
        static_assert(not std::same_as<View, byte_view>,
                      "a frame that ends with its expression gives no view: give it a name first");
        return {};
    }

    std::array<std::byte, Capacity> storage_{};
    std::uint16_t size_{0};
};

/// `Size` times `value`, which may be of a type without a default value.
template <std::size_t Size, typename T> [[nodiscard]] constexpr std::array<T, Size> filled(T const& value) noexcept
{
    return [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        return std::array<T, Size>{(static_cast<void>(Index), value)...};
    }
    (std::make_index_sequence<Size>{});
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

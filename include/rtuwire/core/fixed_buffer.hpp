// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An array with a length, for bytes whose number is known only after encoding. Owns its storage,
// never allocates, and never holds more than its capacity.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

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

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

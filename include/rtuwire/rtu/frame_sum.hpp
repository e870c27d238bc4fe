// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// When a receiver sums a frame: byte by byte as they arrive, so that little is left to do at the last one, or all at
// once at the end, where the CRC's form is fastest over many bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Byte by byte.
template <crc_form Form = default_crc_form> class frame_sum {
public:
    constexpr void begin() noexcept { crc_ = running_crc16<Form>{}; }
    constexpr void add(std::byte byte) noexcept { crc_.add(byte); }

    /// Adds bytes and copies them.
    constexpr void copy(std::byte const* from, std::size_t count, std::byte* to) noexcept
    {
        for (std::byte const* const end = from + count; from != end; ++from) {
            crc_.add(*from);
            *to++ = *from;
        }
    }

    /// Whether the CRC of a frame is right, all of whose bytes were added.
    [[nodiscard]] constexpr bool is_right(byte_view) const noexcept { return crc_.value() == 0; }
    static constexpr void note_right() noexcept {}

private:
    /// A constant, so that no constructor computes it.
    static constexpr running_crc16<Form> no_bytes{0};

    [[no_unique_address]] running_crc16<Form> crc_{no_bytes}; ///< its padding is left to its holder
};

/// At the end.
template <> class frame_sum<crc_form::host> {
public:
    constexpr void begin() noexcept { is_right_ = false; }
    static constexpr void add(std::byte) noexcept {}

    static constexpr void copy(std::byte const* from, std::size_t count, std::byte* to) noexcept
    {
        if (not std::is_constant_evaluated()) {
            __builtin_memmove(to, from, count);
            return;
        }
        for (std::byte const* const end = from + count; from != end; ++from) {
            *to++ = *from;
        }
    }

    [[nodiscard]] constexpr bool is_right(byte_view frame) const noexcept
    {
        return is_right_ or crc16<crc_form::host>(frame) == 0;
    }

    /// The frame ended here, and its CRC was right.
    constexpr void note_right() noexcept { is_right_ = true; }

private:
    bool is_right_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

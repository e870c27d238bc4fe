// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Writes the blocks of a pcapng file, with the least significant byte first, and options in them.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Types of blocks and codes of options that are written here.
struct pcapng_code {
    static constexpr std::uint32_t section = 0x0A0D'0D0AU;
    static constexpr std::uint32_t byte_order = 0x1A2B'3C4DU;
    static constexpr std::uint32_t interface_description = 1;
    static constexpr std::uint32_t enhanced_packet = 6;

    static constexpr std::uint16_t comment = 1;
    static constexpr std::uint16_t interface_name = 2;
    static constexpr std::uint16_t packet_flags = 2;
    static constexpr std::uint16_t application = 4;
    static constexpr std::uint16_t bits_per_second = 8;
    static constexpr std::uint16_t time_resolution = 9;
};

/// Blocks one behind the other, in place. What does not fit is not written: who uses it knows that all of it does.
template <std::size_t Capacity> class block_builder {
public:
    constexpr void clear() noexcept { size_ = 0; }

    /// Begins a block; its length is filled in at its end.
    constexpr void begin(std::uint32_t type) noexcept
    {
        start_ = size_;
        u32(type);
        u32(0);
    }

    /// Ends the block with its length.
    constexpr void end() noexcept
    {
        std::uint32_t const length = static_cast<std::uint32_t>(size_ - start_) + 4U;
        u32(length);
        std::size_t const behind = size_;
        size_ = start_ + 4;
        u32(length);
        size_ = behind;
    }

    constexpr void u8(std::uint32_t value) noexcept
    {
        if (size_ < Capacity) {
            bytes_[size_++] = to_byte(value);
        }
    }
    constexpr void u16(std::uint32_t value) noexcept
    {
        u8(value);
        u8(value >> 8U);
    }
    constexpr void u32(std::uint32_t value) noexcept
    {
        u16(value);
        u16(value >> 16U);
    }
    /// In the order of the network, most significant byte first.
    constexpr void network_u16(std::uint32_t value) noexcept
    {
        u8(value >> 8U);
        u8(value);
    }
    constexpr void network_u32(std::uint32_t value) noexcept
    {
        network_u16(value >> 16U);
        network_u16(value);
    }
    constexpr void bytes(byte_view source) noexcept
    {
        for (std::byte const each : source) {
            u8(to_u8(each));
        }
    }
    constexpr void text(literal source) noexcept
    {
        for (char const each : source) {
            u8(static_cast<unsigned char>(each));
        }
    }

    /// Fills up to a multiple of four bytes.
    constexpr void pad() noexcept
    {
        while ((size_ - start_) % 4 != 0) {
            u8(0);
        }
    }

    /// The code and size of an option; its value and `pad` follow.
    constexpr void option(std::uint16_t code, std::size_t size) noexcept
    {
        u16(code);
        u16(static_cast<std::uint32_t>(size));
    }
    constexpr void option(std::uint16_t code, literal value) noexcept
    {
        option(code, value.size());
        text(value);
        pad();
    }
    constexpr void end_of_options() noexcept { u32(0); }

    [[nodiscard]] constexpr byte_view view() const noexcept { return byte_view{bytes_}.first(size_); }

private:
    std::array<std::byte, Capacity> bytes_{};
    std::size_t start_{0};
    std::size_t size_{0};
};

} // namespace rtuwire

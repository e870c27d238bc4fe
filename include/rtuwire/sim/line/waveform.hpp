// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A section of the signal on a two-wire line, bit by bit: idle high, pulled low by any sender.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The bits of one busy period. Bits beyond its end are idle.
class waveform {
public:
    static constexpr std::size_t capacity = 16'384;

    constexpr waveform() noexcept { words_.fill(idle); }

    /// The number of bits up to the last one written.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

    /// Writes `count` bits, at most 16, over those already there: low wins.
    constexpr void lay(std::size_t at, std::uint32_t bits, std::size_t count) noexcept
    {
        if (at + count > capacity) {
            return;
        }
        std::uint64_t const lows = ~std::uint64_t{bits} & ((std::uint64_t{1} << count) - 1);
        std::size_t const word = at / word_bits;
        std::size_t const shift = at % word_bits;
        words_[word] &= ~(lows << shift);
        if (shift + count > word_bits) {
            words_[word + 1] &= ~(lows >> (word_bits - shift));
        }
        touch(at + count);
    }

    /// Inverts a bit.
    constexpr void flip(std::size_t at) noexcept
    {
        if (at < capacity) {
            words_[at / word_bits] ^= std::uint64_t{1} << (at % word_bits);
            touch(at + 1);
        }
    }

    /// The 16 bits from a place on.
    [[nodiscard]] constexpr std::uint32_t bits_from(std::size_t at) const noexcept
    {
        std::size_t const word = at / word_bits;
        std::size_t const shift = at % word_bits;
        std::uint64_t const low = word < words_.size() ? words_[word] : idle;
        std::uint64_t const high = word + 1 < words_.size() ? words_[word + 1] : idle;
        std::uint64_t const both = shift == 0 ? low : low >> shift | high << (word_bits - shift);
        return static_cast<std::uint32_t>(both & 0xFFFFU);
    }

    /// All idle again.
    constexpr void clear() noexcept
    {
        for (std::size_t word = 0; word * word_bits < size_; ++word) {
            words_[word] = idle;
        }
        size_ = 0;
    }

private:
    static constexpr std::size_t word_bits = 64;
    static constexpr std::uint64_t idle = ~std::uint64_t{0};

    constexpr void touch(std::size_t end) noexcept
    {
        end = end < capacity ? end : capacity;
        size_ = end > size_ ? end : size_;
    }

    std::array<std::uint64_t, capacity / word_bits> words_{};
    std::size_t size_{0};
};

} // namespace rtuwire::sim

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS (Modbus over Serial Line V1.02, 6.2.2): start FFFF, reflected polynomial A001, no final XOR;
// the low byte is sent first. One function in several forms, all with the same result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

// From tables: the effect of shifting out 4 or 8 bits at some distance from the end.
namespace crc16_tables {

/// The polynomial, reflected, without its highest power.
inline constexpr std::uint32_t polynomial = 0xA001;

/// A state after `bits` zero bits.
[[nodiscard]] constexpr std::uint16_t shifted(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = (state >> 1U) ^ ((state & 1U) != 0 ? polynomial : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

inline constexpr std::uint16_t nibble[16] = {shifted(0, 4),  shifted(1, 4),  shifted(2, 4),  shifted(3, 4),
                                             shifted(4, 4),  shifted(5, 4),  shifted(6, 4),  shifted(7, 4),
                                             shifted(8, 4),  shifted(9, 4),  shifted(10, 4), shifted(11, 4),
                                             shifted(12, 4), shifted(13, 4), shifted(14, 4), shifted(15, 4)};

/// What a byte with `k` bytes behind it adds to the CRC; 512 bytes for each distance. Plain arrays, and the
/// sum of two entries where that is possible: the compiler computes them for each file that uses them.
template <std::size_t Count> struct distances {
    std::uint16_t at[Count][256]{};

    /// Computes the tables.
    constexpr distances() noexcept
    {
        for (unsigned bit = 1; bit < 256; bit *= 2) {
            at[0][bit] = shifted(bit, 8);
        }
        add_up(at[0]);
        for (std::size_t k = 1; k < Count; ++k) {
            for (unsigned bit = 1; bit < 256; bit *= 2) {
                std::uint16_t const nearer = at[k - 1][bit];
                at[k][bit] = static_cast<std::uint16_t>((nearer >> 8U) ^ at[0][nearer & 0xFFU]);
            }
            add_up(at[k]);
        }
    }

private:
    /// Computes all entries from those of single bits.
    static constexpr void add_up(std::uint16_t (&table)[256]) noexcept
    {
        for (unsigned bit = 2; bit < 256; bit *= 2) {
            std::uint32_t const one = table[bit]; // read once: a compiler takes as long as a store for it
            for (unsigned i = 1; i < bit; ++i) {
                table[bit + i] = static_cast<std::uint16_t>(one ^ table[i]);
            }
        }
    }
};

template <std::size_t Count> inline constexpr distances<Count> at_distance{};

/// The table of a single byte.
[[nodiscard]] constexpr std::uint16_t of_byte(std::uint32_t byte) noexcept
{
    return at_distance<1>.at[0][byte & 0xFFU];
}

/// The tables for eight bytes at a time.
inline constexpr auto const& eight = at_distance<8>.at;

/// The CRC of eight bytes, the first in the lowest bits, when it starts from 0.
[[nodiscard]] constexpr std::uint16_t of_word(std::uint64_t bytes) noexcept
{
    return static_cast<std::uint16_t>(eight[7][bytes & 0xFFU] ^ eight[6][bytes >> 8U & 0xFFU] ^
                                      eight[5][bytes >> 16U & 0xFFU] ^ eight[4][bytes >> 24U & 0xFFU] ^
                                      eight[3][bytes >> 32U & 0xFFU] ^ eight[2][bytes >> 40U & 0xFFU] ^
                                      eight[1][bytes >> 48U & 0xFFU] ^ eight[0][bytes >> 56U]);
}

/// What the start value FFFF adds to the CRC, by the number of bytes, 8 at most.
inline constexpr std::uint16_t started[] = {shifted(0xFFFF, 0),  shifted(0xFFFF, 8),  shifted(0xFFFF, 16),
                                            shifted(0xFFFF, 24), shifted(0xFFFF, 32), shifted(0xFFFF, 40),
                                            shifted(0xFFFF, 48), shifted(0xFFFF, 56), shifted(0xFFFF, 64)};

/// The CRC of up to 8 bytes: look-ups that do not wait for each other. Loaded byte by byte, because a frame
/// that was just written byte by byte cannot be loaded in words without waiting.
[[nodiscard]] constexpr std::uint16_t of_few(std::byte const* at, std::size_t size) noexcept
{
    std::byte const* const end = at + size;
    auto const add = [&](std::uint16_t crc, std::ptrdiff_t k) {
        return static_cast<std::uint16_t>(crc ^ eight[k - 1][to_u8(end[-k])]);
    };
    std::uint16_t crc = started[size];
    switch (size) {
    case 8: crc = add(crc, 8); [[fallthrough]];
    case 7: crc = add(crc, 7); [[fallthrough]];
    case 6: crc = add(crc, 6); [[fallthrough]];
    case 5: crc = add(crc, 5); [[fallthrough]];
    case 4: crc = add(crc, 4); [[fallthrough]];
    case 3: crc = add(crc, 3); [[fallthrough]];
    case 2: crc = add(crc, 2); [[fallthrough]];
    case 1: crc = add(crc, 1); [[fallthrough]];
    default: return crc;
    }
}

/// The CRC after eight more bytes.
[[nodiscard]] constexpr std::uint16_t after_eight(std::uint32_t crc, std::byte const* at) noexcept
{
    return static_cast<std::uint16_t>(eight[7][to_u8(at[0]) ^ (crc & 0xFFU)] ^ eight[6][to_u8(at[1]) ^ (crc >> 8U)] ^
                                      eight[5][to_u8(at[2])] ^ eight[4][to_u8(at[3])] ^ eight[3][to_u8(at[4])] ^
                                      eight[2][to_u8(at[5])] ^ eight[1][to_u8(at[6])] ^ eight[0][to_u8(at[7])]);
}

/// The CRC of more than 8 bytes: up to 8 at the front, then eight at a time.
[[nodiscard]] constexpr std::uint16_t of_some(byte_view bytes) noexcept
{
    std::byte const* at = bytes.data();
    std::byte const* const end = at + bytes.size();
    std::size_t const odd = (bytes.size() - 1) % 8 + 1;
    std::uint16_t crc = of_few(at, odd);
    at += odd;
    do {
        crc = after_eight(crc, at);
        at += 8;
    } while (at != end);
    return crc;
}

} // namespace crc16_tables

// Of many bytes on 64-bit processors: up to eight words of the message side by side, which do not wait
// for each other, are moved by shifts alone, and the last word by tables. The polynomial is (x + 1) T with
// T = x^15 + x + 1. Modulo T a high power is the sum of two low ones, x^16 = x^2 + x, and squaring keeps that so:
// x^(64 k) is two shifts for each k that is a power of 2. Modulo x + 1 the message is its parity. Of the two remainders
// modulo T that fit 16 bits, r and r + T, the CRC is the one with the parity of the message. All words are reflected:
// bit 0 is the highest power.
namespace crc16_words {

/// Whether a word has an odd number of bits set: 1 or 0.
[[nodiscard]] constexpr std::uint32_t parity_of(std::uint32_t word) noexcept
{
    word ^= word >> 16U;
    word ^= word >> 8U;
    word ^= word >> 4U;
    return (0x6996U >> (word & 0xFU)) & 1U;
}

/// The CRC of a message that was folded into one word: its remainder modulo T whose parity is that of the message.
[[nodiscard]] constexpr std::uint16_t finish(std::uint64_t word, std::uint64_t parity) noexcept
{
    constexpr std::uint32_t t = 0xC001;
    std::uint32_t const remainder = crc16_tables::of_word(word);
    return static_cast<std::uint16_t>(
        remainder ^ (t & (0U - parity_of(remainder ^ static_cast<std::uint32_t>(parity >> 32U ^ parity)))));
}

/// Several words side by side, the first of the message first.
template <std::size_t Count> using lanes = std::array<std::uint64_t, Count>;

/// x^(64 Count) as two shifts: the part that stays in a word, and the part carried into the one before.
template <std::size_t Count> struct power {
    static constexpr int low = static_cast<int>(4 * Count);
    static constexpr int high = static_cast<int>(8 * Count);

    [[nodiscard]] static constexpr std::uint64_t staying(std::uint64_t word) noexcept
    {
        return word >> low ^ (high < 64 ? word >> (high % 64) : 0U);
    }
    [[nodiscard]] static constexpr std::uint64_t leaving(std::uint64_t word) noexcept
    {
        return word << (64 - low) ^ word << (64 - high);
    }
};

/// Lanes times x^(64 Count), and the words that follow in the message.
template <std::size_t Count, std::size_t... Index>
[[nodiscard]] constexpr lanes<Count> fold(lanes<Count> left, lanes<Count> const& next,
                                          std::index_sequence<Index...>) noexcept
{
    left[Count - 1] ^= power<Count>::leaving(left[0]);
    return {(next[Index] ^ power<Count>::staying(left[Index]) ^
             (Index + 1 < Count ? power<Count>::leaving(left[(Index + 1) % Count]) : 0U))...};
}
template <std::size_t Count>
[[nodiscard]] constexpr lanes<Count> fold(lanes<Count> const& left, lanes<Count> const& next) noexcept
{
    return fold<Count>(left, next, std::make_index_sequence<Count>{});
}

/// The first half folded onto the second.
template <std::size_t Half, std::size_t... Index>
[[nodiscard]] constexpr lanes<Half> halved(lanes<2 * Half> const& whole, std::index_sequence<Index...>) noexcept
{
    return fold<Half>(lanes<Half>{whole[Index]...}, lanes<Half>{whole[Half + Index]...});
}
template <std::size_t Half> [[nodiscard]] constexpr lanes<Half> halved(lanes<2 * Half> const& whole) noexcept
{
    return halved<Half>(whole, std::make_index_sequence<Half>{});
}

/// The same words with zeros before them, which change no remainder.
template <std::size_t Count, std::size_t... Index>
[[nodiscard]] constexpr lanes<2 * Count> doubled(lanes<Count> const& words, std::index_sequence<Index...>) noexcept
{
    return {(Index < Count ? 0U : words[Index % Count])...};
}
template <std::size_t Count> [[nodiscard]] constexpr lanes<2 * Count> doubled(lanes<Count> const& words) noexcept
{
    return doubled<Count>(words, std::make_index_sequence<2 * Count>{});
}

/// The words of a message, from its front.
class words {
public:
    /// Of at least 8 bytes. The odd ones at the front are `head()`, the rest comes in whole words.
    constexpr explicit words(byte_view bytes) noexcept : at_{bytes.data()}, count_{bytes.size() / 8}
    {
        // The CRC starts from FFFF: that is, with its first two bytes inverted.
        if (std::size_t const odd = bytes.size() % 8; odd != 0) {
            std::size_t const shift = 8 * (8 - odd);
            head_ = (word_at(at_) ^ 0xFFFFU) << shift;
            start_ = odd == 1 ? 0xFFU : 0U;
            at_ += odd;
            parity_ = head_;
        }
    }

    [[nodiscard]] constexpr std::uint64_t head() const noexcept { return head_; }
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
    [[nodiscard]] constexpr std::uint64_t parity() const noexcept { return parity_; }

    template <std::size_t Count> [[nodiscard]] constexpr lanes<Count> take() noexcept
    {
        return take<Count>(std::make_index_sequence<Count>{});
    }

private:
    template <std::size_t Count, std::size_t... Index>
    constexpr lanes<Count> take(std::index_sequence<Index...>) noexcept
    {
        lanes<Count> next{word_at(at_ + 8 * Index)...};
        next[0] ^= start_;
        start_ = 0;
        at_ += 8 * Count;
        ((parity_ ^= next[Index]), ...);
        return next;
    }

    std::byte const* at_;
    std::size_t count_;
    std::uint64_t head_{0};
    std::uint64_t start_{0xFFFF};
    std::uint64_t parity_{0};
};

/// The CRC of at least 8 bytes, in up to eight lanes.
[[nodiscard]] constexpr std::uint16_t of_words(byte_view bytes) noexcept
{
    words message{bytes};
    lanes<1> one{message.head()};
    if ((message.count() & 1U) != 0) {
        one = fold(one, message.take<1>());
    }
    lanes<2> two = doubled(one);
    if ((message.count() & 2U) != 0) {
        two = fold(two, message.take<2>());
    }
    lanes<4> four = doubled(two);
    if ((message.count() & 4U) != 0) {
        four = fold(four, message.take<4>());
    }
    if (std::size_t blocks = message.count() / 8; blocks > 0) {
        lanes<8> eight = fold(doubled(four), message.take<8>());
        while (--blocks > 0) {
            eight = fold(eight, message.take<8>());
        }
        four = halved<4>(eight);
    }
    return finish(halved<1>(halved<2>(four))[0], message.parity());
}

} // namespace crc16_words
} // namespace detail

/// How the CRC is computed, and what tables that needs.
enum class crc_form : std::uint8_t {
    bitwise,      ///< nothing
    nibble_table, ///< 32 bytes
    byte_table,   ///< 512 bytes
    host,         ///< 4 KiB; up to 64 bytes at a time, for 64-bit processors
};

namespace detail {

/// The form in use: the program's choice by `-DRTUWIRE_CRC_FORM=byte_table`, or `nibble_table` on 32 bits and `host`
/// elsewhere.
inline constexpr crc_form default_crc_form = crc_form::RTUWIRE_CRC_FORM;

} // namespace detail

/// A CRC that is updated byte by byte, so that a receiver has it when the last byte arrives. Over a whole
/// frame, its two CRC bytes included, the value is zero exactly when the CRC is right. `host` processes single bytes by
/// the byte table.
template <crc_form Form = detail::default_crc_form> class running_crc16 {
public:
    /// Of no byte yet.
    constexpr running_crc16() noexcept = default;
    /// Continues after bytes whose CRC is `from`.
    explicit constexpr running_crc16(std::uint16_t from) noexcept : state_{from} {}

    /// Takes the next byte.
    constexpr void add(std::byte byte) noexcept
    {
        std::uint32_t mixed = std::uint32_t{state_} ^ detail::to_u8(byte);
        if constexpr (Form == crc_form::bitwise) {
            state_ = detail::crc16_tables::shifted(mixed, 8);
        } else if constexpr (Form == crc_form::nibble_table) {
            mixed = (mixed >> 4U) ^ detail::crc16_tables::nibble[mixed & 0xFU];
            mixed = (mixed >> 4U) ^ detail::crc16_tables::nibble[mixed & 0xFU];
            state_ = static_cast<std::uint16_t>(mixed);
        } else {
            state_ = static_cast<std::uint16_t>((mixed >> 8U) ^ detail::crc16_tables::of_byte(mixed));
        }
    }

    /// The CRC of everything taken so far; FFFF before the first byte.
    [[nodiscard]] constexpr std::uint16_t value() const noexcept { return state_; }

private:
    std::uint16_t state_{0xFFFF};
};

namespace detail {

/// More than 8 bytes. Not inlined, so that the choice by size is inlined where the size is known.
[[nodiscard, gnu::noinline]] constexpr std::uint16_t crc16_of_many(byte_view bytes) noexcept
{
    return bytes.size() <= 32 ? crc16_tables::of_some(bytes) : crc16_words::of_words(bytes);
}

} // namespace detail

/// The CRC of a sequence of bytes.
template <crc_form Form = detail::default_crc_form>
[[nodiscard]] constexpr std::uint16_t crc16(byte_view bytes) noexcept
{
    if constexpr (Form == crc_form::host) {
        return bytes.size() <= 8 ? detail::crc16_tables::of_few(bytes.data(), bytes.size())
                                 : detail::crc16_of_many(bytes);
    } else {
        running_crc16<Form> crc;
        std::byte const* at = bytes.data();
        std::byte const* const end = at + bytes.size();
        if (at != end) {
            do { // tested at its end: an instruction less for each byte where a compiler optimises for size
                crc.add(*at++);
            } while (at != end);
        }
        return crc.value();
    }
}

namespace detail {

/// When a receiver sums a frame: byte by byte as they arrive, so that little is left to do at the last one.
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

/// All at once at the end, where this form is fastest over many bytes.
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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS by carry-less multiplication, where the target has it: PCLMULQDQ (-mpclmul), PMULL
// (-march=armv8-a+crypto) or VMULL.P64 (-mfpu=crypto-neon-fp-armv8). Each word of the message is multiplied
// by the power of x that follows from its distance to the end, modulo the polynomial, so that no product
// waits for another; the sum has 80 bits, and two more products in a row give its CRC. All words are
// reflected: bit 0 is the highest power.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16/algebra.hpp>
#include <rtuwire/core/crc16/tables.hpp>
#include <rtuwire/core/version.hpp>

#ifdef RTUWIRE_CARRYLESS_X86
#include <wmmintrin.h>
#elif defined(RTUWIRE_CARRYLESS_ARM)
#include <arm_neon.h>
#endif

namespace rtuwire::inline RTUWIRE_BUILD::crc16_carryless {

#ifdef RTUWIRE_CARRYLESS_X86
inline constexpr bool is_available = true;

/// 16 bytes of the message as two words.
using block = __m128i;

inline block block_of(std::uint64_t first, std::uint64_t second) noexcept
{
    return _mm_set_epi64x(static_cast<long long>(second), static_cast<long long>(first));
}
inline block block_at(std::byte const* at) noexcept { return _mm_loadu_si128(reinterpret_cast<block const*>(at)); }
inline std::uint64_t second_of(block words) noexcept
{
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(words, words)));
}
inline block sum(block left, block right) noexcept { return _mm_xor_si128(left, right); }
/// The second word of one and the first word of the next.
inline block between(block one, block next) noexcept
{
    return _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(one), _mm_castsi128_pd(next), 1));
}
template <int Bits> block shifted_down(block words) noexcept { return _mm_srli_epi64(words, Bits); }
inline block firsts(block left, block right) noexcept { return _mm_clmulepi64_si128(left, right, 0x00); }
inline block seconds(block left, block right) noexcept { return _mm_clmulepi64_si128(left, right, 0x11); }
#elif defined(RTUWIRE_CARRYLESS_ARM)
inline constexpr bool is_available = true;

using block = uint64x2_t;

inline block block_of(std::uint64_t first, std::uint64_t second) noexcept
{
    return vcombine_u64(vcreate_u64(first), vcreate_u64(second));
}
inline block block_at(std::byte const* at) noexcept
{
    return vreinterpretq_u64_u8(vld1q_u8(reinterpret_cast<std::uint8_t const*>(at)));
}
inline std::uint64_t second_of(block words) noexcept { return vgetq_lane_u64(words, 1); }
inline block sum(block left, block right) noexcept { return veorq_u64(left, right); }
inline block between(block one, block next) noexcept { return vextq_u64(one, next, 1); }
template <int Bits> block shifted_down(block words) noexcept { return vshrq_n_u64(words, Bits); }
inline block firsts(block left, block right) noexcept
{
    return vreinterpretq_u64_p128(vmull_p64(vgetq_lane_u64(left, 0), vgetq_lane_u64(right, 0)));
}
inline block seconds(block left, block right) noexcept
{
    return vreinterpretq_u64_p128(vmull_p64(vgetq_lane_u64(left, 1), vgetq_lane_u64(right, 1)));
}
#else
inline constexpr bool is_available = false;
#endif

#if defined(RTUWIRE_CARRYLESS_X86) || defined(RTUWIRE_CARRYLESS_ARM)

/// The first words multiplied, and the second words multiplied, added up.
inline block product(block left, block right) noexcept { return sum(firsts(left, right), seconds(left, right)); }

/// P, reflected: bit n is the factor of z^n, and z^0 is x^16.
inline constexpr std::uint32_t polynomial = crc16_tables::polynomial << 1U | 1U;

/// The state that zero bits turn into this state: `crc16_tables::shifted` backwards.
[[nodiscard]] constexpr std::uint16_t shifted_back(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = state << 1U ^ ((state & 0x8000U) != 0 ? polynomial : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

/// This many blocks are multiplied at a time, and the sum of those before them.
inline constexpr std::size_t most_blocks = 15;

/// The factors for a block with k blocks behind it: x^(128 k + 64) and x^(128 k), each less one x, because a
/// product of reflected words has one too many.
struct factors {
    std::uint64_t first, second;
};
struct factor_table {
    factors of[most_blocks + 1]{};

    constexpr factor_table() noexcept
    {
        std::uint32_t power = shifted_back(0x8000, 1);
        for (factors& each : of) {
            each.second = std::uint64_t{power} << 48U;
            power = crc16_tables::shifted(power, 64);
            each.first = std::uint64_t{power} << 48U;
            power = crc16_tables::shifted(power, 64);
        }
    }
};

inline constexpr factor_table powers{};

/// A block times the power of x for `behind` blocks after it: 80 bits at the end of a block.
inline block moved(block bytes, std::size_t behind) noexcept
{
    return product(bytes, block_of(powers.of[behind].first, powers.of[behind].second));
}

/// The CRC starts from FFFF. With zeros before the message it starts from the state that they turn into FFFF.
struct start_table {
    std::uint16_t before[16]{};

    constexpr start_table() noexcept
    {
        for (unsigned zeros = 0; zeros < 16; ++zeros) {
            before[zeros] = shifted_back(0xFFFF, 8 * zeros);
        }
    }
};
inline constexpr start_table starts{};

/// The first 1 to 16 bytes of a message of 8 at least, as a block with zeros before them; the start
/// with them.
inline block head_of(std::byte const* at, std::size_t size) noexcept
{
    std::uint64_t const start = starts.before[16 - size];
    std::uint64_t const front = word_at(at);
    return size <= 8 ? block_of(start, front << 8 * (8 - size))
                     : block_of(start ^ front << 8 * (16 - size), word_at(at + size - 8));
}

/// Adds blocks that are multiplied: those with fewer than `from` blocks behind them, but `to` at least.
inline block with_blocks(block rest, std::byte const* at, std::size_t from, std::size_t to) noexcept
{
    for (; from != to; at += 16) {
        rest = sum(rest, moved(block_at(at), --from));
    }
    return rest;
}

/// Adds up to seven blocks and the eight after them. The former need no product: modulo T
/// (crc16/algebra.hpp), x^1024 is x^128 + x^64, so that eight blocks further on a block counts one block
/// before that place, and half a block before it. Modulo x + 1 the two are 0, but x^1024 is 1: T times the
/// block makes up for that, as T is 1 there, 0 modulo T, and stays itself times x.
inline block with_more_blocks(block rest, std::byte const* at, std::size_t count) noexcept
{
    constexpr std::uint64_t t = std::uint64_t{crc16_algebra::t} << 48U;
    std::byte const* onto = at + 16 * count;
    rest = with_blocks(rest, onto, 8, count + 1);
    onto += 16 * (7 - count);
    block one = block_of(0, 0);
    block all = block_of(0, 0);
    for (; count != 0; --count, at += 16, onto += 16) {
        block const next = block_at(at);
        block const added = sum(next, between(one, next));
        rest = sum(rest, moved(sum(block_at(onto), added), count));
        all = sum(all, next);
        one = next;
    }
    block const last = sum(block_at(onto), between(one, block_of(0, 0)));
    return sum(sum(rest, moved(last, 0)), product(all, block_of(t, t)));
}

/// What comes before, and up to `most_blocks` blocks after it, as 80 bits at the end of a block.
inline block folded(block before, std::byte const* at, std::size_t count) noexcept
{
    block const rest = moved(before, count);
    return count <= 8 ? with_blocks(rest, at, count, 0) : with_more_blocks(rest, at, count - 8);
}

/// 64 digits of the series 1 / P in z, from that of z^`from` on.
[[nodiscard]] constexpr std::uint64_t reciprocal(unsigned from) noexcept
{
    std::uint64_t digits = 0;
    std::uint32_t rest = 1;
    for (unsigned n = 0; n < from + 64; ++n) {
        std::uint32_t const digit = rest & 1U;
        digits = digits >> 1U | std::uint64_t{digit} << 63U;
        rest = (digit != 0 ? rest ^ polynomial : rest) >> 1U;
    }
    return digits;
}

/// The CRC that 80 bits at the end of a block leave. Times x^16 they are P times some factor, plus the CRC;
/// only the last 16 digits of that factor reach to where the CRC stands. They are those of the bits times
/// 1 / P: the last of the first word of two products, one of the word, and one of the 16 bits before it,
/// for which the reciprocal's first 16 digits come too early.
[[nodiscard]] inline std::uint16_t crc_of(block rest) noexcept
{
    constexpr std::uint64_t for_front = reciprocal(16);
    constexpr std::uint64_t for_word = reciprocal(0);
    block const reciprocals = block_of(for_front, for_word);
    block const factor = sum(firsts(shifted_down<48>(rest), reciprocals), seconds(rest, reciprocals));
    return static_cast<std::uint16_t>(second_of(firsts(factor, block_of(polynomial, 0))));
}

/// The CRC of more than 16 bytes.
[[nodiscard]] inline std::uint16_t of_blocks(byte_view bytes) noexcept
{
    std::size_t const odd = (bytes.size() - 1) % 16 + 1;
    std::byte const* at = bytes.data() + odd;
    std::byte const* const end = bytes.data() + bytes.size();
    block rest = head_of(bytes.data(), odd);
    std::size_t count = ((bytes.size() - odd) / 16 - 1) % most_blocks + 1;
    do {
        rest = folded(rest, at, count);
        at += 16 * count;
        count = most_blocks;
    } while (at != end);
    return crc_of(rest);
}

#else
/// Declared for targets that cannot multiply so, and never called.
[[nodiscard]] std::uint16_t of_blocks(byte_view bytes) noexcept;
#endif

} // namespace rtuwire::crc16_carryless

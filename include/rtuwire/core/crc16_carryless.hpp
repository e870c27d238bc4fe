// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS by carry-less multiplication, where the target has it: PCLMULQDQ (-mpclmul), PMULL
// (-march=armv8-a+crypto) or VMULL.P64 (-mfpu=crypto-neon-fp-armv8). 16 octets are one factor, a power
// of x modulo the polynomial is the other; the last 16 octets are left to tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16_algebra.hpp>
#include <rtuwire/core/crc16_tables.hpp>

#if defined(__PCLMUL__)
#include <wmmintrin.h>
#define RTUWIRE_CARRYLESS_X86
#elif defined(__ARM_NEON) && (defined(__ARM_FEATURE_AES) || defined(__ARM_FEATURE_CRYPTO))
#include <arm_neon.h>
#define RTUWIRE_CARRYLESS_ARM // PMULL, or VMULL.P64 on a 32-bit Arm
#endif

namespace rtuwire::crc16_carryless {

/// x^n modulo the polynomial, reflected in 64 bits.
[[nodiscard]] constexpr std::uint64_t power_of_x(unsigned n) noexcept
{
    return std::uint64_t{crc16_tables::shifted(0x8000, n)} << 48U;
}

#ifdef RTUWIRE_CARRYLESS_X86
inline constexpr bool is_available = true;

/// 16 octets of the message, the first in the low word.
using block = __m128i;

inline block block_of(std::uint64_t first, std::uint64_t second) noexcept
{
    return _mm_set_epi64x(static_cast<long long>(second), static_cast<long long>(first));
}
inline block block_at(std::byte const* at) noexcept
{
    return _mm_loadu_si128(reinterpret_cast<block const*>(at));
}
inline std::uint64_t first_of(block octets) noexcept
{
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(octets));
}
inline std::uint64_t second_of(block octets) noexcept
{
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(octets, octets)));
}
inline block sum(block left, block right) noexcept { return _mm_xor_si128(left, right); }
/// The first word times the first of the factors, and the second times the second.
inline block product(block octets, block factors) noexcept
{
    return sum(_mm_clmulepi64_si128(octets, factors, 0x00),
               _mm_clmulepi64_si128(octets, factors, 0x11));
}
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
inline std::uint64_t first_of(block octets) noexcept { return vgetq_lane_u64(octets, 0); }
inline std::uint64_t second_of(block octets) noexcept { return vgetq_lane_u64(octets, 1); }
inline block sum(block left, block right) noexcept { return veorq_u64(left, right); }
inline block product(block octets, block factors) noexcept
{
    auto const times = [](std::uint64_t left, std::uint64_t right) {
        return vreinterpretq_u64_p128(vmull_p64(left, right));
    };
    return sum(times(first_of(octets), first_of(factors)),
               times(second_of(octets), second_of(factors)));
}
#else
inline constexpr bool is_available = false;
#endif

#if defined(RTUWIRE_CARRYLESS_X86) || defined(RTUWIRE_CARRYLESS_ARM)

/// Octets moved `Bits` further from the end of the message. A product of reflected words has one
/// power of x too many.
template <unsigned Bits> inline block moved(block octets) noexcept
{
    constexpr std::uint64_t of_first = power_of_x(Bits + 63);
    constexpr std::uint64_t of_second = power_of_x(Bits - 1);
    return product(octets, block_of(of_first, of_second));
}

/// Blocks side by side, the first of the message first.
struct four_blocks {
    block a, b, c, d;
};

/// The octets of a message that come before its last whole blocks, as a block with zeros before it. The
/// CRC starts from FFFF: that is, with the first two octets inverted.
inline block head_of(byte_view octets) noexcept
{
    constexpr std::uint64_t start = 0xFFFF;
    std::size_t const odd = octets.size() % 16;
    std::uint64_t const front = word_at(octets.data()) ^ start;
    if (odd == 0) {
        return block_of(0, 0);
    }
    if (odd <= 8) {
        return block_of(0, front << 8 * (8 - odd));
    }
    std::uint64_t const second = word_at(octets.data() + odd - 8);
    return block_of(front << 8 * (16 - odd), odd == 9 ? second ^ (start >> 8U) : second);
}

/// What of the start is left for the first whole block.
inline block start_of(byte_view octets) noexcept
{
    std::size_t const odd = octets.size() % 16;
    return block_of(odd == 0 ? 0xFFFFU : odd == 1 ? 0xFFU : 0U, 0);
}

/// The front of a message, so that what follows comes in fours: zeros before it change nothing.
inline four_blocks front_of(byte_view octets, std::byte const* at) noexcept
{
    block const none = block_of(0, 0);
    block const head = head_of(octets);
    if (octets.size() / 16 % 4 == 0) {
        return {none, none, none, head};
    }
    block const first = sum(block_at(at), start_of(octets));
    switch (octets.size() / 16 % 4) {
    case 1: return {none, none, head, first};
    case 2: return {none, head, first, block_at(at + 16)};
    default: return {head, first, block_at(at + 16), block_at(at + 32)};
    }
}

/// What 16 octets in two words, the first octet lowest, leave of a CRC that starts from 0.
[[nodiscard]] inline std::uint16_t of_block(std::uint64_t first, std::uint64_t second) noexcept
{
    auto const& tables = crc16_tables::at_distance<16>.at;
    std::uint32_t crc = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        crc ^= std::uint32_t{tables[15 - i][first >> 8 * i & 0xFFU]} ^
               tables[7 - i][second >> 8 * i & 0xFFU];
    }
    return static_cast<std::uint16_t>(crc);
}

/// The CRC of at least 16 octets.
[[nodiscard]] inline std::uint16_t multiply(byte_view octets) noexcept
{
    std::byte const* at = octets.data() + octets.size() % 16;
    std::byte const* const end = octets.data() + octets.size();
    four_blocks all = front_of(octets, at);
    std::size_t const in_front = octets.size() / 16 % 4;
    block start = in_front == 0 ? start_of(octets) : block_of(0, 0);
    for (at += 16 * in_front; at != end; at += 64) {
        all = {sum(moved<512>(all.a), sum(block_at(at), start)),
               sum(moved<512>(all.b), block_at(at + 16)), sum(moved<512>(all.c), block_at(at + 32)),
               sum(moved<512>(all.d), block_at(at + 48))};
        start = block_of(0, 0);
    }
    block const rest =
        sum(sum(moved<384>(all.a), moved<256>(all.b)), sum(moved<128>(all.c), all.d));
    return of_block(first_of(rest), second_of(rest));
}

#endif

/// The CRC of at least 16 octets; by algebra in the compiler, and where the target cannot multiply so.
[[nodiscard]] constexpr std::uint16_t of_words(byte_view octets) noexcept
{
#if defined(RTUWIRE_CARRYLESS_X86) || defined(RTUWIRE_CARRYLESS_ARM)
    if (not std::is_constant_evaluated()) {
        return multiply(octets);
    }
#endif
    return crc16_algebra::of_words(octets);
}

} // namespace rtuwire::crc16_carryless

#undef RTUWIRE_CARRYLESS_X86
#undef RTUWIRE_CARRYLESS_ARM

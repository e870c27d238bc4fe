// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What can go wrong with a frame on a line, and what of it becomes of one frame: the simulated line and the tool that
// disturbs a real one decide by the same rates and make the same bytes, by pseudo-random numbers that the same seed makes
// anew. Knows neither a line nor a clock.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// A xorshift generator (Marsaglia 2003).
class random_source {
public:
    explicit constexpr random_source(std::uint32_t seed) noexcept
        : state_{0x9E37'79B9'7F4A'7C15U ^ (std::uint64_t{seed} << 17U | seed)}
    {
        for (unsigned warm = 0; warm < 8; ++warm) {
            next();
        }
    }

    constexpr std::uint32_t next() noexcept
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<std::uint32_t>(state_ >> 32U);
    }

    /// 0 to `limit` - 1; 0 for a limit of 0.
    constexpr std::uint32_t below(std::uint32_t limit) noexcept
    {
        return static_cast<std::uint32_t>((std::uint64_t{next()} * limit) >> 32U);
    }

    /// Whether an event of this probability (in a million) occurs; draws a number only where it may.
    constexpr bool happens(std::uint32_t in_a_million) noexcept
    {
        return in_a_million > 0 and below(1'000'000) < in_a_million;
    }

private:
    std::uint64_t state_;
};

} // namespace detail

namespace sim {

using random_source = detail::random_source;

/// How often each fault occurs, in a million.
struct line_faults {
    std::uint32_t bit_errors{0}; ///< bits that arrive inverted
    std::uint32_t bursts{0};     ///< frames of which up to 16 neighbouring bits are disturbed
    std::uint32_t dropped{0};    ///< characters that no receiver gets
    std::uint32_t added{0};      ///< characters after which another one follows
    std::uint32_t lost{0};       ///< frames that no receiver gets
    std::uint32_t repeated{0};   ///< frames that are received twice, the second right after the first
    std::uint32_t delayed{0};    ///< frames that are sent late, by up to `delay`
    std::uint32_t glitches{0};   ///< frames before which a short low glitch appears
    std::uint32_t foreign{0};    ///< frames before which another unit answers the same
    std::uint32_t babble{0};     ///< frames in whose place bytes without sense follow each other
    duration delay{};
    bool is_cut{false}; ///< nothing arrives at all
};

/// What becomes of one frame.
struct frame_fate {
    bool is_lost{false};
    bool is_delayed{false};
    bool has_glitch{false};
    bool is_repeated{false};
    bool has_foreign{false};
    bool is_babble{false};
};

/// Drawn for one frame. Of what never occurs no number is drawn.
[[nodiscard]] constexpr frame_fate fate_of(line_faults const& faults, random_source& random) noexcept
{
    frame_fate fate;
    fate.is_lost = faults.is_cut or random.happens(faults.lost);
    if (not fate.is_lost) {
        fate.is_delayed = random.happens(faults.delayed);
        fate.has_glitch = random.happens(faults.glitches);
        fate.is_repeated = random.happens(faults.repeated);
        fate.has_foreign = random.happens(faults.foreign);
        fate.is_babble = random.happens(faults.babble);
    }
    return fate;
}

/// Inverts some of up to 16 neighbouring bits of so many by `flip(place)`, the first of them always. The last of them may
/// lie behind the end.
template <typename Flip> constexpr void disturb_bits(std::size_t bits, random_source& random, Flip flip) noexcept
{
    constexpr std::uint32_t longest = 16;
    std::uint32_t const first = random.below(static_cast<std::uint32_t>(bits));
    std::uint32_t const pattern = random.next() | 1U;
    for (std::uint32_t i = 0; i <= random.below(longest); ++i) {
        if (((pattern >> i) & 1U) != 0) {
            flip(static_cast<std::size_t>(first) + i);
        }
    }
}

/// What another unit answers: of a read the same with other values, else an exception. None of it is a request that
/// writes. `place` has room for the frame, and for an exception.
[[nodiscard]] constexpr byte_view foreign_answer(byte_view frame, byte_span place, random_source& random) noexcept
{
    constexpr std::uint32_t units = 247;
    constexpr std::uint32_t most_read = 4; // the functions 01 to 04
    if (frame.size() < min_adu_size) {
        return {};
    }
    std::uint32_t const function = detail::to_u8(frame[1]);
    bool const is_read = function >= 1 and function <= most_read and frame.size() > detail::exception_adu_size;
    std::size_t const size = is_read ? frame.size() : detail::exception_adu_size;
    std::uint32_t const unit = 1 + random.below(units);
    place[0] = detail::to_byte(unit == detail::to_u8(frame[0]) ? 1 + unit % units : unit);
    place[1] = is_read ? frame[1] : detail::to_byte(function | detail::exception_bit);
    place[2] = is_read ? frame[2] : detail::to_byte(2);
    for (std::size_t i = 3; i + 2 < size; ++i) {
        place[i] = detail::to_byte(random.next());
    }
    std::uint32_t const crc = crc16(place.first(size - 2));
    place[size - 2] = detail::to_byte(crc);
    place[size - 1] = detail::to_byte(crc >> 8U);
    return place.first(size);
}

/// Bytes without sense. No function is among them, so that none of them begins a request, whoever looks for one there.
constexpr void fill_babble(byte_span place, random_source& random) noexcept
{
    constexpr std::uint32_t highest_bit = 0x80;
    for (std::byte& each : place) {
        each = detail::to_byte(random.next() | highest_bit);
    }
}

} // namespace sim

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

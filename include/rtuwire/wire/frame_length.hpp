// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The length of a frame, from its first bytes: one table, a rule for each function and direction (AP 6).
// Sizes are of the whole ADU. Knows no CRC and no time.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Which way a frame travels.
enum class direction : std::uint8_t { request, response };

/// How the size of an ADU follows from its bytes.
enum class length_rule : std::uint8_t {
    none = 0x00,        ///< only silence ends it
    fixed = 0x20,       ///< as many bytes as its size says
    byte_count = 0x40,  ///< its size, and as many as its last byte before the CRC says
    word_count = 0x60,  ///< the same with the last two bytes, big-endian
    subfunction = 0x80, ///< function 08: its size, but silence for sub-function 0
    mei = 0xA0,         ///< function 43: known for type 14 only
};

/// What the bytes so far tell: the frame is `size` bytes long, or more is known when `size` are there, or
/// (`size` 0) only silence ends it.
class length_hint {
public:
    constexpr length_hint() noexcept = default;
    constexpr length_hint(std::size_t size, bool is_final) noexcept
        : hint_{static_cast<std::uint16_t>(size << 1U | (is_final ? 1U : 0U))}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return hint_ >> 1U; }
    [[nodiscard]] constexpr bool is_final() const noexcept { return (hint_ & 1U) != 0; }

    friend constexpr bool operator==(length_hint, length_hint) noexcept = default;

private:
    std::uint16_t hint_{0}; ///< in one register, which small processors return best
};

/// Rules with their sizes, CRC included, for function codes up to 24: one byte each.
namespace length_rules {

/// The bits of a rule that tell its kind; the others are its size.
inline constexpr std::uint8_t kind_bits = 0xE0;

[[nodiscard]] constexpr std::uint8_t rule(length_rule counts, unsigned size = 0) noexcept
{
    return static_cast<std::uint8_t>(static_cast<unsigned>(counts) | size);
}

using enum length_rule;

inline constexpr std::uint8_t requests[] = {
    rule(none),           rule(fixed, 8),      rule(fixed, 8),  rule(fixed, 8),       // 0..3
    rule(fixed, 8),       rule(fixed, 8),      rule(fixed, 8),  rule(fixed, 4),       // 4..7
    rule(subfunction, 8), rule(none),          rule(none),      rule(fixed, 4),       // 8..11
    rule(fixed, 4),       rule(none),          rule(none),      rule(byte_count, 9),  // 12..15
    rule(byte_count, 9),  rule(fixed, 4),      rule(none),      rule(none),           // 16..19
    rule(byte_count, 5),  rule(byte_count, 5), rule(fixed, 10), rule(byte_count, 13), // 20..23
    rule(fixed, 6),
};
inline constexpr std::uint8_t responses[] = {
    rule(none),           rule(byte_count, 5), rule(byte_count, 5), rule(byte_count, 5), // 0..3
    rule(byte_count, 5),  rule(fixed, 8),      rule(fixed, 8),      rule(fixed, 5),      // 4..7
    rule(subfunction, 8), rule(none),          rule(none),          rule(fixed, 8),      // 8..11
    rule(byte_count, 5),  rule(none),          rule(none),          rule(fixed, 8),      // 12..15
    rule(fixed, 8),       rule(byte_count, 5), rule(none),          rule(none),          // 16..19
    rule(byte_count, 5),  rule(byte_count, 5), rule(fixed, 10),     rule(byte_count, 5), // 20..23
    rule(word_count, 6),
};

/// The rule of one function in one direction; `wire_code` is the byte behind the unit address.
[[nodiscard]] constexpr std::uint8_t of(direction dir, std::uint8_t wire_code) noexcept
{
    if (wire_code == to_u8(function_code::encapsulated_interface)) {
        return rule(mei);
    }
    bool const asks = dir == direction::request;
    if (wire_code >= sizeof(requests)) {
        bool const is_exception = (wire_code & exception_bit) != 0;
        return is_exception and not asks ? rule(fixed, exception_adu_size) : rule(none);
    }
    return asks ? requests[wire_code] : responses[wire_code];
}

} // namespace length_rules

/// What a rule says, before a size above 256 is refused. Two members: the size may be more than fits
/// `length_hint`, and a caller that needs only one need not have the other.
struct raw_length {
    std::size_t size{0};
    bool is_final{false};
};

/// The rule of function 43: a request is fixed, a response is walked object by object (AP 6.21).
[[nodiscard, gnu::always_inline]] constexpr raw_length identification_length(direction dir, byte_view adu) noexcept
{
    constexpr std::size_t mei_at = 2;
    constexpr std::size_t count_at = 7;
    if (adu.size() <= mei_at) {
        return {mei_at + 1, false};
    }
    if (to_u8(adu[mei_at]) != 0x0E) {
        return {};
    }
    if (dir == direction::request) {
        return {7, true};
    }
    if (adu.size() <= count_at) {
        return {count_at + 1, false};
    }
    std::size_t left = to_u8(adu[count_at]);
    std::size_t end = count_at + 1;
    while (left > 0 and end + 2 <= adu.size()) {
        end += 2U + to_u8(adu[end + 1]);
        --left;
    }
    // Two bytes follow: the CRC, or the head of the next object.
    return {end + 2, left == 0};
}

/// What the first bytes of an ADU say by their rule in the table.
[[nodiscard, gnu::always_inline]] constexpr raw_length length_by_rule(direction dir, byte_view adu) noexcept
{
    if (adu.size() < 2) {
        return {2, false};
    }
    std::uint8_t const rule = length_rules::of(dir, to_u8(adu[1]));
    auto const counts = static_cast<length_rule>(rule & length_rules::kind_bits);
    std::size_t const size = rule & ~length_rules::kind_bits & 0xFF;
    if (counts == length_rule::none) {
        return {};
    }
    if (counts == length_rule::fixed) {
        return {size, true};
    }
    if (counts == length_rule::mei) {
        return identification_length(dir, adu);
    }
    // The bytes before the CRC.
    std::size_t const counted = counts == length_rule::subfunction ? 4 : size - 2;
    if (adu.size() < counted) {
        return {counted, false};
    }
    if (counts == length_rule::byte_count) {
        return {size + to_u8(adu[counted - 1]), true};
    }
    std::size_t const word = u16_at(adu, counted - 2);
    if (counts == length_rule::word_count) {
        // Where a size has 16 bits, the sum would wrap; such a frame is refused anyway.
        bool const may_wrap = sizeof(std::size_t) < sizeof(std::uint32_t) and word > max_adu_size;
        return {may_wrap ? word : size + word, true};
    }
    return word == 0 ? raw_length{} : raw_length{size, true};
}

/// What the first bytes of an ADU tell about its size. A size above 256 is never returned: such a frame ends
/// by silence and is refused.
[[nodiscard]] constexpr length_hint frame_length(direction dir, byte_view adu) noexcept
{
    raw_length const hint = length_by_rule(dir, adu);
    return hint.size > max_adu_size ? length_hint{} : length_hint{hint.size, hint.is_final};
}

/// The size alone, for a caller that checks whether so many bytes are there. A size above 256 is returned as
/// 1, which no frame has: such a frame ends by silence and is refused. Force-inlined: the direction is
/// constant at each call, so half of it is dropped (60 to 80 bytes).
[[nodiscard, gnu::always_inline]] constexpr std::size_t size_hint(direction dir, byte_view adu) noexcept
{
    std::size_t const size = length_by_rule(dir, adu).size;
    return size > max_adu_size ? 1 : size;
}

} // namespace rtuwire

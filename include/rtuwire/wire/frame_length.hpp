// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How long a frame is, told from its first octets: one table, a rule for each function and direction
// (AP 6). Sizes are of the whole ADU. Knows no CRC and no time.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire {

/// Which way a frame travels.
enum class direction : std::uint8_t { request, response };

/// How the size of an ADU follows from its octets.
struct length_rule {
    /// How the rule counts.
    enum class kind : std::uint8_t {
        none,        ///< only silence ends it
        fixed,       ///< `base` octets
        byte_count,  ///< `base` octets and as many as the octet at `offset` says
        word_count,  ///< the same with the big-endian word at `offset`
        subfunction, ///< function 08: `base` octets, but silence for sub-function 0
        mei,         ///< function 43: known for type 14 only
    };

    kind counts{kind::none};
    std::uint8_t base{0};
    std::uint8_t offset{0};
};

/// What the octets so far say: the frame is `size` octets long, or more can be said when `size` are
/// there, or (`size` 0) nothing but silence ends it.
struct length_so_far {
    std::size_t size{0};
    bool is_final{false};

    friend constexpr bool operator==(length_so_far, length_so_far) noexcept = default;
};

/// The rule of one function in one direction; `wire_code` is the octet behind the unit address.
[[nodiscard]] constexpr length_rule length_rule_of(direction way, std::uint8_t wire_code) noexcept
{
    using enum length_rule::kind;
    bool const asks = way == direction::request;
    if ((wire_code & exception_bit) != 0) {
        return asks ? length_rule{} : length_rule{fixed, exception_adu_size};
    }
    switch (wire_code) {
    case 1:
    case 2:
    case 3:
    case 4: return asks ? length_rule{fixed, 8} : length_rule{byte_count, 5, 2};
    case 5:
    case 6: return {fixed, 8};
    case 7: return asks ? length_rule{fixed, 4} : length_rule{fixed, 5};
    case 8: return {subfunction, 8};
    case 11: return asks ? length_rule{fixed, 4} : length_rule{fixed, 8};
    case 12:
    case 17: return asks ? length_rule{fixed, 4} : length_rule{byte_count, 5, 2};
    case 15:
    case 16: return asks ? length_rule{byte_count, 9, 6} : length_rule{fixed, 8};
    case 20:
    case 21: return {byte_count, 5, 2};
    case 22: return {fixed, 10};
    case 23: return asks ? length_rule{byte_count, 13, 10} : length_rule{byte_count, 5, 2};
    case 24: return asks ? length_rule{fixed, 6} : length_rule{word_count, 6, 2};
    case 43: return {mei};
    default: return {};
    }
}

/// The rule of function 43: a request is fixed, a response is walked object by object (AP 6.21).
[[nodiscard]] constexpr length_so_far identification_length(direction way, byte_view adu) noexcept
{
    constexpr std::size_t mei_at = 2;
    constexpr std::size_t count_at = 7;
    if (adu.size() <= mei_at) {
        return {mei_at + 1, false};
    }
    if (to_u8(adu[mei_at]) != 0x0E) {
        return {};
    }
    if (way == direction::request) {
        return {7, true};
    }
    if (adu.size() <= count_at) {
        return {count_at + 1, false};
    }
    std::size_t end = count_at + 1;
    for (std::size_t left = to_u8(adu[count_at]); left > 0; --left) {
        if (adu.size() < end + 2) {
            return {end + 2, false};
        }
        end += 2U + to_u8(adu[end + 1]);
    }
    return {end + 2, true};
}

/// What the first octets of an ADU say about its size. A size above 256 is never final: such a frame
/// ends by silence and is refused.
[[nodiscard]] constexpr length_so_far frame_length(direction way, byte_view adu) noexcept
{
    if (adu.size() < 2) {
        return {2, false};
    }
    length_rule const rule = length_rule_of(way, to_u8(adu[1]));
    std::size_t const at = rule.offset;
    length_so_far known{rule.base, true};
    switch (rule.counts) {
    case length_rule::kind::none: return {};
    case length_rule::kind::fixed: break;
    case length_rule::kind::byte_count:
        if (adu.size() <= at) {
            return {at + 1, false};
        }
        known.size += to_u8(adu[at]);
        break;
    case length_rule::kind::word_count:
        if (adu.size() <= at + 1) {
            return {at + 2, false};
        }
        known.size += u16_at(adu, at);
        break;
    case length_rule::kind::subfunction:
        if (adu.size() < 4) {
            return {4, false};
        }
        if (u16_at(adu, 2) == 0) {
            return {};
        }
        break;
    case length_rule::kind::mei: known = identification_length(way, adu); break;
    }
    return known.size > max_adu_size ? length_so_far{} : known;
}

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a function says of its frames: how their sizes follow from their bytes, and which fields of a response repeat
// those of its request. Each function's file gives its rules; the tables are made of them.
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

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
    own = 0xA0,         ///< the function has a `length` of its own
};

/// The bits of a rule that tell its kind; the others are its size, up to 31.
/// Internal.
inline constexpr std::uint8_t length_rule_bits = 0xE0;

/// A rule with its size, CRC included, in one byte.
/// Internal.
[[nodiscard]] constexpr std::uint8_t sized(length_rule counts, unsigned size = 0) noexcept
{
    return static_cast<std::uint8_t>(static_cast<unsigned>(counts) | size);
}

/// The size of a rule.
/// Internal.
[[nodiscard]] constexpr std::size_t size_in(std::uint8_t rule) noexcept
{
    return rule & ~std::uint32_t{length_rule_bits} & 0xFFU;
}

/// What a normal response has in common with its request.
enum class answer_rule : std::uint8_t {
    unknown,   ///< of a function that is not in the list: it may even be the request
    head,      ///< it is the first five bytes of the request
    whole,     ///< it is the request
    partly,    ///< it has the request's size, and repeats as many bytes as the function's `repeated` says
    own,       ///< the function has a `check_response` of its own
    registers, ///< two bytes for each of the registers that the request's second field counts
    bits,      ///< a byte for each eight of the bits that it counts
    nothing,   ///< nothing but the function; it is never the request
};

/// The rules of one function.
struct frame_rules {
    std::uint8_t request;
    std::uint8_t response;
    answer_rule answers;
};

/// A request says itself whether a response fits it.
/// Internal.
template <typename Request>
concept has_response_check = requires(byte_view bytes)
{
    {
        Request::check_response(bytes, bytes)
        } -> std::same_as<errc>;
};

/// A request that knows more of its response than the client compares: its conversation asks `check_response` of it.
/// Internal.
template <typename Request>
concept checks_response = has_response_check<Request> and not requires
{
    requires Request::rules.answers == answer_rule::own;
};

/// What a rule says of a size, before one above 256 is refused. Two members: the size may be more than fits
/// `length_hint`, and a caller that needs only one need not have the other.
struct raw_length {
    std::size_t size{0};
    bool is_final{false};
};

} // namespace rtuwire

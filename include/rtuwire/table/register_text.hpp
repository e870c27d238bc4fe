// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What registers hold, as people read it: an enumerator by its mnemonic and in words, a word of bits in hexadecimal, a
// setting as its value. core/text.hpp shows amounts. Apart from what it shows, because firmware without a display includes
// no text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The size of the longest name in a list.
[[nodiscard]] constexpr std::size_t longest_name(std::span<named_value const> list) noexcept
{
    std::size_t longest = 0;
    for (named_value const& each : list) {
        longest = each.name.size() > longest ? each.name.size() : longest;
    }
    return longest;
}

} // namespace detail

/// An enumerator: "SLF1: Modbus interrupted", only one of both where the other is not known, and its number, "#25",
/// where neither is.
template <register_enumeration Enum> [[nodiscard]] constexpr auto text_of(Enum value) noexcept
{
    constexpr std::size_t numbered = 6;
    constexpr std::size_t named = detail::longest_name(enumerators<Enum>) + 2 + detail::longest_name(meanings<Enum>);
    auto const number = static_cast<std::uint16_t>(value);
    detail::short_text<(named > numbered ? named : numbered)> text;
    literal const name = detail::listed_name(enumerators<Enum>, number);
    literal const meaning = detail::listed_name(meanings<Enum>, number);
    text.precede(meaning);
    if (name.size() != 0 and meaning.size() != 0) {
        text.precede(": ");
    }
    text.precede(name);
    if (text.size() == 0) {
        detail::precede_by_number(text, std::uint32_t{number});
        text.precede('#');
    }
    return text;
}

/// A word of bits: "0x0237".
template <bit_field Bits> [[nodiscard]] constexpr auto text_of(Bits value) noexcept
{
    constexpr literal digits{"0123456789ABCDEF"};
    detail::short_text<6> text;
    for (unsigned at = 0; at < 16U; at += 4U) {
        text.precede(digits[(std::size_t{value.bits} >> at) % 16U]);
    }
    text.precede("0x");
    return text;
}

/// A setting, as its value.
template <auto const& R> [[nodiscard]] constexpr auto text_of(setting<R> value) noexcept
{
    return text_of(value.value());
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

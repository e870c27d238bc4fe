// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Octets as people write them: "02 03 0C 1E"_hex in a source file, and the way back for a log line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The text of a hexadecimal literal, as a template argument.
template <std::size_t Size> struct hex_literal {
    char text[Size]{};

    consteval hex_literal(char const (&source)[Size]) noexcept
    {
        for (std::size_t i = 0; i < Size; ++i) {
            text[i] = source[i];
        }
    }

    /// How many digits the text holds, spaces aside.
    [[nodiscard]] constexpr std::size_t digits() const noexcept
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i + 1 < Size; ++i) {
            count += text[i] != ' ' ? 1U : 0U;
        }
        return count;
    }
};

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void a_hex_literal_holds_only_hexadecimal_digits_and_spaces();

/// The value of one hexadecimal digit of a literal.
[[nodiscard]] constexpr std::uint8_t hex_digit(char digit) noexcept
{
    if (digit >= '0' and digit <= '9') {
        return static_cast<std::uint8_t>(digit - '0');
    }
    if (digit >= 'A' and digit <= 'F') {
        return static_cast<std::uint8_t>(digit - 'A' + 10);
    }
    if (digit >= 'a' and digit <= 'f') {
        return static_cast<std::uint8_t>(digit - 'a' + 10);
    }
    a_hex_literal_holds_only_hexadecimal_digits_and_spaces();
    return 0;
}

inline namespace literals {

/// The octets of a text of hexadecimal digits; spaces may stand anywhere.
template <hex_literal Text> consteval auto operator""_hex() noexcept
{
    static_assert(Text.digits() % 2 == 0, "a hex literal holds two digits for each octet");
    std::array<std::byte, Text.digits() / 2> bytes{};
    std::size_t digit = 0;
    for (char const c : Text.text) {
        if (c == ' ' or c == '\0') {
            continue;
        }
        auto& octet = bytes[digit / 2];
        octet = to_byte((std::uint32_t{to_u8(octet)} << 4U) | hex_digit(c));
        ++digit;
    }
    return bytes;
}

} // namespace literals

/// Writes octets as "02 03 0C" into a caller's characters, without a terminating zero, and returns
/// the part written. Octets that no longer fit, at three characters each, are left out.
[[nodiscard]] constexpr std::span<char const> to_hex(byte_view bytes, std::span<char> out) noexcept
{
    constexpr char digits[] = "0123456789ABCDEF";
    std::size_t size = 0;
    for (std::byte const octet : bytes) {
        std::size_t const space = size == 0 ? 0 : 1;
        if (out.size() - size < space + 2) {
            break;
        }
        if (space != 0) {
            out[size++] = ' ';
        }
        out[size++] = digits[to_u8(octet) >> 4U];
        out[size++] = digits[to_u8(octet) & 0xFU];
    }
    return out.first(size);
}

} // namespace rtuwire

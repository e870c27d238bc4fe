// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Bytes as people write them: "02 03 0C 1E"_hex in source code, and back to text for a log line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The text of a hexadecimal literal, as a template argument.
template <std::size_t Size> struct hex_literal {
    char literal[Size]{};

    consteval hex_literal(char const (&text)[Size]) noexcept
    {
        for (std::size_t i = 0; i < Size; ++i) {
            literal[i] = text[i];
        }
    }

    /// How many digits the text holds, without spaces.
    [[nodiscard]] constexpr std::size_t digits() const noexcept
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i + 1 < Size; ++i) {
            count += literal[i] != ' ' ? 1U : 0U;
        }
        return count;
    }
};

} // namespace detail

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void a_hex_literal_holds_only_hexadecimal_digits_and_spaces();

namespace detail {

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

} // namespace detail

inline namespace literals {

/// The bytes of a text of hexadecimal digits; spaces may stand anywhere.
template <detail::hex_literal Text> consteval auto operator""_hex() noexcept
{
    static_assert(Text.digits() % 2 == 0, "a hex literal holds two digits for each byte");
    std::array<std::byte, Text.digits() / 2> bytes{};
    std::size_t digit = 0;
    for (char const c : Text.literal) {
        if (c == ' ' or c == '\0') {
            continue;
        }
        auto& byte = bytes[digit / 2];
        byte = detail::to_byte((std::uint32_t{detail::to_u8(byte)} << 4U) | detail::hex_digit(c));
        ++digit;
    }
    return bytes;
}

} // namespace literals

/// Writes bytes as "02 03 0C" into a caller's characters, without a terminating zero, and returns
/// the part written. Bytes that no longer fit, at three characters each, are left out.
[[nodiscard]] constexpr std::span<char const> to_hex(byte_view bytes, std::span<char> out) noexcept
{
    constexpr char digits[] = "0123456789ABCDEF";
    std::size_t size = 0;
    for (std::byte const byte : bytes) {
        std::size_t const space = size == 0 ? 0 : 1;
        if (out.size() - size < space + 2) {
            break;
        }
        if (space != 0) {
            out[size++] = ' ';
        }
        out[size++] = digits[detail::to_u8(byte) >> 4U];
        out[size++] = digits[detail::to_u8(byte) & 0xFU];
    }
    return out.first(size);
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

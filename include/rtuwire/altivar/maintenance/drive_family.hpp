// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The family of a drive out of any text that names one: its product code, its reference, or the name of its table. All
// drives of a family have the same parameters.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The letters and the number that a text begins with: "ATV320" of "ATV320U07M2C" and of "atv320". Unknown where a text
/// does not begin so, or goes on for more than 8 characters before its number ends.
class drive_family {
public:
    constexpr drive_family() noexcept = default;

    /// The family that a text names.
    [[nodiscard]] static constexpr drive_family of(literal text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(text[i]); ++i) {
        }
        return found.whole();
    }

    /// The same of a text that is known when the program runs: a std::string_view, a std::string.
    template <typename Text>
        requires requires(Text const& text) { requires std::same_as<decltype(text[text.size() - 1]), char const&>; }
    [[nodiscard]] static constexpr drive_family of(Text const& text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(text[i]); ++i) {
        }
        return found.whole();
    }

    /// The same of a text as it came over the line.
    [[nodiscard]] static constexpr drive_family of(byte_view text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(static_cast<char>(detail::to_u8(text[i]))); ++i) {
        }
        return found.whole();
    }

    [[nodiscard]] constexpr bool is_known() const noexcept { return size_ != 0; }

    friend constexpr bool operator==(drive_family const&, drive_family const&) noexcept = default;

private:
    static constexpr bool is_digit(char what) noexcept { return what >= '0' and what <= '9'; }
    static constexpr bool is_letter(char what) noexcept { return what >= 'A' and what <= 'Z'; }
    static constexpr char upper(char what) noexcept
    {
        return what >= 'a' and what <= 'z' ? static_cast<char>(what - 'a' + 'A') : what;
    }

    /// Takes one more character; whether the next one may belong to the family, too.
    constexpr bool push(char what) noexcept
    {
        char const each = upper(what);
        bool const is_part = is_digit(each) ? size_ > 0 : is_letter(each) and not has_number();
        if (is_part and size_ == text_.size()) {
            size_ = 0; // too long for any
            return false;
        }
        if (is_part) {
            text_[size_++] = each;
        }
        return is_part;
    }

    [[nodiscard]] constexpr bool has_number() const noexcept { return size_ > 0 and is_digit(text_[size_ - 1U]); }
    [[nodiscard]] constexpr drive_family whole() const noexcept { return has_number() ? *this : drive_family{}; }

    std::array<char, 8> text_{};
    std::uint8_t size_{0};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

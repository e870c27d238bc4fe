// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A string literal with its length, for the few texts that firmware has to send. Cheaper to include than a
// string_view, and one where a program includes that.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// std::string_view, without its header: a view of characters that somebody else owns.
template <typename View>
concept character_view =
    std::constructible_from<View, char const*, std::size_t> and std::is_trivially_copyable_v<View> and requires
{
    typename View::traits_type;
};

} // namespace detail

/// Characters that live as long as the program, without a terminating zero.
class literal {
public:
    /// An empty text.
    constexpr literal() noexcept = default;

    /// The characters of a string literal.
    template <std::size_t Size>
    constexpr literal(char const (&characters)[Size]) noexcept : data_{characters}, size_{Size - 1}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr char operator[](std::size_t index) const noexcept { return data_[index]; }
    [[nodiscard]] constexpr char const* begin() const noexcept { return data_; }
    [[nodiscard]] constexpr char const* end() const noexcept { return data_ + size_; }

    /// As a std::string_view.
    template <detail::character_view View> constexpr operator View() const noexcept { return View(data_, size_); }

    friend constexpr bool operator==(literal left, literal right) noexcept
    {
        if (left.size_ != right.size_) {
            return false;
        }
        for (std::size_t i = 0; i < left.size_; ++i) {
            if (left.data_[i] != right.data_[i]) {
                return false;
            }
        }
        return true;
    }

private:
    char const* data_{nullptr};
    std::size_t size_{0};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

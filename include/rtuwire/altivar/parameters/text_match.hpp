// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Compares the names in a table with a text that a program gets while it runs, whatever class that text is.
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A text of any class, as std::string_view and std::string.
template <typename Text>
concept text_with_size = requires(Text const& text, std::size_t at)
{
    requires std::same_as<decltype(text.size()), std::size_t>;
    requires std::same_as<decltype(text[at]), char const&>;
};

/// Whether a text is a name, letter by letter.
template <text_with_size Text> [[nodiscard]] constexpr bool is_spelled(literal name, Text const& text) noexcept
{
    bool is_equal = name.size() == text.size();
    for (std::size_t i = 0; is_equal and i < name.size(); ++i) {
        is_equal = name[i] == text[i];
    }
    return is_equal;
}
/// The same of a constant.
[[nodiscard]] constexpr bool is_spelled(literal name, literal text) noexcept { return name == text; }

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

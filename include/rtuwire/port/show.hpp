// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What has a `text_of` goes to a std::ostream, to std::format where the library has it, and to fmt where a header of fmt
// was included before: amounts, settings, enumerators with names, errors, outcomes, reasons, and a result of one of these.
#pragma once

#include <concepts>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <version>

#if defined(__cpp_lib_format)
#include <format>
#endif

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register_text.hpp>
#include <rtuwire/wire/errc_name.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// An enumeration of a program's own that only happens to be as wide as a register.
template <typename T>
concept nameless_enumeration = register_enumeration<T> and enumerators<T>
.size() == 0;

/// Whether a value shows by itself.
template <typename T>
concept has_text = not nameless_enumeration<T> and requires(T const& value)
{
    {
        text_of(value)
        } -> std::convertible_to<std::string_view>;
};

/// What a result holds that shows by itself.
template <typename T>
concept has_text_in_result = has_text<T> or std::is_void_v<T>;

} // namespace detail

/// Shows a value as its text, in the width that the stream is set to.
template <detail::has_text T> std::ostream& operator<<(std::ostream& out, T const& value)
{
    auto const text = text_of(value);
    return out << std::string_view{text};
}

/// Shows a result as its value, or as its error; one of no value as "no error".
template <detail::has_text_in_result T> std::ostream& operator<<(std::ostream& out, result<T> const& its)
{
    if constexpr (not std::is_void_v<T>) {
        if (its) {
            return out << *its;
        }
    }
    return out << its.error();
}

// An operator is looked for where its operand's type is declared.
namespace altivar {
using rtuwire::operator<<;
namespace atv12 {
using rtuwire::operator<<;
}
namespace atv28 {
using rtuwire::operator<<;
}
namespace atv310 {
using rtuwire::operator<<;
}
namespace atv320 {
using rtuwire::operator<<;
}
namespace compact {
using rtuwire::operator<<;
}
} // namespace altivar
namespace cia402 {
using rtuwire::operator<<;
}
namespace detail {
using rtuwire::operator<<;
}

namespace detail {

/// A formatter of text that takes any has_text value, and a result of one.
template <typename Formatter> struct formatter_of_texts : Formatter {
    template <has_text T, typename Context> auto format(T const& value, Context& context) const
    {
        auto const text = text_of(value);
        return Formatter::format(std::string_view{text}, context);
    }
    template <has_text_in_result T, typename Context> auto format(result<T> const& its, Context& context) const
    {
        if constexpr (not std::is_void_v<T>) {
            if (its) {
                return format(*its, context);
            }
        }
        return format(its.error(), context);
    }
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#if defined(__cpp_lib_format)
template <rtuwire::detail::has_text T>
struct std::formatter<T, char> : rtuwire::detail::formatter_of_texts<std::formatter<std::string_view, char>> {};
template <rtuwire::detail::has_text_in_result T>
struct std::formatter<rtuwire::result<T>, char>
    : rtuwire::detail::formatter_of_texts<std::formatter<std::string_view, char>> {};
#if defined(__cpp_lib_format_ranges)
// A literal, and a text, are no ranges of characters.
template <rtuwire::detail::has_text T>
    requires(requires(T const& text) { text.begin(); })
inline constexpr auto std::format_kind<T> = std::range_format::disabled;
#endif
#endif

#if defined(FMT_VERSION)
template <rtuwire::detail::has_text T>
struct fmt::formatter<T, char> : rtuwire::detail::formatter_of_texts<fmt::formatter<fmt::string_view, char>> {};
template <rtuwire::detail::has_text_in_result T>
struct fmt::formatter<rtuwire::result<T>, char>
    : rtuwire::detail::formatter_of_texts<fmt::formatter<fmt::string_view, char>> {};
#endif

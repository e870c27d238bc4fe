// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The numbers by which a drive without letters on its display calls its parameters, and the mnemonics that belong to
// them: looked up both ways, by a constant or by a text that somebody typed.
#pragma once

#include <span>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A parameter by both of its names.
struct menu_number {
    literal number; ///< as the display shows it, with one digit behind the point of a submenu: "611", "705.0"
    literal code;   ///< the mnemonic, in upper case
};

/// One of the two names of the parameter whose other one is a text; empty where no row has it.
/// Internal.
template <typename Text>
[[nodiscard]] constexpr literal beside(std::span<menu_number const> rows, literal menu_number::*known,
                                       literal menu_number::*wanted, Text const& text) noexcept
{
    for (menu_number const& each : rows) {
        if (is_spelled(each.*known, text)) {
            return each.*wanted;
        }
    }
    return {};
}

/// The numbers that one manual prints. It has some of a drive's parameters, not all.
class menu_numbers {
public:
    /// The rows live as long as the list.
    explicit constexpr menu_numbers(std::span<menu_number const> rows) noexcept : rows_{rows} {}

    /// In the order of their numbers.
    [[nodiscard]] constexpr std::span<menu_number const> rows() const noexcept { return rows_; }

    /// The mnemonic of the parameter with a number; empty where the manual prints no such number.
    [[nodiscard]] constexpr literal code_of(literal number) const noexcept
    {
        return beside(rows_, &menu_number::number, &menu_number::code, number);
    }

    /// The same of a text that the program gets while it runs, in a std::string_view or a std::string.
    template <text_with_size Text> [[nodiscard]] constexpr literal code_of(Text const& number) const noexcept
    {
        return beside(rows_, &menu_number::number, &menu_number::code, number);
    }

    /// The number of the parameter with a mnemonic in upper case; empty where the manual prints none for it.
    [[nodiscard]] constexpr literal number_of(literal code) const noexcept
    {
        return beside(rows_, &menu_number::code, &menu_number::number, code);
    }

    /// The same of a text that the program gets while it runs.
    template <text_with_size Text> [[nodiscard]] constexpr literal number_of(Text const& code) const noexcept
    {
        return beside(rows_, &menu_number::code, &menu_number::number, code);
    }

private:
    std::span<menu_number const> rows_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

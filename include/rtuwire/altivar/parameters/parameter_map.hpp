// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The parameters of a drive by the groups of its menus, for a program that walks them or looks for one, by a constant or by
// a text that it gets while it runs, whatever class that text is.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A text of any class, as std::string_view and std::string.
/// Internal.
template <typename Text>
concept text_with_size = requires(Text const& text, std::size_t at)
{
    requires std::same_as<decltype(text.size()), std::size_t>;
    requires std::same_as<decltype(text[at]), char const&>;
};

/// Whether a text is a name, letter by letter.
/// Internal.
template <text_with_size Text> [[nodiscard]] constexpr bool is_spelled(literal name, Text const& text) noexcept
{
    bool is_equal = name.size() == text.size();
    for (std::size_t i = 0; is_equal and i < name.size(); ++i) {
        is_equal = name[i] == text[i];
    }
    return is_equal;
}
/// The same of a constant.
/// Internal.
[[nodiscard]] constexpr bool is_spelled(literal name, literal text) noexcept { return name == text; }

/// Some parameters that belong together.
struct parameter_group {
    literal name; ///< one word, "motor_control"
    std::span<parameter const> rows;
};

/// The groups of a drive.
class parameter_map {
public:
    using row_type = parameter;

    /// The groups live as long as the map.
    explicit constexpr parameter_map(std::span<parameter_group const> groups) noexcept : groups_{groups} {}

    /// The same of a family of drives, "ATV320": no drive of another one is restored by it.
    constexpr parameter_map(std::span<parameter_group const> groups, literal family) noexcept
        : groups_{groups}, family_{family}
    {}

    /// The family that it was made for; empty where it does not say.
    [[nodiscard]] constexpr literal family() const noexcept { return family_; }

    [[nodiscard]] constexpr std::span<parameter_group const> groups() const noexcept { return groups_; }

    /// How many parameters there are.
    [[nodiscard]] constexpr std::size_t size() const noexcept
    {
        std::size_t count = 0;
        for (parameter_group const& group : groups_) {
            count += group.rows.size();
        }
        return count;
    }

    /// Calls `visit(parameter, group)` for each.
    template <typename Visit> constexpr void for_each(Visit&& visit) const
    {
        for (parameter_group const& group : groups_) {
            for (parameter const& each : group.rows) {
                visit(each, group);
            }
        }
    }

private:
    // In front of what calls it: Clang 14 takes it for undefined in a constant expression else.
    template <typename Is> [[nodiscard]] constexpr parameter const* found(Is const& is) const noexcept
    {
        parameter const* row = nullptr;
        for_each([&](parameter const& each, parameter_group const&) { row = is(each) ? &each : row; });
        return row;
    }

public:
    /// The parameter at an address; null where there is none.
    [[nodiscard]] constexpr parameter const* at(std::uint16_t address) const noexcept
    {
        return found([address](parameter const& each) { return each.address == address; });
    }

    /// The parameter of a mnemonic in upper case; null where there is none.
    [[nodiscard]] constexpr parameter const* by_code(literal code) const noexcept
    {
        return found([code](parameter const& each) { return each.code == code; });
    }

    /// The same of a text that the program gets while it runs, in a std::string_view or a std::string.
    template <text_with_size Text> [[nodiscard]] constexpr parameter const* by_code(Text const& code) const noexcept
    {
        return found([&code](parameter const& each) { return is_spelled(each.code, code); });
    }

private:
    std::span<parameter_group const> groups_;
    literal family_{};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One register of a drive as a row: what its line in the manual's table says. A menu is an array of them:
//
//     {"TDC1", 10402, rw,  in<deciseconds>, 1, 300, 5,  "Automatic DC injection: first time", &stopping},
//     {"NST",  11202, cfg, logic_input,     {}, {}, 0,  "Input for freewheel stop", &stop_input},
//      mnemonic, address, who may write it, what it holds, least, most, as delivered, name, what it is for a restore
//
// `rw` is written at any time, `cfg` only at rest, `ro` never. It holds amounts, `in<...>` their unit and step, or one of a
// list of choices, or bits. Limits and the value as delivered are counts of that step; `{}` is none, or not known. A limit
// may be another register: "TFR". Behind the name stands only what is special: why it is no ordinary setting, and which
// register sets the size of its steps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <rtuwire/altivar/parameters/parameter_role.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/row.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// One parameter, as its row.
struct parameter {
    literal code; ///< the mnemonic, in upper case
    std::uint16_t address;
    row_access is_written;
    held_values type;
    bound min = detail::open_bound;                              ///< in raw counts, or by another register
    bound max = detail::open_bound;                              ///< in raw counts, or by another register
    std::optional<std::int32_t> factory = detail::unknown_count; ///< in raw counts, where known
    literal name = detail::no_text;                              ///< for display
    row_role const* role{&roles::ordinary};   ///< what it is for whoever copies a configuration, and why
    literal steps_set_by = detail::no_text;   ///< the register that sets the size of a step; empty where none does
    detail::count_range gap = detail::no_gap; ///< raw counts inside the limits that are never written

    /// Each is a holding register of one word: a restore writes no other.
    static constexpr bool is_plain = true;

    [[nodiscard]] constexpr access mode() const noexcept { return is_written.mode; }
    [[nodiscard]] constexpr provenance source() const noexcept { return is_written.source; }

    /// Whether it can be written at all.
    [[nodiscard]] constexpr bool is_writable() const noexcept { return is_written.mode != access::read_only; }

    /// The values of an enumeration, or the bits of a word by number.
    [[nodiscard]] constexpr std::span<choice const> choices() const noexcept { return type.choices(); }

    /// The choices that a word has to be one of: those of an enumeration. Without any, each word is one.
    [[nodiscard]] constexpr std::span<choice const> listed() const noexcept
    {
        return type->kind == parameter_kind::enumeration ? type.choices() : std::span<choice const>{};
    }

    /// The count that a word on the wire stands for: below zero only in a register of signed numbers.
    [[nodiscard]] constexpr std::int32_t count_of(std::uint16_t word) const noexcept
    {
        return type->kind == parameter_kind::signed_number ? std::int32_t{static_cast<std::int16_t>(word)}
                                                           : std::int32_t{word};
    }

    /// Whether a count lies within the limits, as far as they do not depend on another register, and not in the gap, and is
    /// one of the values that the enumeration lists.
    [[nodiscard]] constexpr bool takes(std::int32_t count) const noexcept
    {
        bool const is_signed = type->kind == parameter_kind::signed_number;
        std::int64_t const lowest = min.is_number() ? min.raw() : is_signed ? -32'768 : 0;
        std::int64_t const highest = max.is_number() ? max.raw() : is_signed ? 32'767 : 65'535;
        return count >= lowest and count <= highest and not gap.contains(count) and
               detail::has_meaning(listed(), static_cast<std::uint16_t>(count));
    }
};

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void a_register_that_is_written_says_what_it_is_for_a_restore();

/// The row of a register that has an object, and what it is for whoever copies a configuration.
template <detail::register_value T>
[[nodiscard]] constexpr parameter row_of(reg<T> const& from, row_role const& role) noexcept
{
    return {from.code, from.address, {from.mode, from.source}, in<T>,   from.min, from.max, from.factory,
            from.name, &role,        from.steps_set_by,        from.gap};
}

/// The same of a register that is only read.
template <detail::register_value T> [[nodiscard]] consteval parameter row_of(reg<T> const& from) noexcept
{
    if (from.mode != access::read_only) {
        a_register_that_is_written_says_what_it_is_for_a_restore();
    }
    return row_of(from, roles::ordinary);
}

/// What a parameter is. One that the map does not let be written is `read_only`, whatever its row says.
[[nodiscard]] constexpr parameter_role role_of(parameter const& row) noexcept
{
    return row.is_writable() ? row.role->role : parameter_role::read_only;
}

/// Why a parameter is no ordinary setting, as the end of a sentence that begins with its mnemonic; empty where it is one.
[[nodiscard]] constexpr literal why(parameter const& row) noexcept
{
    return row.is_writable() ? row.role->why : literal{"is read-only"};
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

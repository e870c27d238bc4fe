// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Compares what a configuration wants with what a drive holds. Only settings count, those of the safety functions among
// them: what the drive measures, counts or shows differs from one moment to the next, and an order that it holds is no
// part of its configuration.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/parameter_role.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What a comparison of one parameter gave.
enum class comparison : std::uint8_t {
    equal,
    differs,
    not_wanted,   ///< the configuration has no word for it
    not_compared, ///< it is no setting: `role_of` and `why` tell what it is
    unknown,      ///< the drive did not tell its word
};

/// A comparison in words.
[[nodiscard]] constexpr literal name_of(comparison found) noexcept
{
    switch (found) {
    case comparison::equal: return "equal";
    case comparison::differs: return "differs";
    case comparison::not_wanted: return "not wanted";
    case comparison::not_compared: return "not compared";
    case comparison::unknown: return "not known";
    }
    return "unknown";
}

/// Compares the word that is wanted of a parameter with the one that the drive holds.
[[nodiscard]] constexpr comparison compared(parameter const& row, std::optional<std::uint16_t> wanted,
                                            std::optional<std::uint16_t> held) noexcept
{
    parameter_role const role = role_of(row);
    if (not is_restorable(role) and role != parameter_role::safety) {
        return comparison::not_compared;
    }
    if (not wanted) {
        return comparison::not_wanted;
    }
    if (not held) {
        return comparison::unknown;
    }
    return *wanted == *held ? comparison::equal : comparison::differs;
}

/// A sink for `backup` that compares each parameter with the word which `wanted(parameter const&)` wants of it, a
/// `std::optional<std::uint16_t>`, and calls `report(parameter_group const&, parameter const&, comparison,
/// result<std::uint16_t>)` with what the drive told:
///
///     altivar::backup check{drive, atv320::parameters, altivar::compared_with{wanted, report}};
template <typename Wanted, typename Report> class compared_with {
public:
    constexpr compared_with(Wanted its_wanted, Report its_report) noexcept : wanted_{its_wanted}, report_{its_report} {}

    constexpr void operator()(parameter_group const& group, parameter const& row,
                              result<std::uint16_t> const& held) noexcept
    {
        std::optional<std::uint16_t> const word = held ? std::optional{*held} : std::nullopt;
        report_(group, row, compared(row, wanted_(row), word), held);
    }

private:
    Wanted wanted_;
    Report report_;
};
template <typename Wanted, typename Report> compared_with(Wanted, Report) -> compared_with<Wanted, Report>;

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

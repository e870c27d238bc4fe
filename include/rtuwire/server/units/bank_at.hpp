// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A bank and the unit address that it answers as: for a server of several units, and for a bench.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Says: this bank answers as this unit, by every public function that it has something for (coils, a queue, files and
/// so on) and its server has, or by those that a profile allows. The bank and the profile are stored elsewhere, and must
/// outlive what is made of this.
template <register_bank Bank> struct bank_at {
    unit_id address;
    Bank& bank;
    server_profile const& profile;

    constexpr bank_at(unit_id its_unit, Bank& served, server_profile const& allowed = every_function) noexcept
        : address{its_unit}, bank{served}, profile{allowed}
    {}
    bank_at(unit_id, Bank&, server_profile const&&) = delete;

private:
    static constexpr server_profile every_function{};
};

/// What a server of several units stores of an argument: a `bank_at`, or a view of an array of them.
/// Internal.
template <typename T> struct entry_for;
template <register_bank Bank> struct entry_for<bank_at<Bank>> {
    using type = bank_at<Bank>;
};
template <register_bank Bank, std::size_t Count> struct entry_for<std::array<bank_at<Bank>, Count>> {
    using type = std::span<bank_at<Bank> const>;
};
template <register_bank Bank, std::size_t Extent> struct entry_for<std::span<bank_at<Bank> const, Extent>> {
    using type = std::span<bank_at<Bank> const>;
};
/// Internal.
template <typename T>
concept names_units = requires
{
    typename entry_for<std::remove_cvref_t<T>>::type;
};

/// The entry of an argument, which is an lvalue or a `bank_at`.
/// Internal.
template <typename Argument> struct checked_entry {
    static_assert(names_units<Argument>,
                  "a server of several units is made of bank_at{unit_id{3}, bank}, or of a std::array of these");
    static_assert(
        std::is_lvalue_reference_v<Argument> or not requires { std::declval<Argument>().size(); },
        "an array that ends with its expression cannot be served: give it a name first");
    using type = typename entry_for<std::remove_cvref_t<Argument>>::type;
};
/// Internal.
template <typename Argument> using unit_entry = typename checked_entry<Argument>::type;

} // namespace rtuwire

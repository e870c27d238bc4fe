// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The public functions that a bank has something for. A function says what it needs of a bank by `is_served_by`; one
// that does not needs registers only.
// Internal: may change with any version.
#pragma once

#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether a bank has what a function serves.
template <typename Function, typename Bank> inline constexpr bool serves_function = true;
template <typename Function, typename Bank>
    requires requires { Function::template is_served_by<Bank&>; }
inline constexpr bool serves_function<Function, Bank> = Function::template is_served_by<Bank&>;

/// Moves those of a list that a bank serves behind those that are chosen.
template <typename Bank, typename Chosen, typename Others> struct choose_functions {
    using type = Chosen;
};
template <typename Bank, typename... Chosen, typename First, typename... Others>
struct choose_functions<Bank, function_list<Chosen...>, function_list<First, Others...>>
    : choose_functions<
          Bank,
          std::conditional_t<serves_function<First, Bank>, function_list<Chosen..., First>, function_list<Chosen...>>,
          function_list<Others...>> {};

/// The public functions that a bank of registers serves.
template <typename Bank>
using served_functions = typename choose_functions<Bank, function_list<>, public_functions>::type;

} // namespace rtuwire

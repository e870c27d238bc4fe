// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Registers whose steps another register sets, counted in steps that the program names. A step has the width of its
// register; that of a count with a scale has its sign and the order of its words, too.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/word_order.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Whether a step counts numbers with a sign.
template <typename Step> [[nodiscard]] consteval bool is_signed_step() noexcept
{
    if constexpr (requires { typename Step::count_type; }) {
        return std::is_signed_v<typename Step::count_type>;
    } else {
        return std::is_signed_v<typename Step::rep>;
    }
}

/// Whether the words of a step stand in an order; a step of one word has its high byte first.
template <typename Step> [[nodiscard]] consteval bool is_in_order(word_order order) noexcept
{
    if constexpr (requires { Step::order; }) {
        return Step::order == order;
    } else {
        return not swaps_bytes(order);
    }
}

/// The address of a register that is counted in other steps; these have as many words.
template <typename Step, auto const& R> [[nodiscard]] consteval std::uint16_t restepped_address() noexcept
{
    static_assert(held_by<Step>::words == R.word_count, "a step is as wide as its register: name one of so many bits");
    if constexpr (has_scale_register<R>) {
        using form = typename std::remove_cvref_t<decltype(R)>::form;
        static_assert(is_signed_step<Step>() == std::is_signed_v<typename form::count_type>,
                      "a step has a sign where its register has one");
        static_assert(is_in_order<Step>(form::order), "a step has the word order of its register");
    }
    return R.address;
}

/// A limit of a register in other steps. What means "not implemented" in a count with a scale is never written.
template <auto const& R> [[nodiscard]] consteval bound restepped_limit(bound limit, bool is_highest) noexcept
{
    if constexpr (has_scale_register<R>) {
        using form = typename std::remove_cvref_t<decltype(R)>::form;
        std::int64_t const end = is_highest ? form::highest : form::lowest;
        bool const is_beyond = limit.is_number() and (is_highest ? limit.raw() > end : limit.raw() < end);
        return limit.is_open() or is_beyond ? bound{end} : limit;
    }
    return limit;
}

} // namespace detail

/// A register whose steps another register sets, counted in steps that the caller knows. It can be named
/// wherever the register can.
template <typename Step, auto const& R>
inline constexpr reg<Step, std::remove_cvref_t<decltype(R)>::space> restepped{
    .code = R.code,
    .address = detail::restepped_address<Step, R>(),
    .mode = R.mode,
    .min = detail::restepped_limit<R>(R.min, false),
    .max = detail::restepped_limit<R>(R.max, true),
    .factory = R.factory,
    .name = R.name,
    .source = R.source,
    .gap = R.gap,
    .counted_as = &R,
    .is_restepped = true};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

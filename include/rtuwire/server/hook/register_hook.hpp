// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A callable at a register of a server: what it is called with, and when. A register is named by its type, or by its
// address as a plain word.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A register of a table. Its words may be no value of it (a floating point number that is none) in a bank of plain
/// words.
template <auto const& R> struct typed_place {
    static constexpr std::uint16_t address = R.address;
    static constexpr std::size_t size = R.word_count;
    [[nodiscard]] static constexpr result<value_of<R>> value(register_view words, std::size_t index) noexcept
    {
        return value_in<R>(words, index, index);
    }
};

/// A word at an address.
struct word_place {
    static constexpr std::size_t size = 1;
    std::uint16_t address;
    [[nodiscard]] static constexpr result<std::uint16_t> value(register_view words, std::size_t index) noexcept
    {
        return words[index];
    }
};

/// Whether the words of a request from `index` on, which go to `address`, are this register.
template <typename Place>
[[nodiscard]] constexpr bool holds(Place const& place, std::uint32_t address, register_view words,
                                   std::size_t index) noexcept
{
    return address == place.address and words.size() - index >= Place::size;
}

/// Whether the word of a request at `index`, which goes to `address`, is of this register, and the request has not all of
/// its words. Half a register passes no check and calls nothing, so it is not written: exception 02, as in a typed bank.
template <typename Place>
[[nodiscard]] constexpr bool splits([[maybe_unused]] Place const& place, [[maybe_unused]] std::uint32_t address,
                                    [[maybe_unused]] register_view words, [[maybe_unused]] std::size_t index) noexcept
{
    if constexpr (Place::size == 1) {
        return false;
    } else {
        std::uint32_t const offset = address - place.address; // far above the size in front of the register
        return offset < Place::size and (offset > index or words.size() - index < Place::size - offset);
    }
}

/// Whether the words of a request from `index` on are this register, and no value of it.
template <typename Place>
[[nodiscard]] constexpr bool holds_no_value(Place const& place, std::uint32_t address, register_view words,
                                            std::size_t index) noexcept
{
    return holds(place, address, words, index) and not place.value(words, index);
}

/// Whether a callable takes a value, and where it does, whether it returns a type.
template <typename Callable, typename Value> inline constexpr bool takes = std::is_invocable_v<Callable, Value>;
template <typename Returned, typename Callable, typename Value> inline constexpr bool gives = true;
template <typename Returned, typename Callable, typename Value>
    requires takes<Callable, Value>
inline constexpr bool gives<Returned, Callable, Value> =
    std::is_same_v<std::invoke_result_t<Callable, Value>, Returned>;

/// A callable that is asked before a write; it cannot change itself.
template <typename Place, typename Callable> struct write_check {
    [[no_unique_address]] Place place;
    [[no_unique_address]] Callable call;

    [[nodiscard]] constexpr errc check(std::uint32_t address, register_view words, std::size_t index) const noexcept
    {
        if (not holds(place, address, words, index)) {
            return errc::none;
        }
        auto const value = place.value(words, index);
        return value ? call(*value) : errc::illegal_data_value;
    }
    static constexpr void act(std::uint32_t, register_view, std::size_t) noexcept {}
};

/// A callable that is told after a write.
template <typename Place, typename Callable> struct write_action {
    [[no_unique_address]] Place place;
    [[no_unique_address]] Callable call;

    [[nodiscard]] static constexpr errc check(std::uint32_t, register_view, std::size_t) noexcept { return errc::none; }
    constexpr void act(std::uint32_t address, register_view words, std::size_t index) noexcept
    {
        if (holds(place, address, words, index)) {
            if (auto const value = place.value(words, index)) {
                call(*value);
            }
        }
    }
};

/// Hooks in the order in which they were named.
struct no_hooks {
    template <typename Visit> static constexpr void for_each(Visit&&) noexcept {}
};
template <typename Before, typename Hook> struct hook_list {
    [[no_unique_address]] Before before;
    [[no_unique_address]] Hook last;

    template <typename Visit> constexpr void for_each(Visit&& visit) noexcept
    {
        before.for_each(visit);
        visit(last);
    }
    template <typename Visit> constexpr void for_each(Visit&& visit) const noexcept
    {
        before.for_each(visit);
        visit(last);
    }
};

} // namespace rtuwire

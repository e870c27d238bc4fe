// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device's table of a thousand registers, and a plan that reads all of them.
#include <rtuwire/ask/poller.hpp>

#include <utility>

#include "codes.hpp"

using namespace rtuwire;

template <unsigned A> inline constexpr reg<decihertz> one{.code = code<A>, .address = A, .min = 0, .max = 5'000};
template <std::size_t... I> table<one<100 + I + I / 7>...> table_of(std::index_sequence<I...>);

struct device {
    static constexpr literal name{"thousand"};
    static constexpr function_set functions{function_code::read_holding_registers};
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 1> readable{{{0, 2'000}}};
    using registers = decltype(table_of(std::make_index_sequence<1'000>{}));
};
template <std::size_t... I> read_plan<device, one<100 + I + I / 7>...> plan_of(std::index_sequence<I...>);

std::optional<request_frame> ask(poller<decltype(plan_of(std::make_index_sequence<1'000>{}))>& panel)
{
    return panel.next();
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server with a bank of a thousand registers.
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/typed_bank.hpp>

#include <utility>

#include "codes.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

template <unsigned Address>
inline constexpr reg<decihertz> one{.code = code<Address>, .address = Address, .min = 0, .max = 5'000};
template <std::size_t... I> bank<one<100 + I>...> bank_at_each(std::index_sequence<I...>);

decltype(bank_at_each(std::make_index_sequence<1'000>{})) all;

byte_view answer(byte_span place, std::size_t size)
{
    static constexpr server_profile profile{};
    no_diagnostics none;
    return response_frame(place, size, unit_id{1}, all, profile, none);
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A table's registers by their place.
#include <rtuwire/table/table.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/units.hpp>
#include <rtuwire/table/register.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

inline constexpr reg<count16> one{.code = "ONE", .address = 1};
inline constexpr reg<count16> two{.code = "TWO", .address = 2};
inline constexpr reg<count16> three{.code = "THREE", .address = 3};
inline constexpr reg<count16> four{.code = "FOUR", .address = 4};

template <std::size_t Index> constexpr auto const* at = &register_at<Index, one, two, three, four>();
STATIC_CHECK(at<0> == &one and at<1> == &two and at<2> == &three and at<3> == &four);

} // namespace

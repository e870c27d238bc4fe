// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A table's registers by their place.
#include <rtuwire/table/table.hpp>

#include <cstdint>

#include "support/proof.hpp"

#include <rtuwire/core/units.hpp>
#include <rtuwire/table/form/whole.hpp>
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

// The words that one request has to read for a value, with those between it and its scale.
inline constexpr reg<signed_count16> steps{.code = "SF", .address = 5};
inline constexpr reg<unsigned32<watt_hours>> wide{.code = "W", .address = 7};
inline constexpr reg<scaled_by<quantity<power, std::uint32_t>, steps>> before{.code = "B", .address = 2};
inline constexpr reg<scaled_by<quantity<power, std::uint32_t>, steps>> behind{.code = "A", .address = 9};
template <auto const& R> constexpr bool takes(std::uint32_t first, std::uint32_t last)
{
    key_range const range = range_of<R>();
    return range.first == key_of(R.space, 0) + first and range.last == key_of(R.space, 0) + last;
}
STATIC_CHECK(takes<four>(4, 4) and takes<wide>(7, 8));
STATIC_CHECK(takes<before>(2, 5) and takes<behind>(5, 10));

} // namespace

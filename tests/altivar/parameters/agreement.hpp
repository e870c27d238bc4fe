// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Holds registers with a type against their rows, from the side of a program that writes typed values.
#pragma once

#include "support/proof.hpp"

#include <set>
#include <string>
#include <string_view>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire::test {

using namespace detail;

/// The words at which a limit, or an enumeration, could be misread.
inline std::set<std::uint16_t> edges_of(altivar::parameter const& row)
{
    std::set<std::uint16_t> words{0, 1, 0x7FFF, 0x8000, 0xFFFF};
    for (bound const& limit : {row.min, row.max}) {
        for (int step = -1; limit.is_number() and step <= 1; ++step) {
            words.insert(static_cast<std::uint16_t>(limit.raw() + step));
        }
    }
    for (choice const& each : row.listed()) {
        words.insert(each.word);
        words.insert(static_cast<std::uint16_t>(each.word + 1));
    }
    return words;
}

/// One register against its row: a typed write takes the words that the row takes.
template <auto const& R> void check_row(altivar::parameter_map const& map)
{
    CAPTURE(std::string_view{R.code});
    altivar::parameter const* const row = map.at(R.address);
    REQUIRE(row != nullptr);
    CHECK(row->code == R.code);
    CHECK(row->name == R.name);
    CHECK(row->mode() == R.mode);
    CHECK(row->source() == R.source);
    CHECK(row->factory == R.factory);
    CHECK(row->steps_set_by == R.steps_set_by);
    for (std::uint16_t const word : edges_of(*row)) {
        CAPTURE(word);
        CHECK(row->takes(row->count_of(word)) == setting<R>::checked(from_word<value_of<R>>(word)).has_value());
    }
}

/// Each register for driving is a row, and no address and no mnemonic stands twice in all groups; of what is not verified
/// nothing is written.
template <typename Device, typename Full>
void check_agreement(altivar::parameter_map const& parameters, altivar::parameter_map const& unverified)
{
    Device::registers::for_each([&]<auto const & R>() { check_row<R>(parameters); });
    std::set<std::uint16_t> addresses;
    std::set<std::string> codes;
    for (altivar::parameter_map const* const map : {&parameters, &unverified}) {
        map->for_each([&](altivar::parameter const& row, altivar::parameter_group const&) {
            std::string const code{std::string_view{row.code}};
            CAPTURE(code);
            CHECK(addresses.insert(row.address).second);
            CHECK(codes.insert(code).second);
            CHECK(Full::registers::has_address(row.address));
            CHECK((map != &unverified or (not row.is_writable() and row.source() == provenance::doubtful)));
        });
    }
    CHECK(codes.size() == Full::registers::size);
}

} // namespace rtuwire::test

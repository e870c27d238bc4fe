// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which texts name the same family of drives.
#include <rtuwire/altivar/maintenance/restore_options.hpp>

#include <string>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// Whether two texts name the same family.
constexpr bool are_same(literal one, literal other) { return drive_family::of(one) == drive_family::of(other); }

STATIC_CHECK(are_same("ATV320U07M2C", "atv320"));
STATIC_CHECK(are_same("ATV12H018M2", "ATV12"));
STATIC_CHECK(are_same("ATV310H037N4", "ATV310"));
STATIC_CHECK(not are_same("ATV320U07M2C", "ATV32H018M2"));
STATIC_CHECK(not are_same("ATV12H018M2", "ATV120"));
STATIC_CHECK(not are_same("ATV310H037N4E", "ATV320"));
STATIC_CHECK(drive_family::of("320").is_known() == false);
STATIC_CHECK(drive_family::of("").is_known() == false);
STATIC_CHECK(drive_family::of("ATV").is_known() == false);
STATIC_CHECK(drive_family::of("ATV 320").is_known() == false);
STATIC_CHECK(drive_family::of("ATVATVATV320").is_known() == false);
STATIC_CHECK(drive_family::of("ATV123456").is_known() == false);
STATIC_CHECK(drive_family::of("X1").is_known());
STATIC_CHECK(drive_family::of(byte_view{"41 54 56 33 32 30 55"_hex}) == drive_family::of("ATV320"));

} // namespace

TEST_CASE("a family is read of a text that is known when the program runs")
{
    CHECK(drive_family::of(std::string{"atv320"}) == drive_family::of("ATV320U11N4B"));
    CHECK_FALSE(drive_family::of(std::string{"atv340"}) == drive_family::of("ATV320U11N4B"));
}

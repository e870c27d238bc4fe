// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The full map of the ATV12: descriptors and rows agree, register by register. What the compiler lets a program write is
// what the row says may be written.
#include <rtuwire/altivar/parameters/atv12.hpp>

#include "altivar/parameters/agreement.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

STATIC_CHECK(atv12::parameters.size() == 239 and atv12::unverified_parameters.size() == 2);

TEST_CASE("parameters of the ATV12: each descriptor is a row, and takes what the row takes")
{
    test::check_agreement<atv12::full_device>(atv12::parameters, atv12::unverified_parameters);
}

TEST_CASE("parameters of the ATV12: the registers for driving are the same objects")
{
    CHECK(test::has_all_of<atv12::full_device, atv12::device>());
}

} // namespace

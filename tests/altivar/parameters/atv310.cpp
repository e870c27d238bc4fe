// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The full map of the ATV310: descriptors and rows agree, register by register. What the compiler lets a program write is
// what the row says may be written.
#include <rtuwire/altivar/parameters/atv310.hpp>

#include "altivar/parameters/agreement.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

STATIC_CHECK(atv310::parameters.size() == 97 and atv310::parameters_2014.size() == 81);

TEST_CASE("parameters of the ATV310: each descriptor is a row, and takes what the row takes")
{
    test::check_agreement<atv310::full_device>(atv310::parameters, parameter_map{{}});
    test::check_agreement<atv310::full_device_2014>(atv310::parameters_2014, parameter_map{{}});
}

TEST_CASE("parameters of the ATV310: the registers for driving are the same objects")
{
    CHECK(test::has_all_of<atv310::full_device, atv310::device_2026>());
    CHECK(test::has_all_of<atv310::full_device_2014, atv310::device>());
}

} // namespace

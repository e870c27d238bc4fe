// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The full map of the ATV310: registers with a type and rows agree. What the compiler lets a program write is
// what the row says may be written.
#include <rtuwire/altivar/parameters/atv310.hpp>

#include "altivar/parameters/agreement.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

STATIC_CHECK(atv310::parameters_2014.size() == atv310::parameters.size() - 16); // without the later scanner words

TEST_CASE("parameters of the ATV310: each register for driving is a row, and takes what the row takes")
{
    test::check_agreement<atv310::device_2026, atv310::full_device>(atv310::parameters, parameter_map{{}});
    test::check_agreement<atv310::device, atv310::full_device_2014>(atv310::parameters_2014, parameter_map{{}});
}

TEST_CASE("parameters of the ATV310: a register by its mnemonic takes what its row takes")
{
    test::check_row<atv310::parameter<"CTT">>(atv310::parameters);
    test::check_row<atv310::parameter<"AIV1">>(atv310::parameters);
    test::check_row<atv310::parameter<"CRC">>(atv310::parameters);
}

} // namespace

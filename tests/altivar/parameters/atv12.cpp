// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The full map of the ATV12: registers with a type and rows agree. What the compiler lets a program write is
// what the row says may be written.
#include <rtuwire/altivar/parameters/atv12.hpp>

#include "altivar/parameters/agreement.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

TEST_CASE("parameters of the ATV12: each register for driving is a row, and takes what the row takes")
{
    test::check_agreement<atv12::device, atv12::full_device>(atv12::parameters, atv12::unverified_parameters);
}

TEST_CASE("parameters of the ATV12: a register by its mnemonic takes what its row takes")
{
    test::check_row<atv12::parameter<"SP2">>(atv12::parameters);
    test::check_row<atv12::parameter<"NST">>(atv12::parameters);
    test::check_row<atv12::parameter<"PIF">>(atv12::parameters);
    test::check_row<atv12::parameter<"LPI">>(atv12::parameters);
    test::check_row<atv12::parameter<"EP0">>(atv12::parameters);
}

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Quantities as the examples print them.
#include "support/catch.hpp"

#include <rtuwire/core/units.hpp>

#include "../../examples/support/figures.hpp"

using namespace rtuwire;
using examples::figures;

TEST_CASE("examples: steps are printed with their point, their zeros and their sign")
{
    CHECK(figures(487, 1) == "48.7");
    CHECK(figures(-52, 1) == "-5.2");
    CHECK(figures(-1, 1) == "-0.1");
    CHECK(figures(-10, 1) == "-1.0");
    CHECK(figures(0, 1) == "0.0");
    CHECK(figures(5, 3) == "0.005");
    CHECK(figures(-1'005, 3) == "-1.005");
    CHECK(figures(-7, 0) == "-7");
}

TEST_CASE("examples: a quantity is printed in its unit, whatever its register's step")
{
    CHECK(figures(signed_decihertz{-52}) == "-5.2");
    CHECK(figures(signed_decihertz{-1}) == "-0.1");
    CHECK(figures(signed_decihertz{-32'768}) == "-3276.8");
    CHECK(figures(deciseconds{13}) == "1.3");
    CHECK(figures(celsius{-5}) == "-5");
}

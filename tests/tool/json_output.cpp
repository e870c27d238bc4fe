// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Numbers as programs read them.
#include "output/output.hpp"

#include <cstdlib>
#include <limits>
#include <string>

#include "support/catch.hpp"

namespace {

std::string text_of(double value) { return tool::make_json()->text_of({{"value", value}}); }

} // namespace

TEST_CASE("defect: D41 a number in JSON has no digits that are only of its arithmetic")
{
    CHECK(text_of(12 / 10.0) == "{\"value\":1.2}\n");
    CHECK(text_of(-50.0) == "{\"value\":-50.0}\n");
    CHECK(text_of(0.0) == "{\"value\":0.0}\n");
    // What was measured keeps its digits.
    CHECK(text_of(1764187.123456) == "{\"value\":1764187.123456}\n");
    CHECK(text_of(0.000123456789) == "{\"value\":0.000123456789}\n");
}

TEST_CASE("defect: D41 every count of each step of a drive has a short number in JSON")
{
    for (double const divisor : {10.0, 100.0, 1'000.0}) {
        for (int count = -32'768; count <= 65'535; ++count) {
            // Sign, digits, a point, a zero behind or in front of it.
            if (std::string const text = text_of(count / divisor);
                text.size() > std::string{"{\"value\":-32.768}\n"}.size()) {
                FAIL(text);
            }
        }
    }
    SUCCEED();
}

TEST_CASE("a number means the same to whoever reads it, in JSON and in CSV")
{
    using limits = std::numeric_limits<double>;
    for (double const value : {0.1 + 0.2, 1.0 / 3.0, limits::max(), -limits::max(), limits::min(), limits::denorm_min(),
                               9007199254740993.0}) {
        std::string const json = text_of(value);
        CHECK(std::strtod(json.c_str() + std::string{"{\"value\":"}.size(), nullptr) == value);
        CHECK(std::strtod(tool::text_of_cell(value).c_str(), nullptr) == value);
    }
    CHECK(text_of(limits::infinity()) == "{\"value\":null}\n");
    CHECK(tool::text_of_cell(50.0) == "50");
    CHECK(tool::text_of_cell(100'000.0) == "100000");
    CHECK(tool::text_of_cell(-3e14) == "-300000000000000");
    CHECK(tool::text_of_cell(230.1) == "230.1");
}

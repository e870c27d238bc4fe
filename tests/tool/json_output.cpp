// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Numbers as programs read them.
#include "output/output.hpp"

#include <string>

#include "support/catch.hpp"

namespace {

std::string text_of(double value) { return tool::make_json()->text_of({{"value", value}}); }

} // namespace

TEST_CASE("defect: D41 a number in JSON has no digits that are only of its arithmetic")
{
    CHECK(text_of(12 * 0.1) == "{\"value\":1.2}\n");
    CHECK(text_of(3 * 0.1) == "{\"value\":0.3}\n");
    CHECK(text_of(-50.0) == "{\"value\":-50.0}\n");
    CHECK(text_of(0.0) == "{\"value\":0.0}\n");
    // What was measured keeps its digits.
    CHECK(text_of(1764187.123456) == "{\"value\":1764187.123456}\n");
    CHECK(text_of(0.000123456789) == "{\"value\":0.000123456789}\n");
}

TEST_CASE("defect: D41 every count of a current has a short number in JSON")
{
    for (int count = 0; count <= 65'535; ++count) {
        std::string const text = text_of(count * 0.1);
        if (text.size() > std::string{"{\"value\":6553.5}\n"}.size()) {
            FAIL(text);
        }
    }
    SUCCEED();
}

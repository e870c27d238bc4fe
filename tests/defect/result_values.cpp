// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value that is not there is never read: the program's hook is called, and the program ends.
#include <rtuwire/core/result.hpp>

#include <cstdint>

#include "defect/missing_value_hook.hpp"
#include "defect/result_values.hpp"

static_assert(RTUWIRE_CHECKED == 1, "reading a value that is not there is caught where there is a system");

TEST_CASE("defect: the value of a failed result is not read") { test::values_are_checked(); }

TEST_CASE("defect: the hook is told why there is no value")
{
    for (unsigned code = 1; code < 256; ++code) {
        auto const error = static_cast<errc>(code);
        test::end const end = test::end_of([&] {
            result<std::uint32_t> const failed{error};
            test::consume(*failed);
        });
        INFO(code);
        CHECK((end.is_trap and end.left == static_cast<int>(code)));
    }
}

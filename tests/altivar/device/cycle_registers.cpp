// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which registers belong to a scanner; which to none.
#include <rtuwire/altivar/device/cycle_registers.hpp>

#include "support/proof.hpp"

using namespace rtuwire::altivar;

namespace {

// A drive that says nothing of a scanner has none.
constexpr scanner_registers none{};
STATIC_CHECK(none.input_addresses == 0 and none.output_addresses == 0 and none.words == 0);
STATIC_CHECK(none.input_words == 0 and none.output_words == 0);
STATIC_CHECK(not none.has(0) and not none.has(1) and not none.is_output(0) and not none.is_output(65'535));

constexpr scanner_registers some{100, 200, 300, 400, 3};

/// Of all registers: the three of each row belong to it, and the last row alone holds what is written.
constexpr bool are_its_own(unsigned first, unsigned last)
{
    bool ok = true;
    for (unsigned address = first; address <= last; ++address) {
        auto const at = static_cast<std::uint16_t>(address);
        bool const is_in_a_row = address >= 100 and address < 500 and address % 100 < 3;
        ok = ok and some.has(at) == is_in_a_row and some.is_output(at) == (is_in_a_row and address >= 400);
    }
    return ok;
}
constexpr bool are_all_its_own() { return are_its_own(0, 600) and are_its_own(65'000, 65'535); }
PROOF("the registers of a scanner", are_all_its_own)

// A row up to the last register.
constexpr scanner_registers at_the_end{10, 20, 30, 65'534, 2};
STATIC_CHECK(at_the_end.has(65'535) and at_the_end.is_output(65'535) and not at_the_end.has(0));

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program of two files that were built differently: each has to run its own code. Where a function of
// rtuwire had one name in both, the linker would keep one of them for both files.
#include "linked.hpp"

#include <cstdio>

namespace {

int failures = 0;

void is(bool holds, char const* fact)
{
    if (not holds) {
        ++failures;
        std::printf("does not hold: %s\n", fact);
    }
}

} // namespace

int main()
{
    facts const first = first_facts();
    facts const second = second_facts();
    is(first.crc == 0x4B37 and second.crc == 0x4B37, "both files compute the same CRC");
    is(first.form != second.form, "the files are built with different forms of the CRC");
    is(first.is_checked and not second.is_checked, "the first file is built with checks, the second without");
    is(first.checks_frames != second.checks_frames, "each file has a check_frame of its own");
    is(first.traps, "the first file traps where a value is missing");
    is(not second.traps, "the second file does not");
    return failures == 0 ? 0 : 1;
}

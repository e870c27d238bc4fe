// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Runs one operation, or what does not count of it, a thousand times under callgrind:
// count_host NUMBER run|less. Without arguments, their names.
#include <cstdio>
#include <cstdlib>
#include <string>

#include RTUWIRE_OPERATIONS

int main(int argc, char** argv)
{
    if (not operations::are_right()) {
        return 1;
    }
    if (argc != 3) {
        for (operations::operation const& each : operations::list) {
            std::puts(each.name);
        }
        return 0;
    }
    operations::operation const& chosen = operations::list[std::atoi(argv[1])];
    auto* const run = std::string{argv[2]} == "less" ? chosen.less : chosen.run;
    for (unsigned round = 0; round < 1'000; ++round) {
        run();
    }
    return 0;
}

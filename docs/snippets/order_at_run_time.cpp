// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of driving shows of a frequency that is known only when the program runs: checked, then ordered.
//! [head]
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
//! [head]

namespace {

constexpr station<atv320::device> drive{unit_id{7}};

using test_line = decltype(sim::bench{line_timing{19'200, character_format::even_8_1}, drive});

/// Whether the drive runs as somebody entered, in tenths of a hertz.
bool run_at(test_line& line, int entered)
{
    //! [order]
    auto const speed = setting<atv320::lfr>::checked(entered * 0.1_Hz); // entered: an int
    if (not speed) {
        std::cout << speed.error() << '\n'; // value above the register's maximum; no order was given
        return false;
    }
    start go{drive, *speed}; // likewise change_reference{drive, *speed}
    //! [order]
    std::cout << line.run(go) << '\n';
    return go.running();
}

} // namespace

int main()
{
    test_line line{line_timing{19'200, character_format::even_8_1}, drive};
    bool const is_refused = not run_at(line, 7'000);
    bool const is_running = run_at(line, 303);
    change_reference slower{drive, *setting<atv320::lfr>::checked(25 * 1_Hz)};
    std::cout << line.run(slower) << '\n';
    return is_refused and is_running and slower.succeeded() ? 0 : 1;
}

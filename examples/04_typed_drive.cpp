// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive with types: values that are known only at run time, one read, and a plan that is polled into a snapshot. The
// drive is a bank of its registers at the other end of a simulated line.
#include <iostream>

#include <rtuwire/print.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

using monitor = read_plan<atv12::device, atv12::eta, atv12::rfr, atv12::lcr, atv12::acc>;

int main()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    bank<atv12::eta, atv12::rfr, atv12::frh, atv12::lcr, atv12::acc> registers{};
    registers.set<atv12::eta>(status_word{0x0237});
    registers.set<atv12::rfr>(48.7_Hz);
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{drive.unit(), registers}};

    unsigned refused = 0;
    for (int const ramp : {10'000, 13}) { // tenths of a second, from a panel or a file
        auto const written = bench.run(write<atv12::acc>(drive, checked(ramp * 0.1_s)));
        if (not written) {
            ++refused;
            std::cout << ramp * 0.1_s << ": " << written.error() << '\n';
        }
    }
    auto const speed = bench.run(read<atv12::rfr>(drive));
    if (not speed) {
        std::cout << speed.error() << '\n';
        return 1;
    }
    poller<monitor> panel{drive};
    bool const is_polled = bench.run(panel).has_value();

    auto const& seen = panel.latest();
    bool const runs = seen.get<atv12::eta>().has(status_bit::operation_enabled);
    std::cout << monitor::request_count << " requests: " << (runs ? "running" : "stopped") << " at " << *speed
              << ", ramp " << seen.get<atv12::acc>() << ", " << 50_Hz - *speed << " below 50 Hz\n";
    bool const is_right = *speed > 48_Hz and *speed < 49_Hz and seen.get<atv12::acc>() == 1.3_s;
    return refused == 1 and is_polled and is_right and runs ? 0 : 1;
}

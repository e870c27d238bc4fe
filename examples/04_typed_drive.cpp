// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive with types: one read, one write, and a plan that is polled into a snapshot. The drive is a bank of its
// registers at the other end of a simulated line.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

#include "support/figures.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using examples::figures;

using monitor = read_plan<atv12::device, atv12::eta, atv12::rfr, atv12::lcr, atv12::acc>;

int main()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    bank<atv12::eta, atv12::rfr, atv12::frh, atv12::lcr, atv12::acc> registers{};
    registers.set<atv12::eta>(status_word{0x0237});
    registers.set<atv12::rfr>(signed_decihertz{487});
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, sim::bank_at{drive.unit(), registers}};

    bool const is_written = bench.run(write<atv12::acc>(drive, 1.3_s)).has_value();
    auto const speed = bench.run(read<atv12::rfr>(drive));
    poller<monitor> panel{drive};
    bool const is_polled = bench.run(panel).has_value();

    auto const& seen = panel.latest();
    bool const runs = seen.get<atv12::eta>().has(status_bit::operation_enabled);
    std::printf("%zu requests: %s at %s Hz, ramp %s s\n", monitor::request_count, runs ? "running" : "stopped",
                figures(seen.get<atv12::rfr>()).c_str(), figures(seen.get<atv12::acc>()).c_str());
    bool const is_right = speed == signed_decihertz{487} and seen.get<atv12::acc>() == deciseconds{13};
    return is_written and is_polled and is_right and runs ? 0 : 1;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 3: a drive is polled, and its values are printed with their units. A plan names the registers; the library
// makes as few requests of it as the drive allows. The drive is a bank of its registers at the other end of a simulated
// line. Builds on lesson 2.
#include <iostream>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

//! [plan]
// Status word, output frequency, motor current, and the acceleration ramp: four registers in two requests.
using monitor = read_plan<atv12::device, atv12::eta, atv12::rfr, atv12::lcr, atv12::acc>;
//! [plan]

int main()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    bank<atv12::eta, atv12::rfr, atv12::frh, atv12::lcr, atv12::acc> registers;
    registers.set<atv12::eta>(status_word{0x0237});
    registers.set<atv12::acc>(1.3_s);
    registers.set<atv12::lcr>(3.2_A);
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{drive.unit(), registers}};

    poller<monitor> panel{drive};
    int rounds = 0;
    for (signed_decihertz const speed : {signed_decihertz{-52}, signed_decihertz{0}, signed_decihertz{487}}) {
        registers.set<atv12::rfr>(speed); // the motor speeds up
        //! [round]
        if (auto const round = bench.run(panel); not round) { // each run is a new round
            std::cout << "no values: " << round.error() << '\n';
            return 1;
        }
        auto const& seen = panel.latest();
        bool const runs = seen.get<atv12::eta>().has(status_bit::operation_enabled);
        std::cout << (runs ? "running" : "stopped") << " at " << seen.get<atv12::rfr>() << ", "
                  << seen.get<atv12::lcr>() << ", ramp " << seen.get<atv12::acc>() << '\n';
        //! [round]
        rounds += runs and seen.get<atv12::rfr>() == speed and seen.get<atv12::acc>() == 1.3_s ? 1 : 0;
    }
    std::cout << "each round took " << monitor::request_count << " requests\n";
    return rounds == 3 and monitor::request_count == 2 ? 0 : 1;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 5: a number from a panel, a file or a network is written to a drive. Give it its unit and pass it through
// `checked`: what does not fit its register is refused with the reason, and no frame leaves. Builds on lessons 3 and 4.
#include <iostream>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

int main()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    bank<atv12::acc, atv12::dec> registers; // stands for the drive
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{drive.unit(), registers}};

    struct {
        int hundredths; // of a second, as somebody typed them
        errc expected;
    } const typed[] = {{130, errc::none},
                       {123, errc::value_between_steps},
                       {200'000, errc::value_too_high},
                       {-10, errc::value_too_low}};
    int as_expected = 0;
    for (auto const& each : typed) {
        auto const written = bench.run(write<atv12::acc>(drive, checked(each.hundredths * 0.01_s)));
        std::cout << each.hundredths * 0.01_s << ": ";
        if (written) {
            std::cout << "written\n";
        } else {
            std::cout << written.error() << '\n';
        }
        as_expected += (written ? errc::none : written.error()) == each.expected ? 1 : 0;
    }

    // Several registers at once, by one request; none is written where one does not fit.
    int const ramp = 25;
    auto const both =
        bench.run(write_all<atv12::acc, atv12::dec>(drive, checked(ramp * 0.1_s), checked(2 * ramp * 0.1_s)));
    std::cout << "both ramps: " << (both ? "written" : name(both.error())) << '\n';

    // A value is tested before it is used for something else than a write, too.
    auto const setting_now = setting<atv12::dec>::checked(ramp * 1_s);
    std::cout << "25 s for DEC: " << (setting_now ? "fits" : "does not fit") << '\n';

    // What the drive itself refuses arrives as its exception. This one is known here only by its number.
    auto const refused = bench.run(single_request{drive.unit(), write_single_register{.address = 1, .value = 1}});
    std::cout << "register 1: " << refused.error() << '\n';
    return as_expected == 4 and both and registers.get<atv12::acc>() == 2.5_s and registers.get<atv12::dec>() == 5_s and
                   setting_now and refused == errc::illegal_data_address
               ? 0
               : 1;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 6: a device of your own: a pump with three registers as rows, its server, and a client that knows its types.
// Builds on lessons 2 and 3.
#include <iostream>

#include <rtuwire/print.hpp>
#include <rtuwire/rows.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace pump {

namespace rows {

using namespace row_words;

// clang-format off
inline constexpr register_row all[]{
    {"SET", 10, rw, in<decihertz>, 0,  600, {}, "Wanted frequency"},
    {"ACT", 11, ro, in<decihertz>, {}, {},  {}, "Frequency"},
    {"TMP", 12, ro, in<celsius>,   {}, {},  {}, "Temperature of the bearing"},
};
// clang-format on

} // namespace rows

struct device {
    static constexpr literal name{"pump"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<decihertz, celsius>;
    using registers = row_table<device, table<>, rows::all>;
};
template <mnemonic Code> inline constexpr auto const& row = parameter_called<device, Code>;

} // namespace pump

int main()
{
    bank_of<pump::device> registers; // the pump's end
    registers.set<pump::row<"TMP">>(celsius{-5});
    constexpr station<pump::device> far_pump{unit_id{3}}; // the client's
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{far_pump.unit(), registers}};

    auto const written = bench.run(write<pump::row<"SET">>(far_pump, 47.5_Hz));
    // auto const wrong = write<pump::row<"SET">>(far_pump, 60.5_Hz); // does not compile: above the register's maximum
    if (not written) {
        std::cout << written.error() << '\n';
        return 1;
    }
    if (registers.take_written<pump::row<"SET">>()) { // a client wrote it since the last call
        registers.set<pump::row<"ACT">>(registers.get<pump::row<"SET">>());
    }

    using seen = read_plan<pump::device, pump::row<"ACT">, pump::row<"TMP">>;
    poller<seen> panel{far_pump};
    if (auto const round = bench.run(panel); not round) {
        std::cout << round.error() << '\n';
        return 1;
    }
    auto const speed = panel.latest().get<pump::row<"ACT">>();
    auto const bearing = panel.latest().get<pump::row<"TMP">>();
    std::cout << "the pump runs at " << speed << ", its bearing has " << bearing << '\n';
    return speed == 47.5_Hz and bearing == celsius{-5} ? 0 : 1;
}

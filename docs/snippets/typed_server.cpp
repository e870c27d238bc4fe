// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of registers shows of the values in a typed server: set by the device itself, and read by a client.
#include <array>
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace meter {

inline constexpr reg<float32<kilowatt_hours, word_order::low_first>> energy{.code = "ENERGY", .address = 40};
inline constexpr reg<unsigned32<watt_hours>> budget{.code = "BUDGET", .address = 42, .max = 4'000'000'000};
inline constexpr input_reg<decivolts> voltage{.code = "U", .address = 40};
inline constexpr coil relay{.code = "K1", .address = 40};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<energy, budget, voltage, relay>;
};

using registers = bank<energy, budget, voltage, relay>;

} // namespace meter

namespace {

/// Sets all that the meter shows.
bool measure(meter::registers& registers, int tenths, float counted)
{
    //! [set]
    registers.set<meter::budget>(70_kWh);                        // a constant
    registers.set<meter::energy>(real<kilowatt_hours>{counted}); // counted: a float
    registers.set<meter::relay>(true);
    auto const volts = setting<meter::voltage>::checked(tenths * 0.1_V); // tenths: an int
    if (not volts) {
        return false;
    }
    registers.set<meter::voltage>(volts->value());
    //! [set]
    return true;
}

} // namespace

int main()
{
    constexpr station<meter::device> far_meter{unit_id{3}};
    meter::registers registers;
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{far_meter.unit(), registers}};
    bool const is_set = measure(registers, 2'304, 12.5F);
    auto const energy = bench.run(read<meter::energy>(far_meter));
    auto const voltage = bench.run(read<meter::voltage>(far_meter));
    if (not energy or not voltage) {
        return 1;
    }
    std::cout << *energy << ", " << *voltage << ", " << registers.get<meter::budget>() << '\n';
    return is_set and *voltage == 230.4_V and registers.get<meter::relay>() ? 0 : 1;
}

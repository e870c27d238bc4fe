// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 15: an energy meter on the line of a drive, polled by the same bus: 40 registers of four kinds, as rows.
// Floating point numbers and wide counters, values by name, relays and contacts; a text and a power whose decimal scale
// another register holds are objects. Both units are simulated here. Builds on lessons 6 and 13.
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/rows.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using altivar::atv320::rfr;

namespace meter {

// As the manual of such a meter has it: the low word first, and read-only, because most are input registers.
template <typename Unit> using low = float32<Unit, word_order::low_first>;
using counter = unsigned32<watt_hours, word_order::low_first>;

// What no row can hold is an object: a text, and an amount whose scale another register has.
inline constexpr input_reg<signed_count16> scale{.code = "SCALE", .address = 46};
inline constexpr input_reg<scaled_by<quantity<power, std::int16_t>, scale>> load{.code = "LOAD", .address = 47};
inline constexpr reg<ascii<8>> place{.code = "PLACE", .address = 100};

namespace rows {

using namespace row_words;

inline constexpr choice tariffs[]{{1, "DAY", "day rate"}, {2, "NIGHT", "night rate"}};
inline constexpr choice rates[]{{0, "9.6", "9600 bit/s"}, {1, "19.2", "19200 bit/s"}, {2, "38.4", "38400 bit/s"}};
inline constexpr choice alarm_bits[]{{0, "OV", "over voltage"}, {1, "UV", "under voltage"}, {7, "CT", "open circuit"}};

// clang-format off
inline constexpr register_row measured[]{
    {"ENERGY",   40, input, in<low<kilowatt_hours>>, {}, {}, {}, "Energy, imported"},
    {"VOLTAGE",  42, input, in<low<volts>>,          {}, {}, {}, "Voltage, mean"},
    {"EXPORTED", 44, input, in<counter>,             {}, {}, {}, "Energy, exported"},
    {"U1",       48, input, in<low<volts>>,          {}, {}, {}, "Voltage, phase 1"},
    {"U2",       50, input, in<low<volts>>,          {}, {}, {}, "Voltage, phase 2"},
    {"U3",       52, input, in<low<volts>>,          {}, {}, {}, "Voltage, phase 3"},
    {"U12",      54, input, in<low<volts>>,          {}, {}, {}, "Voltage, 1 to 2"},
    {"U23",      56, input, in<low<volts>>,          {}, {}, {}, "Voltage, 2 to 3"},
    {"U31",      58, input, in<low<volts>>,          {}, {}, {}, "Voltage, 3 to 1"},
    {"I1",       60, input, in<low<amperes>>,        {}, {}, {}, "Current, phase 1"},
    {"I2",       62, input, in<low<amperes>>,        {}, {}, {}, "Current, phase 2"},
    {"I3",       64, input, in<low<amperes>>,        {}, {}, {}, "Current, phase 3"},
    {"IN",       66, input, in<low<amperes>>,        {}, {}, {}, "Current, neutral"},
    {"F",        68, input, in<low<hertz>>,          {}, {}, {}, "Frequency"},
    {"E1",       70, input, in<counter>,             {}, {}, {}, "Energy, day rate"},
    {"E2",       72, input, in<counter>,             {}, {}, {}, "Energy, night rate"},
    {"RUN",      74, input, in<unsigned32<hours>>,   {}, {}, {}, "Time in operation"},
    {"ALARMS",   76, input, bits(alarm_bits),        {}, {}, {}, "Alarms"},
    {"NOW",      77, input, tariffs,                 {}, {}, {}, "Tariff that counts"},
    {"TEMP",     78, input, in<celsius>,             {}, {}, {}, "Temperature"},
};
inline constexpr register_row settings[]{
    {"BUDGET",  104, rw, in<unsigned32<watt_hours>>, {}, 4'000'000'000, {}, "Energy that is free"},
    {"TARIFF",  106, rw, tariffs,       {}, {},    1,  "Tariff"},
    {"CTP",     107, rw, in<count16>,   1,  9999,  50, "Current transformer, primary"},
    {"CTS",     108, rw, in<count16>,   1,  5,     5,  "Current transformer, secondary"},
    {"DEMAND",  109, rw, in<seconds>,   60, 3600,  900, "Period of the mean power"},
    {"ADDRESS", 110, rw, in<count16>,   1,  247,   3,  "Unit address"},
    {"RATE",    111, rw, rates,         {}, {},    1,  "Rate of the line"},
    {"SERIAL",  112, ro, in<unsigned64<>>, {}, {}, {}, "Serial number"},
};
inline constexpr register_row contacts[]{
    {"K1", 0, coil_rw,  in<bool>, {}, {}, {}, "Relay of the budget"},
    {"K2", 1, coil_rw,  in<bool>, {}, {}, {}, "Relay of the tariff"},
    {"K3", 2, coil_rw,  in<bool>, {}, {}, {}, "Relay of the alarms"},
    {"S1", 0, discrete, in<bool>, {}, {}, {}, "Input 1"},
    {"S2", 1, discrete, in<bool>, {}, {}, {}, "Input 2"},
    {"S3", 2, discrete, in<bool>, {}, {}, {}, "Input 3"},
    {"S4", 3, discrete, in<bool>, {}, {}, {}, "Input 4"},
    {"W1", 8, discrete, in<bool>, {}, {}, {}, "Phases in order"},
    {"W2", 9, discrete, in<bool>, {}, {}, {}, "Seal closed"},
};
// clang-format on

} // namespace rows

struct device {
    static constexpr literal name{"energy meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 16};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<low<kilowatt_hours>, low<volts>, low<amperes>, low<hertz>, counter, unsigned32<hours>,
                                 unsigned32<watt_hours>, unsigned64<>, celsius, count16, seconds>;
    using registers = row_table<device, table<scale, load, place>, rows::measured, rows::settings, rows::contacts>;
};
template <mnemonic Code> inline constexpr auto const& row = parameter_called<device, Code>;

/// The meter's own side has the same rows, and counts its power in tenths of a watt.
using own_load = quantity<power, std::int16_t, std::deci>;
struct inside : device {
    using registers = row_table<device, table<scale, restepped<own_load, load>, place>, rows::measured, rows::settings,
                                rows::contacts>;
};
using registers = bank_of<inside>;

} // namespace meter

int main()
{
    constexpr station<altivar::atv320::device> drive{unit_id{7}};
    constexpr station<meter::device> far_meter{unit_id{3}};

    meter::registers inside;
    inside.set<meter::row<"ENERGY">>(1234.5_kWh);
    inside.set<meter::row<"VOLTAGE">>(real<volts>{230.4F});
    inside.set<meter::row<"EXPORTED">>(70_kWh);
    inside.set<meter::scale>(signed_count16{-1});
    inside.set<restepped<meter::own_load, meter::load>>(-12.3_W);
    sim::bench bench{bus<2>{line_timing{19'200, character_format::even_8_1}}, drive, bank_at{far_meter.unit(), inside}};

    // One request of eight registers: what is wide is never cut, and voltage and power are of one moment.
    using readings = read_plan<meter::device, meter::row<"ENERGY">, meter::row<"EXPORTED">,
                               together<meter::row<"VOLTAGE">, meter::load>>;
    poller<readings> panel{far_meter};
    auto speed = read<rfr>(drive);
    if (not bench.run(panel, speed) or not panel.outcome() or not speed.outcome()) {
        return 1;
    }
    auto const& now = panel.latest();
    auto const energy = now.get<meter::row<"ENERGY">>(); // a result: what is no number is refused
    auto const load = now.get<meter::load>();
    if (not energy or not load) {
        return 1;
    }
    std::cout << "energy " << *energy << ", exported " << now.get<meter::row<"EXPORTED">>() << ", power " << *load
              << '\n';
    // A value by its name, and a coil.
    auto night = write<meter::row<"TARIFF">>(far_meter, named<"NIGHT">);
    auto relay = write<meter::row<"K2">>(far_meter, true);
    if (not bench.run(night, relay) or not night.outcome() or inside.get<meter::row<"TARIFF">>() != named<"NIGHT"> or
        not inside.get<meter::row<"K2">>()) {
        return 1;
    }
    bool const is_over = *energy > 1'000_kWh and *load < 0_W;

    // Both words of the budget leave in one request; what does not fit is not sent.
    std::int64_t const entered = 250;
    auto tell = write<meter::row<"BUDGET">>(far_meter, checked(entered * 1_kWh));
    auto too_much = write<meter::row<"BUDGET">>(far_meter, checked(entered * 1'000 * 1'000 * 1_kWh));
    auto label = write<meter::place>(far_meter, "HALL 3");
    bool const is_told = bench.run(tell, label) and tell.outcome() and label.outcome();
    std::cout << "budget " << inside.get<meter::row<"BUDGET">>() << " in " << inside.get<meter::place>() << "; "
              << too_much.outcome().error() << '\n';
    return is_over and is_told and inside.get<meter::row<"BUDGET">>() == 250_kWh ? 0 : 1;
}

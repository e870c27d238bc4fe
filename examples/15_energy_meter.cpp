// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An energy meter on the line of a drive, polled by the same bus: floating point numbers and wide counters in input
// registers, a text, and a power whose decimal scale another register holds. Both units are simulated here.
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using altivar::atv320::rfr;

namespace meter {

// As the manual of such a meter has it: the low word first, and read-only, because these are input registers.
inline constexpr input_reg<float32<kilowatt_hours, word_order::low_first>> energy{.code = "ENERGY", .address = 40};
inline constexpr input_reg<float32<volts, word_order::low_first>> voltage{.code = "VOLTAGE", .address = 42};
inline constexpr input_reg<unsigned32<watt_hours, word_order::low_first>> exported{.code = "EXPORTED", .address = 44};
inline constexpr input_reg<signed_count16> scale{.code = "SCALE", .address = 46};
inline constexpr input_reg<scaled_by<quantity<power, std::int16_t>, scale>> load{.code = "LOAD", .address = 47};
inline constexpr reg<ascii<8>> place{.code = "PLACE", .address = 100};
inline constexpr reg<unsigned32<watt_hours>> budget{.code = "BUDGET", .address = 104, .max = 4'000'000'000};

struct device {
    static constexpr literal name{"energy meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 16};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<energy, voltage, exported, scale, load, place, budget>;
};

/// The meter's own side counts its power in tenths of a watt.
using own_load = quantity<power, std::int16_t, std::deci>;
using registers = bank<energy, voltage, exported, scale, restepped<own_load, load>, place, budget>;

} // namespace meter

int main()
{
    constexpr station<altivar::atv320::device> drive{unit_id{7}};
    constexpr station<meter::device> far_meter{unit_id{3}};

    meter::registers inside;
    inside.set<meter::energy>(1234.5_kWh);
    inside.set<meter::voltage>(real<volts>{230.4F});
    inside.set<meter::exported>(70_kWh);
    inside.set<meter::scale>(signed_count16{-1});
    inside.set<restepped<meter::own_load, meter::load>>(-12.3_W);
    sim::bench bench{bus<2>{line_timing{19'200, character_format::even_8_1}}, drive, bank_at{far_meter.unit(), inside}};

    // One request of eight registers: what is wide is never cut, and voltage and power are of one moment.
    using readings = read_plan<meter::device, meter::energy, meter::exported, together<meter::voltage, meter::load>>;
    poller<readings> panel{far_meter};
    auto speed = read<rfr>(drive);
    if (not bench.run(panel, speed) or not panel.outcome() or not speed.outcome()) {
        return 1;
    }
    auto const& now = panel.latest();
    auto const energy = now.get<meter::energy>(); // a result: what is no number is refused
    auto const load = now.get<meter::load>();
    if (not energy or not load) {
        return 1;
    }
    std::cout << "energy " << *energy << ", exported " << now.get<meter::exported>() << ", power " << *load << '\n';
    bool const is_over = *energy > 1'000_kWh and *load < 0_W;

    // Both words of the budget leave in one request; what does not fit is not sent.
    std::int64_t const entered = 250;
    auto tell = write<meter::budget>(far_meter, checked(entered * 1_kWh));
    auto too_much = write<meter::budget>(far_meter, checked(entered * 1'000 * 1'000 * 1_kWh));
    auto label = write<meter::place>(far_meter, "HALL 3");
    bool const is_told = bench.run(tell, label) and tell.outcome() and label.outcome();
    std::cout << "budget " << inside.get<meter::budget>() << " in " << inside.get<meter::place>() << "; "
              << too_much.outcome().error() << '\n';
    return is_over and is_told and inside.get<meter::budget>() == 250_kWh ? 0 : 1;
}

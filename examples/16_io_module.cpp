// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An I/O module on the line of a drive, polled by the same bus: coils, discrete inputs, a word of several fields and an
// enumeration with holes. A closed contact stops the drive. Both units are simulated here.
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace module {

enum class power_source : std::uint16_t { mains = 1, battery = 4 };

} // namespace module

template <>
inline constexpr auto rtuwire::enumerators<module::power_source> =
    std::array{rtuwire::named_value{1, "mains"}, rtuwire::named_value{4, "battery"}};

namespace module {

inline constexpr coil lamp{.code = "H1", .address = 0};
inline constexpr coil horn{.code = "H2", .address = 1};
inline constexpr discrete_input guard{.code = "S1", .address = 0};
inline constexpr discrete_input reset{.code = "S2", .address = 1};
inline constexpr input_reg<known<power_source>> supply{.code = "SUPPLY", .address = 0};

/// Two values in one word: bits 0 to 3 and bits 8 to 11.
inline constexpr field<count16, 0, 4> slot{};
inline constexpr field<count16, 8, 4> revision{};
inline constexpr input_reg<packed<slot, revision>> identity{.code = "ID", .address = 1};

struct device {
    static constexpr literal name{"I/O module"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<lamp, horn, guard, reset, supply, identity>;
};

using registers = bank<lamp, horn, guard, reset, supply, identity>;

} // namespace module

int main()
{
    constexpr station<altivar::atv320::device> drive{unit_id{7}};
    constexpr station<module::device> far_module{unit_id{4}};

    module::registers inside;
    inside.set<module::supply>(module::power_source::battery);
    inside.set<module::identity>({0x0305});
    sim::bench bench{bus<2>{line_timing{19'200, character_format::even_8_1}}, drive,
                     bank_at{far_module.unit(), inside}};

    // Functions 01, 02 and 04: one request for each kind.
    using inputs =
        read_plan<module::device, module::guard, module::reset, module::lamp, module::supply, module::identity>;
    static_assert(inputs::request_count == 3);
    poller<inputs> panel{far_module};
    auto status = read<altivar::atv320::eta>(drive);
    if (not bench.run(panel, status) or not panel.outcome() or not status.outcome()) {
        return 1;
    }
    auto const& now = panel.latest();
    auto const supply = now.get<module::supply>();
    auto const identity = now.get<module::identity>();
    std::cout << "guard " << now.get<module::guard>() << ", supply " << (supply ? name_of(*supply) : literal{"unknown"})
              << ", slot " << identity.get<module::slot>() << ", revision " << identity.get<module::revision>() << '\n';

    // The guard opens: both outputs are switched by one request, function 15.
    inside.set<module::guard>(true);
    auto guard = read<module::guard>(far_module);
    if (not bench.run(guard, status) or not guard.outcome()) {
        return 1;
    }
    auto tell = write_all<module::lamp, module::horn>(far_module, *guard.outcome(), true);
    bool const is_told = bench.run(tell, status) and tell.outcome();
    bool const is_lit = inside.get<module::lamp>() and inside.take_written<module::horn>();
    return is_told and is_lit and supply == module::power_source::battery ? 0 : 1;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 7: a server that looks before it writes, and acts after it. A check may refuse a value (exception 03) or say
// that the device cannot do it now (exception 04); then nothing is written. An action is called after the write. Builds
// on lessons 5 and 6.
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace pump {

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .min = 0, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};

struct device {
    static constexpr literal name{"pump"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<setpoint, actual>;
};

} // namespace pump

int main()
{
    // The pump: its registers, what the rest of the firmware knows, and what is done with a written value.
    bank<pump::setpoint, pump::actual> registers;
    bool is_dry = false;
    auto served = with_hooks(registers)
                      .check<pump::setpoint>([&](decihertz asked) {
                          if (asked > 0_Hz and asked < 10_Hz) {
                              return errc::illegal_data_value; // 03: too slow for this pump, at any time
                          }
                          return is_dry and asked > 0_Hz ? errc::server_device_failure : errc::none; // 04: not now
                      })
                      .on_write<pump::setpoint>([&](decihertz now) {
                          std::cout << "  the pump goes to " << now << '\n';
                          registers.set<pump::actual>(now);
                      });

    // Its client, at the other end of a simulated line. The bench serves `served`: `registers` alone has no hooks.
    constexpr station<pump::device> far_pump{unit_id{3}};
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{far_pump.unit(), served}};
    auto const order = [&](int tenths) {
        std::cout << "asked for " << tenths * 0.1_Hz << '\n';
        auto const done = bench.run(write<pump::setpoint>(far_pump, checked(tenths * 0.1_Hz)));
        std::cout << "  " << (done ? "done" : name(done.error())) << '\n';
        return done ? errc::none : done.error();
    };
    bool ok = order(475) == errc::none and registers.get<pump::actual>() == 47.5_Hz;
    ok = order(50) == errc::illegal_data_value and ok;
    is_dry = true;
    ok = order(300) == errc::server_device_failure and ok;
    ok = registers.get<pump::setpoint>() == 47.5_Hz and ok; // what was refused changed nothing
    return order(0) == errc::none and registers.get<pump::actual>() == 0_Hz and ok ? 0 : 1;
}

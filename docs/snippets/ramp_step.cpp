// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of registers shows of steps that another register sets: the ramp is 3 s whatever INR is.
#include <cstdint>
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::device> other{unit_id{7}};

using test_line = decltype(sim::bench{line_timing{19'200, character_format::even_8_1}, other});

//! [write]
template <typename Line> result<void> set_ramp(Line& line) // a blocking_client, or a bench
{
    constexpr auto ramp = 3_s;
    auto const step = line.run(read<atv320::inr>(other));
    if (not step) {
        return step.error();
    }
    switch (*step) {
    case atv320::ramp_step::hundredths: return line.run(write_with_step<centiseconds, atv320::acc>(other, ramp));
    case atv320::ramp_step::tenths: return line.run(write_with_step<deciseconds, atv320::acc>(other, ramp));
    case atv320::ramp_step::whole: return line.run(write_with_step<seconds, atv320::acc>(other, ramp));
    }
    return errc::value_without_meaning; // a drive that knows more steps than this library
}
//! [write]

/// What ACC counts after set_ramp where INR is `step`.
std::uint16_t count_at(test_line& line, atv320::ramp_step step)
{
    bool const is_set = line.run(write<atv320::inr>(other, checked(step))).has_value() and set_ramp(line).has_value();
    single_request ask{other.unit(), read_holding_registers{.start = atv320::acc.address, .count = 1}};
    auto const seen = line.run(ask);
    auto const response = seen ? seen->to<read_holding_registers>() : seen.error();
    return is_set and response ? response->registers[0] : std::uint16_t{0};
}

} // namespace

int main()
{
    test_line line{line_timing{19'200, character_format::even_8_1}, other};
    auto const delivered = line.run(read<atv320::inr>(other));
    bool const is_tenths = delivered and *delivered == atv320::ramp_step::tenths;
    bool const is_right = count_at(line, atv320::ramp_step::hundredths) == 300 and
                          count_at(line, atv320::ramp_step::tenths) == 30 and
                          count_at(line, atv320::ramp_step::whole) == 3;
    std::cout << (is_tenths and is_right ? "3 s by each step\n" : "the ramp is not 3 s\n");
    return is_tenths and is_right ? 0 : 1;
}

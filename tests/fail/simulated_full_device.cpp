// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulates a drive with all its parameters, of which only those for driving and setting up have a model.
// EXPECT: all parameters of a drive are not simulated: give the simulation a station<device>, and read and write by the station<full_device>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

#ifdef REFUSED
using simulated = altivar::atv320::full_device;
#else
using simulated = altivar::atv320::device;
#endif

constexpr station<altivar::atv320::full_device> drive{unit_id{7}};

int main()
{
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, station<simulated>{drive.unit()}};
    return bench.run(read<altivar::atv320::rfr>(drive)) ? 0 : 1;
}

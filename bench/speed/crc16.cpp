// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC's forms by size. Only their ratios in one run mean anything.
#include <array>

#include <benchmark/benchmark.h>

#include <rtuwire/core/crc16.hpp>

using namespace rtuwire;

namespace {

template <crc_form Form> void crc(benchmark::State& state)
{
    std::array<std::byte, 253> octets{};
    auto const size = static_cast<std::size_t>(state.range(0));
    for (auto _ : state) {
        // Each call depends on the one before, as a receiver's does.
        octets[0] = to_byte(crc16<Form>(byte_view{octets}.first(size)));
        benchmark::DoNotOptimize(octets);
    }
    state.SetBytesProcessed(state.iterations() * state.range(0));
}

BENCHMARK(crc<crc_form::bitwise>)->Arg(8)->Arg(253);
BENCHMARK(crc<crc_form::nibble_table>)->Arg(8)->Arg(253);
BENCHMARK(crc<crc_form::byte_table>)->Arg(8)->Arg(253);

} // namespace

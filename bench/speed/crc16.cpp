// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC's forms by size, against two tables. Throughput: calls that do not wait for each
// other.
#include <array>
#include <string>

#include <benchmark/benchmark.h>

#include "two_tables.hpp"

#include <rtuwire/core/crc16.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

using crc_function = std::uint16_t (*)(byte_view);

template <crc_form Form> [[gnu::noinline]] std::uint16_t crc_by(byte_view bytes) { return crc16<Form>(bytes); }

void throughput(benchmark::State& state, crc_function crc)
{
    auto const size = static_cast<std::size_t>(state.range(0));
    std::size_t start = 0;
    for (auto _ : state) {
        start = (start + 1) % 8;
        benchmark::DoNotOptimize(crc(byte_view{bench::bytes}.subspan(start, size)));
    }
    state.SetBytesProcessed(state.iterations() * state.range(0));
}

constexpr struct {
    char const* name;
    crc_function crc;
} forms[] = {
    {"two tables", bench::crc_by_two_tables},         {"bitwise", crc_by<crc_form::bitwise>},
    {"nibble table", crc_by<crc_form::nibble_table>}, {"byte table", crc_by<crc_form::byte_table>},
    {"host (default)", crc_by<crc_form::host>},
};

int add_all()
{
    for (std::size_t i = 0; i < bench::bytes.size(); ++i) {
        bench::bytes[i] = to_byte(static_cast<std::uint32_t>(i * 37));
    }
    for (auto const& form : forms) {
        for (int const size : {6, 8, 16, 64, 133, 253, 4'096}) {
            std::string const of = std::string{"/"} + form.name;
            benchmark::RegisterBenchmark(("crc latency" + of).c_str(), bench::latency, form.crc)->Arg(size);
            benchmark::RegisterBenchmark(("crc throughput" + of).c_str(), throughput, form.crc)->Arg(size);
        }
    }
    return 0;
}
int const added = add_all();

} // namespace

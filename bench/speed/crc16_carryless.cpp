// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The form that multiplies, compiled for a processor that can, against two tables.
#include <array>

#include <benchmark/benchmark.h>

#include "two_tables.hpp"

#include <rtuwire/core/crc16.hpp>

using namespace rtuwire;

namespace {

using bench::latency;

[[gnu::noinline]] std::uint16_t crc_by_multiplication(byte_view view) { return crc16<crc_form::carryless>(view); }

BENCHMARK_CAPTURE(latency, two tables, bench::crc_by_two_tables)
    ->Name("carryless latency/two tables")
    ->Arg(8)
    ->Arg(16)
    ->Arg(64)
    ->Arg(253)
    ->Arg(4'096);
BENCHMARK_CAPTURE(latency, carryless, crc_by_multiplication)
    ->Name("carryless latency/carry-less")
    ->Arg(8)
    ->Arg(16)
    ->Arg(64)
    ->Arg(253)
    ->Arg(4'096);

} // namespace

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the benchmarks with GCC and with Clang (-O3, as CMake has it for a release) and runs
# them, interleaved and repeated: for each compiler a table of medians and ratios, and speed.svg and speed.json in its
# build folder.
#
#   sh bench/run.sh [repetitions, at least 2]
set -eu
CDPATH='' cd "$(dirname "$0")/.."
repetitions=${1:-9}

sh tests/packages.sh build tests clang bench
for compiler in g++ clang++; do
    made=build/bench-$compiler
    cmake --preset bench -B "$made" -DCMAKE_CXX_COMPILER=$compiler
    cmake --build "$made"
    for program in "$made"/bench/bench_*; do
        [ -x "$program" ] || continue
        "$program" --benchmark_repetitions="$repetitions" --benchmark_min_time=0.02 \
            --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
            --benchmark_out_format=json --benchmark_out="$made/${program##*/}.json" >/dev/null
    done
    /usr/bin/python3 -B bench/speed/report.py "$made"
    "$made/bench/pseudo_terminal"
    "$made/bench/usb_adapter"
done

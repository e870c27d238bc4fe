#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the benchmarks and runs them, interleaved and repeated: a table of
# medians and ratios, build/bench/speed.svg and build/bench/speed.json.
#
#   sh bench/run.sh [repetitions, at least 2]
set -eu
cd "$(dirname "$0")/.."
repetitions=${1:-9}

sh tests/packages.sh build tests bench
cmake --preset bench
cmake --build --preset bench
for program in build/bench/bench/bench_*; do
    [ -x "$program" ] || continue
    "$program" --benchmark_repetitions="$repetitions" --benchmark_min_time=0.02 \
        --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
        --benchmark_out_format=json --benchmark_out="build/bench/${program##*/}.json" >/dev/null
done
python3 bench/speed/report.py build/bench
build/bench/bench/pseudo_terminal

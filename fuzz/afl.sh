#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Explores every fuzz target with AFL++, one after the other; fails where one crashes or hangs.
#
#   sh fuzz/afl.sh [seconds for each: 60]
set -eu
CDPATH='' cd "$(dirname "$0")/.."
seconds=${1:-60}
sh tests/packages.sh build tool clang afl
cmake --preset fuzz -B build/afl -DCMAKE_CXX_COMPILER=afl-clang-fast++
cmake --build build/afl

export AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1
seed=$(mktemp -d)
trap 'rm -rf "$seed"' EXIT
printf 'seed' >"$seed/seed"
for target in build/afl/fuzz/fuzz_*; do
    name=${target##*/fuzz_}
    inputs=$seed
    [ -d "fuzz/corpus/$name" ] && inputs=fuzz/corpus/$name
    out=build/afl/found/$name
    rm -rf "$out"
    mkdir -p "$out"
    if ! afl-fuzz -V "$seconds" -i "$inputs" -o "$out" -- "$target" >"$out.log" 2>&1; then
        tail -n 20 "$out.log"
        exit 1
    fi
    told() { sed -n "s/^$1 *: //p" "$out/default/fuzzer_stats"; }
    echo "$name: $(told execs_done) executions, $(told saved_crashes) crashes, $(told saved_hangs) hangs"
    [ "$(told saved_crashes)" = 0 ] && [ "$(told saved_hangs)" = 0 ] || exit 1
done

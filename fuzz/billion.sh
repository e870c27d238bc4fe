#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# A billion executions in all, the same number of each fuzz target, without sanitizers, two targets at a time. Then the
# sanitizers see every input that reached something new. Fails at a finding.
#
#   sh fuzz/billion.sh [executions in all: 1000000000]
set -eu
cd "$(dirname "$0")/.."
total=${1:-1000000000}
for preset in fuzz fuzz-fast; do
    cmake --preset "$preset" >/dev/null
    cmake --build --preset "$preset"
done
places=build/fuzz-fast/found
mkdir -p "$places"
set -- build/fuzz-fast/fuzz/fuzz_*
each=$((total / $# + 1))
explore() {
    name=${1##*/fuzz_}
    found=$2/$name
    mkdir -p "$found"
    "$1" "$found" "fuzz/corpus/$name" -runs="$3" -timeout=10 -verbosity=0 -print_final_stats=1 \
        -artifact_prefix="$found-" >"$found.log" 2>&1 &&
        "build/fuzz/fuzz/fuzz_$name" "$found" -runs=0 -timeout=10 -verbosity=0 \
            -artifact_prefix="$found-" >>"$found.log" 2>&1 || {
        cat "$found.log"
        echo "$name: a finding"
        return 1
    }
    told() { sed -n "s/^stat::$1: *//p" "$found.log"; }
    echo "$name: $(told number_of_executed_units) executions, $(told average_exec_per_sec) each second"
}
while [ $# -gt 0 ]; do
    running=
    for place in 1 2; do
        [ $# -gt 0 ] || break
        explore "$1" "$places" "$each" &
        running="$running $!"
        shift
    done
    for one in $running; do
        wait "$one"
    done
done

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# A billion executions of all fuzz targets, without sanitizers, two targets at a time: rounds in which each target has
# the same time, until there are as many. Then the sanitizers see every input that reached something new. Fails at a
# finding.
#
#   sh fuzz/billion.sh [executions in all: 1000000000] [seconds of a target in each round: 120]
set -eu
CDPATH='' cd "$(dirname "$0")/.."
total=${1:-1000000000}
seconds=${2:-120}
cmake --preset fuzz >/dev/null
cmake --preset fuzz -B build/fuzz-fast -DRTUWIRE_FUZZ_SANITIZERS=OFF >/dev/null
cmake --build build/fuzz
cmake --build build/fuzz-fast
places=$PWD/build/fuzz-fast/found
mkdir -p "$places"

# Runs what is given; its output is shown where it finds something.
watch() {
    log=$1
    shift
    "$@" -timeout=10 -verbosity=0 >"$log" 2>&1 || {
        cat "$log"
        echo "$log: a finding"
        return 1
    }
}

explore() {
    name=${1##*/fuzz_}
    mkdir -p "$places/$name"
    watch "$places/$name.log" "$1" "$places/$name" "fuzz/corpus/$name" -max_total_time="$seconds" -print_final_stats=1 \
        -artifact_prefix="$places/$name-" || return 1
    # Without the number, which nothing else tells, the rounds would have no end.
    grep '^stat::number_of_executed_units: ' "$places/$name.log" >>"$places/$name.executions"
}

check() {
    name=${1##*/fuzz_}
    watch "$places/$name.log" "$1" "$places/$name" -runs=0 -artifact_prefix="$places/$name-"
}

# "$1" for each of the other arguments, two at a time.
in_pairs() {
    what=$1
    shift
    while [ $# -gt 0 ]; do
        "$what" "$1" &
        first=$!
        if [ $# -gt 1 ]; then
            "$what" "$2" || {
                wait "$first"
                return 1
            }
            shift
        fi
        wait "$first" || return 1
        shift
    done
}

sum() { cat "$@" | awk '{ all += $2 } END { printf "%.0f", all }'; }

rm -f "$places"/*.executions
executed=0
while [ "$executed" -lt "$total" ]; do
    in_pairs explore build/fuzz-fast/fuzz/fuzz_*
    executed=$(sum "$places"/*.executions)
    echo "$(date +%T) $executed executions"
done
in_pairs check build/fuzz/fuzz/fuzz_*
for each in "$places"/*.executions; do
    name=${each##*/}
    echo "${name%.executions}: $(sum "$each") executions"
done

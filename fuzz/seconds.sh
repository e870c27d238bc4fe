#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Explores the named targets with libFuzzer and the sanitizers, all at once; fails where one finds something.
#
#   sh fuzz/seconds.sh SECONDS TARGET...
set -eu
CDPATH='' cd "$(dirname "$0")/.."
seconds=$1
shift
cmake --preset fuzz
for name in "$@"; do
    cmake --build build/fuzz --target "fuzz_$name"
done

explore() {
    found=build/fuzz/found/$1
    mkdir -p "$found"
    # New inputs go to the build tree: the first directory is the one libFuzzer writes to.
    inputs=
    [ ! -d "fuzz/corpus/$1" ] || inputs=fuzz/corpus/$1
    if "build/fuzz/fuzz/fuzz_$1" "$found" ${inputs:+"$inputs"} -max_total_time="$seconds" -timeout=10 -verbosity=0 \
        -print_final_stats=1 -artifact_prefix="build/fuzz/$1-" >"build/fuzz/$1.log" 2>&1; then
        echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$1.log") executions," \
            "$(sed -n 's/^stat::average_exec_per_sec: *//p' "build/fuzz/$1.log") each second"
    else
        cat "build/fuzz/$1.log"
        echo "$1: a finding"
        return 1
    fi
}
running=
for name in "$@"; do
    explore "$name" &
    running="$running $!"
done
for each in $running; do
    wait "$each"
done

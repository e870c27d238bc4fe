#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# How many headers one `line.ask(...)`, one `start` and one served request go through: those of the functions that are entered
# at -O0, core/ aside. A figure to watch, and no reason to join or to rename anything: sh bench/trips/count.sh [--list]
set -eu
CDPATH='' cd "$(dirname "$0")/../.."
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

g++ -std=c++20 -O0 -g -no-pie -finstrument-functions "-I$PWD/include" -o "$place/trips" bench/trips/trips.cpp
"$place/trips" >"$place/entered"
for act in ask start served; do
    sed -n "s/^$act //p" "$place/entered" | addr2line -e "$place/trips" |
        sed -n "s|^$PWD/include/rtuwire/\(.*\):.*|    \1|p" | grep -v '^ *core/' | sort -u >"$place/$act"
    echo "$act: $(wc -l <"$place/$act") headers"
    [ "${1:-}" != --list ] || cat "$place/$act"
done

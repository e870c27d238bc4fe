#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The library's tests, compiled with a directory in which every header is the single one: sh single_header_tests.sh [ROOM...].
# Without a room it is the whole tree, in which everything is built and every test runs.
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
place=$project/build/packaging/single
cd "$project"

/usr/bin/python3 -B packaging/single_header.py "$place/rtuwire.hpp" --shim "$place/shim"
cmake --preset gcc -B "$place/gcc" -DRTUWIRE_INCLUDE_DIR="$place/shim" >"$place/log" || {
    cat "$place/log"
    exit 1
}
if [ $# -eq 0 ]; then
    cmake --build "$place/gcc"
    # Left out: a refusal of a program that includes too little, where one header always brings everything.
    exec env RTUWIRE_LINES_OF_SHIM=1 ctest --test-dir "$place/gcc" --output-on-failure --no-tests=error \
        -LE "soak|nightly|weakened" -E "^fail: list_of_drives_without_registers$"
fi
programs=
for room in "$@"; do
    programs="$programs rtuwire_tests_$room"
done
# shellcheck disable=SC2086 # a list of names
cmake --build "$place/gcc" --target $programs
for program in $programs; do
    "$place/gcc/tests/$program"
done

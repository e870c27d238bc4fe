#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the tests of the library with GCC and runs them; the last line says how it went.
# .ci/run tests after it what counts for longer (`ctest --preset gcc-rest`) and what runs as a process of its own: the tool,
# the examples, emulated boards, others' programs (`ctest --preset gcc-processes`).
set -eu
CDPATH='' cd "$(dirname "$0")/.."
began=$(date +%s)
took() { echo "$(($(date +%s) - began)) s"; }
stop() {
    printf '\nNothing was tested, after %s: %s; see above.\n' "$(took)" "$1"
    exit 1
}

echo "== Packages =="
sh tests/packages.sh build tests || stop "packages are missing"

echo "== Building: [done/of all] =="
cmake --preset gcc || stop "CMake found a fault"
cmake --build --preset gcc-rooms || stop "something does not compile"

echo "== Tests =="
folder=build/gcc/Testing/Temporary
rm -f $folder/LastTest.log $folder/LastTestsFailed.log
status=0
ctest --preset gcc-rooms --parallel "$(getconf _NPROCESSORS_ONLN)" || status=$?
[ -e $folder/LastTest.log ] || stop "CTest has no tests"

# Each test that failed, and the line of the log that its output begins with.
[ -e $folder/LastTestsFailed.log ] || : >$folder/LastTestsFailed.log
awk -v took="$(took)" '
    FILENAME ~ /Failed/ { sub(/^[0-9]+:/, ""); failed[$0] = "its output is missing"; next }
    /^[0-9]+\/[0-9]+ Test: / {
        ++all
        sub(/^[^:]*: /, "")
        if ($0 in failed) { failed[$0] = FILENAME ":" FNR }
    }
    END {
        for (name in failed) { ++count; told = told (count > 1 ? ", " : "; failed: ") "\"" name "\" (" failed[name] ")" }
        printf "\n%d of %d tests passed in %s%s.\n", all - count, all, took, told
    }' $folder/LastTestsFailed.log $folder/LastTest.log
exit "$status"

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds one example and becomes it: sh examples/run.sh NAME [arguments]
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(dirname "$here")
build=$project/build/examples

if [ $# -eq 0 ] || [ ! -f "$here/$1.cpp" ]; then
    echo "usage: sh examples/run.sh NAME [arguments], where NAME is one of:" >&2
    for file in "$here"/*.cpp; do echo "    $(basename "$file" .cpp)" >&2; done
    exit 2
fi
name=$1
shift

# The output of the example stays alone on standard output; the steps before it speak when they fail.
quietly() {
    "$@" >"$build/log" 2>&1 </dev/null && return
    cat "$build/log" >&2
    exit 1
}
mkdir -p "$build"
quietly sh "$project/tests/packages.sh" examples
quietly cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DRTUWIRE_BUILD_EXAMPLES=ON \
    -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_INSTALL=OFF
quietly cmake --build "$build" --target "example_$name"
exec "$build/examples/example_$name" "$@"

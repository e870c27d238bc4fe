#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds one example and becomes it: sh examples/run.sh NAME [arguments]
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(dirname "$here")

if [ $# -eq 0 ] || [ ! -f "$here/$1.cpp" ]; then
    echo "usage: sh examples/run.sh NAME [arguments], where NAME is one of:" >&2
    for file in "$here"/*.cpp; do echo "    $(basename "$file" .cpp)" >&2; done
    exit 2
fi
name=$1
shift

build=$project/build/examples
program=$build/examples/example_$name
failed=1
. "$project/cmake/first_build.sh"

step "[1/3] installs what is missing of CMake, make and a compiler"
sh "$project/tests/packages.sh" examples >&2 </dev/null || exit "$failed"
step "[2/3] configures, in $build"
quietly cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DRTUWIRE_BUILD_EXAMPLES=ON \
    -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_INSTALL=OFF
step "[3/3] builds $name, one file and the library's headers: less than a minute"
telling cmake --build "$build" --target "example_$name"
exec "$program" "$@"

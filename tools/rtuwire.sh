#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the tool and becomes it: sh tools/rtuwire.sh COMMAND [arguments]
set -eu
project=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
build=$project/build/tool

# The tool's output stays alone on standard output; the steps before it speak when they fail.
quietly() {
    "$@" >"$build/log" 2>&1 </dev/null && return
    cat "$build/log" >&2
    exit 4
}
mkdir -p "$build"
[ -x "$build/tools/rtuwire/rtuwire" ] || echo "rtuwire.sh: builds the tool first, which takes some minutes" >&2
quietly sh "$project/tests/packages.sh" build tool
quietly cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRTUWIRE_BUILD_TOOL=ON \
    -DRTUWIRE_BUILD_EXAMPLES=OFF -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_INSTALL=OFF -DRTUWIRE_COMPILE_JOINED=ON
quietly cmake --build "$build" --target rtuwire_tool
exec "$build/tools/rtuwire/rtuwire" "$@"

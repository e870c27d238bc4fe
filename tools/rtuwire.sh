#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the tool and becomes it: sh tools/rtuwire.sh COMMAND [arguments]
set -eu
project=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
build=$project/build/tool
program=$build/tools/rtuwire/rtuwire
failed=4
. "$project/cmake/first_build.sh"

step "[1/3] installs what is missing of the tool's packages"
sh "$project/tests/packages.sh" build tool >&2 </dev/null || exit "$failed"
step "[2/3] configures, in $build"
quietly cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRTUWIRE_BUILD_TOOL=ON \
    -DRTUWIRE_BUILD_EXAMPLES=OFF -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_INSTALL=OFF -DRTUWIRE_COMPILE_JOINED=ON
step "[3/3] builds the tool, which takes some minutes"
telling cmake --build "$build" --target rtuwire_tool
exec "$program" "$@"

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds the tests of the library with GCC and runs them. What runs as a process of its own
# (the tool, the examples, emulated boards, others' programs) .ci/run tests after it: `cmake --build --preset gcc` and
# `ctest --preset gcc` have all.
set -eu
CDPATH='' cd "$(dirname "$0")/.."

sh tests/packages.sh build tests interop tool
cmake --preset gcc
cmake --build --preset gcc-rooms
ctest --preset gcc-rooms

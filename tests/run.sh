#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs what is missing, builds everything with GCC and runs every test.
set -eu
cd "$(dirname "$0")/.."

sh tests/packages.sh build tests interop tool arm emulator
cmake --preset gcc
cmake --build --preset gcc
ctest --preset gcc

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# `rtuwire serve` with what others wrote: drawn requests of libmodbus, pymodbus, and modbus-serial and jsmodbus of npm; a crowd of clients that
# are none; Prometheus and stunnel by the files of docs/serve.md. Installs what it needs.
#
#   sh tests/interop/serve_clients.sh [COUNT [SEED]]
set -eu
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh build interop tool npm proxies
packages=$PWD/build/npm
mkdir -p "$packages"
if [ ! -d "$packages/node_modules/modbus-serial" ] || [ ! -d "$packages/node_modules/jsmodbus" ]; then
    npm install --no-audit --no-fund --ignore-scripts --prefix "$packages" modbus-serial@8.0.25 jsmodbus@5.0.0
fi
. .ci/cache
cmake --preset release
cmake --build build/release --target rtuwire_tool memory_libmodbus asking_libmodbus

count=${1:-10000} seed=${2:-1} tool=build/release/tools/rtuwire/rtuwire failed=
printf '\n== clients of others ==\n'
NODE_PATH=$packages/node_modules /usr/bin/python3 -B tests/interop/serve_clients.py $tool build/release/tests/interop/memory_libmodbus \
    "$count" "$seed" -- build/release/tests/interop/asking_libmodbus @ -- /usr/bin/python3 -B tests/interop/asking_pymodbus.py @ \
    -- node tests/interop/asking_npm.js modbus-serial @ -- node tests/interop/asking_npm.js jsmodbus @ || failed="$failed; clients"
printf '\n== a crowd ==\n'
/usr/bin/python3 -B tests/tool/serving.py $tool crowd 1000 || failed="$failed; crowd"
printf '\n== motors ==\n'
/usr/bin/python3 -B tests/tool/serving.py $tool turns 2000 "$seed" || failed="$failed; motors"
printf '\n== Prometheus and stunnel ==\n'
/usr/bin/python3 -B tests/tool/serve_page.py $tool docs/serve.md packaging/systemd/rtuwire-serve@.service others || failed="$failed; page"
[ -z "$failed" ] || {
    echo "FAILED:$failed" >&2
    exit 1
}

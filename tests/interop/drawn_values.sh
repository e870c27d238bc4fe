#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Drawn values of every type, read and written by the tool on a line and over Modbus TCP, against the memory of four servers of others: libmodbus, pymodbus,
# and modbus-serial and jsmodbus of npm; ten times as many drawn command lines; and all servers and clients with one defect. Installs what it needs.
#
#   sh tests/interop/drawn_values.sh [COUNT [SEED]]
set -eu
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh build interop tool npm
packages=$PWD/build/npm
mkdir -p "$packages"
if [ ! -d "$packages/node_modules/modbus-serial" ] || [ ! -d "$packages/node_modules/jsmodbus" ]; then
    npm install --no-audit --no-fund --ignore-scripts --prefix "$packages" modbus-serial@8.0.25 jsmodbus@5.0.0
fi
. .ci/cache
cmake --preset release
cmake --build build/release --target rtuwire_tool memory_libmodbus

count=${1:-1000} seed=${2:-1} failed=
for server in "build/release/tests/interop/memory_libmodbus" "/usr/bin/python3 -B tests/interop/memory_pymodbus.py" \
    "node tests/interop/memory_npm.js modbus-serial" "node tests/interop/memory_npm.js jsmodbus"; do
    printf '\n== %s ==\n' "$server"
    # shellcheck disable=SC2086 # a list of words
    NODE_PATH=$packages/node_modules /usr/bin/python3 -B tests/tool/modbus_tcp.py \
        build/release/tools/rtuwire/rtuwire others $server || failed="$failed; $server, Modbus TCP"
    for form in "" mbap; do
        # shellcheck disable=SC2086 # lists of words
        NODE_PATH=$packages/node_modules /usr/bin/python3 -B tests/tool/drawn_values.py \
            build/release/tools/rtuwire/rtuwire "$count" "$seed" $form $server || failed="$failed; $server $form"
    done
done
printf '\n== command lines ==\n'
/usr/bin/python3 -B tests/tool/drawn_lines.py build/release/tools/rtuwire/rtuwire "${count}0" "$seed" || failed="$failed; command lines"
printf '\n== servers with one defect ==\n'
/usr/bin/python3 -B tests/tool/defective_servers.py build/release/tools/rtuwire/rtuwire || failed="$failed; servers with one defect"
printf '\n== clients with one defect, and those of npm ==\n'
for part in defects npm; do
    NODE_PATH=$packages/node_modules /usr/bin/python3 -B tests/tool/checked_clients.py build/release/tools/rtuwire/rtuwire $part ||
        failed="$failed; clients: $part"
done
[ -z "$failed" ] || {
    echo "FAILED:$failed" >&2
    exit 1
}

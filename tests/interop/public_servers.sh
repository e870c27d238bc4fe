#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# What `rtuwire check` says of public servers and clients: of libmodbus and pymodbus (Debian's packages), of modbus-serial and
# jsmodbus (npm), of nanoMODBUS and FreeMODBUS (their sources, see tests/sources_of_others.sh) and of this library. Prints the tables
# of docs/public-servers.md, in about seven minutes. Installs what it needs.
#
#   sh tests/interop/public_servers.sh [LIBRARY...]        such as `libmodbus freemodbus`; without a word all
#   sh tests/interop/public_servers.sh --clients           without the servers, in a minute
#   sh tests/interop/public_servers.sh --frames LIBRARY    what fails, with its frames
#   sh tests/interop/public_servers.sh --page docs/public-servers.md [LIBRARY...]   what that page says otherwise
#
# NODE_MODULES and SOURCES_OF_OTHERS name folders that have the packages and the sources already.
set -eu
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh build interop tool npm >&2
. .ci/cache
cmake --preset release >&2
cmake --build build/release --target rtuwire_tool memory_libmodbus public_rtuwire_server checked_libmodbus checked_ours >&2
place=build/public_servers
mkdir -p "$place"

# Whether one of the named libraries is asked for: all are, where none is named.
names=
for word in "$@"; do
    case $word in --* | */*) ;; *) names="$names $word" ;; esac
done
wants() {
    for name in "$@"; do
        case "${names:- $name} " in *" $name "*) return 0 ;; esac
    done
    return 1
}

packages=${NODE_MODULES:-$PWD/build/npm/node_modules}
if wants modbus_serial jsmodbus && { [ ! -d "$packages/modbus-serial" ] || [ ! -d "$packages/jsmodbus" ]; }; then
    mkdir -p build/npm
    npm install --no-audit --no-fund --ignore-scripts --prefix build/npm modbus-serial@8.0.25 jsmodbus@5.0.0 >&2
fi

# make_program NAME SOURCES' WORDS PROGRAM'S WORDS SOURCES: a program of C sources, and beside it their commit.
make_program() {
    objects=
    for source in $4; do
        object=$place/$1-$(basename "$source").o
        # shellcheck disable=SC2086 # a list of words
        cc -O1 -w $2 $3 -c "$source.c" -o "$object"
        objects="$objects $object"
    done
    # shellcheck disable=SC2086 # a list of words
    c++ -std=c++20 -O1 $3 "tests/interop/public_servers/$1.cpp" $objects -o "$place/$1"
    git -C "$(dirname "$source")" rev-parse HEAD >"$place/$1.commit"
}
if wants nanomodbus freemodbus; then
    sources=${SOURCES_OF_OTHERS:-$PWD/build/sources}
    sh tests/sources_of_others.sh "$sources" >&2
    make_program nanomodbus_server -DNMBS_CLIENT_DISABLED "-I$sources/nanoMODBUS" "$sources/nanoMODBUS/nanomodbus"
    make_program nanomodbus_client -DNMBS_SERVER_DISABLED "-I$sources/nanoMODBUS" "$sources/nanoMODBUS/nanomodbus"
    free=$sources/freemodbus/modbus parts=
    for part in mb rtu/mbrtu rtu/mbcrc functions/mbfunccoils functions/mbfuncdisc functions/mbfuncholding functions/mbfuncinput \
        functions/mbfuncother functions/mbutils; do
        parts="$parts $free/$part"
    done
    make_program freemodbus_server -DMB_ASCII_ENABLED=0 "-Ibench/size/peers -I$free/include -I$free/rtu" "$parts"
fi

/usr/bin/python3 -B tests/interop/public_servers.py build/release --node-modules "$packages" --sources "$place" "$@"

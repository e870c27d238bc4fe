#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Flash and RAM of a client and of a server of functions 03, 06, 16 and 23 on a Cortex-M0+ and M3, by this library and by nanoMODBUS
# and FreeMODBUS. Fetches the commits below into a temporary folder.
#
#   sh bench/size/peers.sh
#   sh bench/size/peers.sh --from FOLDER   of a folder that has them, as nanoMODBUS and freemodbus
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)

# checkout NAME URL COMMIT
checkout() {
    if [ -n "$from" ]; then
        [ "$(git -C "$from/$1" rev-parse HEAD)" = "$3" ] || { echo "peers.sh: $from/$1 is not at $3" >&2 && exit 2; }
    else
        git init -q "$place/$1"
        git -C "$place/$1" fetch -q --depth 1 "$2" "$3"
        git -C "$place/$1" checkout -q FETCH_HEAD
    fi
    echo "$1 $3"
}

from=
[ "${1:-}" != --from ] || from=$(CDPATH='' cd "$2" && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
checkout nanoMODBUS https://github.com/debevv/nanoMODBUS 035b8d596a954c2dd4bc40e3fa28a7cb2a8c0ec1
checkout freemodbus https://github.com/cwalter-at/freemodbus ec8674ce328fbe390b92a99a1683ebc731cb8ab7
/usr/bin/python3 -B "$here/peers.py" "${from:-$place}"

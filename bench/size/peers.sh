#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Flash and RAM of a client and of a server of functions 03, 06, 16 and 23 on a Cortex-M0+ and M3, by this library and by nanoMODBUS
# and FreeMODBUS. Fetches their sources (tests/sources_of_others.sh) into a temporary folder.
#
#   sh bench/size/peers.sh
#   sh bench/size/peers.sh --from FOLDER   of a folder that has them, as nanoMODBUS and freemodbus
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)

if [ "${1:-}" = --from ]; then
    place=$2
else
    place=$(mktemp -d)
    trap 'rm -rf "$place"' EXIT
fi
sh "$here/../../tests/sources_of_others.sh" "$place"
/usr/bin/python3 -B "$here/peers.py" "$place"

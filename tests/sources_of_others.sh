#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Brings public sources that benches and tests are built with, at the commits below, into a folder, as nanoMODBUS and freemodbus;
# says which. What is there already has to be at that commit.
#
#   sh tests/sources_of_others.sh FOLDER
set -eu
mkdir -p "$1"

# checkout NAME URL COMMIT
checkout() {
    if [ ! -e "$1" ]; then
        git init -q "$1.part"
        git -C "$1.part" fetch -q --depth 1 "$2" "$3"
        git -C "$1.part" checkout -q FETCH_HEAD
        mv "$1.part" "$1"
    fi
    [ "$(git -C "$1" rev-parse HEAD)" = "$3" ] || { echo "sources_of_others.sh: $PWD/$1 is not at $3" >&2 && exit 2; }
    echo "$1 $3"
}

CDPATH='' cd "$1"
checkout nanoMODBUS https://github.com/debevv/nanoMODBUS 035b8d596a954c2dd4bc40e3fa28a7cb2a8c0ec1
checkout freemodbus https://github.com/cwalter-at/freemodbus ec8674ce328fbe390b92a99a1683ebc731cb8ab7

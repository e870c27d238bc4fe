#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Runs a program of Windows in Wine: sh wine.sh PROGRAM WORD... Its Windows is WINEPREFIX, made when it is first used; without
# one in build/wine. No window is opened.
set -eu
project=$(CDPATH='' cd "$(dirname "$0")/../.." && pwd)
export WINEPREFIX="${WINEPREFIX:-$project/build/wine}" WINEDEBUG="${WINEDEBUG:--all}" WINEDLLOVERRIDES="mscoree,mshtml="
unset DISPLAY
mkdir -p "$WINEPREFIX"
# Debian's `wine` is a script that looks for 32 bits first.
wine=/usr/lib/wine/wine64
[ -x "$wine" ] || wine=$(command -v wine64 || command -v wine)
[ -f "$WINEPREFIX/system.reg" ] || flock "$WINEPREFIX" "$wine" wineboot --init >/dev/null 2>&1
exec "$wine" "$@"

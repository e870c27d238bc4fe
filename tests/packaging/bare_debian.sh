#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# A Debian 12 with apt and little else, as an archive, unless it is there: sh bare_debian.sh ARCHIVE
set -eu
[ -f "$1" ] || {
    mmdebstrap --quiet --format=tar --variant=minbase bookworm "$1.part"
    mv "$1.part" "$1"
}

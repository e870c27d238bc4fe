#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# newcomer.py in a folder of its own, which is gone afterwards: sh tests/docs/newcomer.sh
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
sh "$project/tests/packages.sh" newcomer
place=$(mktemp -d)
trap 'rm -rf --one-file-system "$place"' EXIT
/usr/bin/python3 -B "$here/newcomer.py" "$project" "$place"

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The main job: a client drives a simulated drive, or with --port a real one.
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
mkdir -p "$here/../build/examples"
svg=$(cd "$here/../build/examples" && pwd)/demo.svg
exec sh "$here/run.sh" demo --svg "$svg" "$@"

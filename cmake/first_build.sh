# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Read by examples/run.sh and tools/rtuwire.sh, which have set `program`, `build` and `failed`, the status of a build that
# fails. Standard output is the program's alone: what is done before it is told on standard error, each step the first
# time, later what is compiled again.
mkdir -p "$build"
[ -x "$program" ] && is_first=false || is_first=true

step() {
    if $is_first; then echo "${0##*/}: $*" >&2; fi
}

# Runs what speaks when it fails.
quietly() {
    "$@" >"$build/log" 2>&1 </dev/null && return
    cat "$build/log" >&2
    exit "$failed"
}

# Runs a build: what it compiles and links is told as it does.
telling() {
    rm -f "$build/is_built"
    { "$@" 2>&1 </dev/null && : >"$build/is_built"; } | tee "$build/log" |
        grep --line-buffered -E '^\[ *[0-9]+(%|/[0-9]+)\] (Building|Linking)' >&2 || :
    [ -e "$build/is_built" ] && return
    cat "$build/log" >&2
    exit "$failed"
}

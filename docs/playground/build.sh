#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the playground, a page that needs no server: index.html, with everything in it. Installs what it needs.
#
#   sh docs/playground/build.sh OUTPUT_DIRECTORY
set -eu
[ $# -eq 1 ] || {
    echo "usage: sh docs/playground/build.sh OUTPUT_DIRECTORY" >&2
    exit 2
}
mkdir -p "$1"
output=$(CDPATH='' cd "$1" && pwd)
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh playground

objects=build/playground/objects
rm -rf "$objects"
mkdir -p "$objects"
target="--target=wasm32-wasi -flto -fno-exceptions"
compile="clang++-19 $target -Oz -std=c++20 -fno-rtti -fno-threadsafe-statics -fno-c++-static-destructors -mbulk-memory
    -Wall -Wextra -Werror -Iinclude -Itools/rtuwire"

# The module, and what explains frames in the command line tool. The slowest comes first.
for source in docs/playground/module/drives.cpp docs/playground/module/[!d]*.cpp tools/rtuwire/catalog/catalog.cpp \
    tools/rtuwire/catalog/value_text.cpp tools/rtuwire/words/words.cpp \
    tools/rtuwire/frame/damage.cpp tools/rtuwire/frame/decode.cpp tools/rtuwire/frame/frame_fields.cpp \
    tools/rtuwire/frame/frame_fit.cpp tools/rtuwire/frame/frame_layouts.cpp tools/rtuwire/frame/frame_split.cpp tools/rtuwire/frame/function_text.cpp \
    tools/rtuwire/frame/hex_text.cpp tools/rtuwire/frame/register_names.cpp tools/rtuwire/frame/request_layout.cpp tools/rtuwire/frame/response_layout.cpp \
    tools/rtuwire/frame/shared_layout.cpp tools/rtuwire/frame/summary.cpp; do
    echo "-c $source -o $objects/$(basename "$source" .cpp).o"
done | xargs -P "$(nproc)" -L 1 $compile

# What would need a system is not linked: the module imports nothing. Without -Oz here: by it clang would hand the module to
# wasm-opt wherever that is installed, which makes it a fifth larger with gzip. The largest object comes last: 1 KB less; the
# others against the alphabet: 0.1 KB.
# shellcheck disable=SC2046,SC2086 # lists of words
clang++-19 $target -mexec-model=reactor -Wl,--gc-sections,--strip-all,--compress-relocations,-O2,-z,stack-size=262144 \
    -Wl,-mllvm,-enable-merge-functions $(ls -r "$objects"/*.o | grep -v /drives) "$objects/drives.o" -o "$objects/playground.wasm"

# A page from a file may fetch nothing and import nothing: style, module and scripts go into it.
page=docs/playground/page
{
    printf 'const moduleText = "'
    base64 -w 0 "$objects/playground.wasm"
    printf '";\n'
} >"$objects/module.txt"
cat "$page/elements.js" "$page/module.js" "$page/machine.js" "$page/curves.js" "$page/line.js" "$page/scene.js" \
    "$page/announcer.js" "$page/main.js" >"$objects/scripts.txt"
awk -v style="$page/style.css" -v module="$objects/module.txt" -v scripts="$objects/scripts.txt" '
    function insert(mark, file,    at, line) {
        at = index($0, mark)
        printf "%s", substr($0, 1, at - 1)
        while ((getline line < file) > 0) print line
        print substr($0, at + length(mark))
    }
    index($0, "/*STYLE*/") { insert("/*STYLE*/", style); next }
    index($0, "/*MODULE*/") { insert("/*MODULE*/", module); next }
    index($0, "/*SCRIPTS*/") { insert("/*SCRIPTS*/", scripts); next }
    { print }' "$page/page.html" >"$objects/index.html"
mv "$objects/index.html" "$output/index.html"

echo "$output/index.html: the module has $(wc -c <"$objects/playground.wasm") bytes," \
    "$(gzip -9 -c "$objects/playground.wasm" | wc -c) with gzip"

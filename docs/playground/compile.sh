# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# shellcheck shell=sh disable=SC2034,SC2046,SC2086,SC2154,SC2164 # for those that source it, with set -e; lists of words
# For a script that builds a page with a module in it and sources this file: sh docs/APP/build.sh OUTPUT_DIRECTORY. It goes on
# in the project's folder, with what it needs installed; $objects is a folder of its own.
[ $# -eq 1 ] || {
    echo "usage: sh $0 OUTPUT_DIRECTORY" >&2
    exit 2
}
mkdir -p "$1"
output=$(CDPATH='' cd "$1" && pwd)
CDPATH='' cd "$(dirname "$0")"
app=$(basename "$PWD")
cd ../..

sh tests/packages.sh playground

objects=build/$app/objects
module=$objects/$app.wasm
rm -rf "$objects"
mkdir -p "$objects"

target="--target=wasm32-wasi -flto -fno-exceptions"
compile="clang++-19 $target -Oz -std=c++20 -fno-rtti -fno-threadsafe-statics -fno-c++-static-destructors -mbulk-memory
    -Wall -Wextra -Werror -Iinclude -Itools/rtuwire"

# What explains frames in the command line tool.
frame_sources=$(printf 'tools/rtuwire/%s.cpp ' catalog/catalog catalog/value_text words/option_words words/words frame/damage frame/decode frame/frame_fields \
    frame/frame_fit frame/frame_layouts frame/frame_split frame/function_text frame/hex_text frame/register_names frame/request_layout \
    frame/response_layout frame/shared_layout frame/summary)

# The slowest come first.
compile_all() {
    for source in "$@"; do
        echo "-c $source -o $objects/$(basename "$source" .cpp).o"
    done | xargs -P "$(nproc)" -L 1 $compile
}

# What would need a system is not linked: the module imports nothing. Without -Oz here: by it clang would hand the module to
# wasm-opt wherever that is installed, which makes it a fifth larger with gzip. The largest object comes last, which makes it
# a few hundred bytes smaller.
link_module() {
    clang++-19 $target -mexec-model=reactor -Wl,--gc-sections,--strip-all,--compress-relocations,-O2,-z,stack-size=262144 \
        -Wl,-mllvm,-enable-merge-functions $(LC_ALL=C ls -rS "$objects"/*.o) -o "$module"
}

# A page from a file may fetch nothing and import nothing: style, module and scripts go into it, where it has their marks.
# join_page PAGE, with style.css, module.txt and scripts.txt in $objects: index.html in the output.
join_page() {
    awk -v style="$objects/style.css" -v module="$objects/module.txt" -v scripts="$objects/scripts.txt" '
        function insert(mark, file,    at, line) {
            at = index($0, mark)
            printf "%s", substr($0, 1, at - 1)
            while ((getline line < file) > 0) print line
            print substr($0, at + length(mark))
        }
        index($0, "/*STYLE*/") { insert("/*STYLE*/", style); next }
        index($0, "/*MODULE*/") { insert("/*MODULE*/", module); next }
        index($0, "/*SCRIPTS*/") { insert("/*SCRIPTS*/", scripts); next }
        { print }' "$1" >"$objects/index.html"
    mv "$objects/index.html" "$output/index.html"
    echo "$output/index.html: the module has $(wc -c <"$module") bytes, $(gzip -9 <"$module" | wc -c) with gzip"
}

# The module as a constant of JavaScript.
write_module_text() {
    printf 'const moduleText = "'
    base64 -w 0 "$module"
    printf '";\n'
}

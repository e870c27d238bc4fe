# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# shellcheck shell=sh disable=SC2034,SC2154,SC2086 # for those that source it; lists of words
# For the scripts that build a page with a module in it, which source this file: $objects is a folder of their own.

target="--target=wasm32-wasi -flto -fno-exceptions"
compile="clang++-19 $target -Oz -std=c++20 -fno-rtti -fno-threadsafe-statics -fno-c++-static-destructors -mbulk-memory
    -Wall -Wextra -Werror -Iinclude -Itools/rtuwire"

# What explains frames in the command line tool.
frame_sources=$(printf 'tools/rtuwire/%s.cpp ' catalog/catalog catalog/value_text words/words frame/damage frame/decode frame/frame_fields \
    frame/frame_fit frame/frame_layouts frame/frame_split frame/function_text frame/hex_text frame/register_names frame/request_layout \
    frame/response_layout frame/shared_layout frame/summary)

# The slowest come first.
compile_all() {
    for source in "$@"; do
        echo "-c $source -o $objects/$(basename "$source" .cpp).o"
    done | xargs -P "$(nproc)" -L 1 $compile
}

# What would need a system is not linked: the module imports nothing. Without -Oz here: by it clang would hand the module to
# wasm-opt wherever that is installed, which makes it a fifth larger with gzip.
link_module() {
    module=$1
    shift
    clang++-19 $target -mexec-model=reactor -Wl,--gc-sections,--strip-all,--compress-relocations,-O2,-z,stack-size=262144 \
        -Wl,-mllvm,-enable-merge-functions "$@" -o "$module"
}

# A page from a file may fetch nothing and import nothing: style, module and scripts go into it, where it has their marks.
# join_page PAGE, with style.css, module.txt and scripts.txt in $objects: $objects/index.html.
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
}

# The module as a constant of JavaScript.
write_module_text() {
    printf 'const moduleText = "'
    base64 -w 0 "$1"
    printf '";\n'
}

tell_size() {
    echo "$1: the module has $(wc -c <"$2") bytes, $(gzip -9 -c "$2" | wc -c) with gzip"
}

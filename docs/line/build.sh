#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the page that speaks to an adapter, which needs no server: index.html, with everything in it. Installs what it needs.
#
#   sh docs/line/build.sh OUTPUT_DIRECTORY
set -eu
# shellcheck source=docs/playground/compile.sh
. "$(dirname "$0")/../playground/compile.sh"

tool=tools/rtuwire
shared=docs/playground/module
# shellcheck disable=SC2086 # a list of words
compile_all $tool/catalog/all_catalogs.cpp docs/line/module/*.cpp $shared/explained.cpp $shared/frame_log.cpp $shared/json.cpp \
    $shared/wasm_support.cpp $tool/backup/saved_values.cpp $tool/catalog/drive_family.cpp $tool/catalog/named_values.cpp \
    $tool/catalog/rows_atv28.cpp $tool/words/amount_words.cpp $frame_sources
link_module

page=docs/line/page
shared=docs/playground/page
# The worker is a text of the page: a page from a file can load no other.
{
    write_module_text
    /usr/bin/python3 -B docs/line/rows.py
} >"$objects/module.txt"
cat "$page/module.js" "$page/ports.js" "$page/worker.js" | /usr/bin/python3 -c '
import json, sys
print("const workerText =", json.dumps(sys.stdin.read()) + ";")' >>"$objects/module.txt"
cat "$shared/style.css" "$page/style.css" >"$objects/style.css"
cat "$shared/elements.js" "$shared/module.js" "$shared/fields.js" "$page/module.js" "$page/ports.js" "$page/register_file.js" \
    "$page/main.js" >"$objects/scripts.txt"
join_page "$page/page.html"

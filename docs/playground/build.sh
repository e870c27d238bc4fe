#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the playground, a page that needs no server: index.html, with everything in it. Installs what it needs.
#
#   sh docs/playground/build.sh OUTPUT_DIRECTORY
set -eu
# shellcheck source=docs/playground/compile.sh
. "$(dirname "$0")/../playground/compile.sh"

# shellcheck disable=SC2086 # a list of words
compile_all docs/playground/module/drives.cpp docs/playground/module/[!d]*.cpp $frame_sources
link_module

page=docs/playground/page
write_module_text >"$objects/module.txt"
cp "$page/style.css" "$objects/style.css"
cat "$page/elements.js" "$page/module.js" "$page/machine.js" "$page/curves.js" "$page/fields.js" "$page/line.js" "$page/scene.js" \
    "$page/announcer.js" "$page/states.js" "$page/main.js" >"$objects/scripts.txt"
join_page "$page/page.html"

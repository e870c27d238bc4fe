#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the page that speaks to an adapter and tests it: the module in node, the page in Chromium, from a file, over pseudo-terminals
# and on lines that are not as they should be. Installs what it needs. By night longer, and its speed beside another client for Web
# Serial.
#
#   sh tests/line_page/run.sh [night]
set -eu
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh playground browser build tool interop
tools=build/playground/npm
mkdir -p "$tools"
if [ ! -d "$tools/node_modules/modbus-webserial" ] || [ ! -d "$tools/node_modules/axe-core" ]; then
    npm install --no-audit --no-fund --prefix "$tools" playwright-core@1.65.1 axe-core@4.14.1 modbus-webserial@0.10.1
fi

sh docs/line/build.sh build/line/site
node tests/line_page/module_test.js build/line/objects/line.wasm
NODE_PATH="$tools/node_modules" node tests/line_page/strange_line_test.js build/line/site/index.html

# The tool of another build where there is one: its own takes minutes.
tool=build/gcc/tools/rtuwire/rtuwire
[ -x "$tool" ] || {
    sh tools/rtuwire.sh --version
    tool=build/tool/tools/rtuwire/rtuwire
}
server=build/line/libmodbus_server
# shellcheck disable=SC2046 # a list of words
g++ -O1 -std=c++20 $(pkg-config --cflags libmodbus) tests/interop/libmodbus_server.cpp -o "$server" $(pkg-config --libs libmodbus)
NODE_PATH="$tools/node_modules" node tests/line_page/page_test.js build/line/site/index.html build/playground/shots "$tool" "$server" "$@"

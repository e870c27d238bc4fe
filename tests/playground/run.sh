#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the playground and tests it: the module in node, the page in Chromium, from a file. Installs what it needs.
#
#   sh tests/playground/run.sh
set -eu
CDPATH='' cd "$(dirname "$0")/../.."

sh tests/packages.sh playground browser
tools=build/playground/npm
mkdir -p "$tools"
if [ ! -d "$tools/node_modules/playwright-core" ] || [ ! -d "$tools/node_modules/axe-core" ]; then
    # The versions that the tests were written with: a newer axe may know more rules.
    npm install --no-audit --no-fund --prefix "$tools" playwright-core@1.65.1 axe-core@4.14.1
fi

sh docs/playground/build.sh build/playground/site
node tests/playground/module_test.js build/playground/objects/playground.wasm
NODE_PATH="$tools/node_modules" node tests/playground/page_test.js build/playground/site/index.html build/playground/shots

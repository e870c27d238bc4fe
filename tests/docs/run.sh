#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the documentation with all it needs and follows its links; with `browser` looks at it in Chromium, too. Screens
# are kept in build/docs/screens.
#
#   sh tests/docs/run.sh [browser]
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
build=$project/build/docs

(cd "$here" && /usr/bin/python3 -B -m unittest test_generate)
/usr/bin/python3 -B "$project/docs/generate/snippets.py" "$project"
/usr/bin/python3 -B "$here/page_links.py" "$project"
sh "$project/docs/build.sh"
[ "${1:-}" = browser ] || exit 0

sh "$project/tests/packages.sh" browser
mkdir -p "$build/browser"
cp "$here/browser.mjs" "$build/browser/"
# Chromium is Debian's: the package brings none.
(cd "$build/browser" && PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm install --no-audit --no-fund --no-save --silent playwright-core@1 axe-core@4.14.1)
(cd "$build/browser" && node browser.mjs "$build/html" "$build/screens")

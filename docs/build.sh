#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Builds the documentation, with all it needs: sh docs/build.sh [OUTPUT]. Without OUTPUT it is build/docs/html/index.html.
# SITE_ADDRESS is the address that the site will have, if that is known: who is shown a link to it finds its picture by that.
# A warning, a broken link, a refusal that a compiler does not make, an error without a remedy: each ends it.
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(dirname "$here")
build=$project/build/docs
output=${1:-$build/html}

began=$(date +%s)
sh "$project/tests/packages.sh" docs
/usr/bin/python3 -B "$here/generate/stage.py" "$project" "$build" /usr/share/doxygen-awesome-css
doxygen "$build/Doxyfile"
for app in playground line; do
    if [ -f "$here/$app/build.sh" ]; then
        sh "$here/$app/build.sh" "$build/html/$app"
    fi
done
/usr/bin/python3 -B "$here/generate/reference.py" "$build/html" "$build/tags.xml"
/usr/bin/python3 -B "$here/generate/search.py" "$build/html" "$build/tags.xml"
/usr/bin/python3 -B "$here/generate/first.py" "$project" "$build/html"
/usr/bin/python3 -B "$here/generate/links.py" "$build/html"
if [ "$output" != "$build/html" ]; then
    mkdir -p "$output"
    cp -R "$build/html/." "$output/"
fi
echo "documentation: $output/index.html, in $(($(date +%s) - began)) s"

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Every form of the library that is given out: made, and used as its users would. docs/packaging.md says which check is which.
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
place=$project/build/packaging
cd "$project"
exec </dev/null

began=$(date +%s)
last=$began
heading() {
    now=$(date +%s)
    printf '(%u s)\n\n-- %s\n' $((now - last)) "$*"
    last=$now
}

heading "Packages"
sh tests/packages.sh build tests tool gateway clang portability packaging
mkdir -p "$place"

heading "The version stands in one place"
(cd "$here" && /usr/bin/python3 -B -m unittest -v test_versions)
/usr/bin/python3 -B "$here/versions.py"

heading "A release"
# The documentation has tests of its own, and so has what downloads.sh makes.
RTUWIRE_RELEASE_WITHOUT="docs download" sh packaging/release.sh "$place/release"

heading "The same again, of a clone elsewhere: the same bytes"
again=$place/again
rm -rf "$again"
mkdir "$again"
git clone -q --no-hardlinks "$project" "$again/clone"
(umask 077 && RTUWIRE_RELEASE_WITHOUT="debian download docs" sh "$again/clone/packaging/release.sh" "$again/release")
for release in "$place/release" "$again/release"; do
    (cd "$release" && sha256sum --quiet --check SHA256SUMS)
done
# The archive, the single header and six manifests.
[ "$(wc -l <"$again/release/SHA256SUMS")" -ge 8 ]
if grep -vxFf "$place/release/SHA256SUMS" "$again/release/SHA256SUMS"; then
    echo "differs"
    exit 1
fi
rm -rf "$again"

export RTUWIRE_RELEASE="$place/release"
for test in release older_cmake consumers manifests single_header; do
    heading "$test"
    (cd "$here" && /usr/bin/python3 -B -m unittest -v "test_$test")
done

heading "The tests of the library with the single header"
sh "$here/single_header_tests.sh" core wire table cia402

heading "Debian"
sh "$here/installed.sh" "$place/release" "$place"

heading "All forms passed"
echo "in $(((now - began) / 60)) min $(((now - began) % 60)) s"

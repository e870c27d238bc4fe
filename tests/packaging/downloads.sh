#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# What a person takes without a compiler: made twice, of clones in different folders, compared, and used as such a person would.
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
place=$project/build/packaging/downloads
cd "$project"
exec </dev/null

sh tests/packages.sh build tool packaging download wine
rm -rf "$place"
mkdir -p "$place"
for folder in near farther/away; do
    git clone -q --no-hardlinks "$project" "$place/$folder"
    RTUWIRE_RELEASE_WITHOUT="debian docs" sh "$place/$folder/packaging/release.sh"
    (cd "$place/$folder/build/release" && sha256sum --quiet --check SHA256SUMS)
    export CCACHE_DISABLE=1 # what was compiled for the first is no proof for the second
done
diff "$place/near/build/release/SHA256SUMS" "$place/farther/away/build/release/SHA256SUMS"
export RTUWIRE_RELEASE="$place/near/build/release" RTUWIRE_BARE_DEBIAN="$place/../root.tar"
sh "$here/bare_debian.sh" "$RTUWIRE_BARE_DEBIAN"
cd "$here"
/usr/bin/python3 -B -m unittest -v test_downloads

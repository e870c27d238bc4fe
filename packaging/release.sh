#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Makes a release of the commit that is checked out: sh packaging/release.sh [OUTPUT]. OUTPUT is build/release unless given:
# the archive, the single header, the module's interface, the manifests laid out for each registry, Debian's packages, the
# tool for each system (packaging/download/make.sh), the documentation, checksums. The version stands in
# include/rtuwire/core/version.hpp. The same commit and the same packages of Debian give the same bytes.
#
# RTUWIRE_URL is the address of the folder that the archive will be downloaded from; vcpkg, Conan and Meson get to know it.
# RTUWIRE_HOME is that of the project, without .git; the manifests name it as homepage and repository.
# SITE_ADDRESS is the one that the documentation will have, where that is not RTUWIRE_HOME.
# RTUWIRE_RELEASE_WITHOUT leaves out parts (debian download docs), for a look at the others.
set -eu
project=$(CDPATH='' cd "$(dirname "$0")/.." && pwd)
output=$(realpath -m -- "${1:-$project/build/release}")
url=${RTUWIRE_URL:-https://rtuwire.invalid/releases}
home=${RTUWIRE_HOME:-https://rtuwire.invalid/rtuwire}
export SITE_ADDRESS="${SITE_ADDRESS:-${RTUWIRE_HOME:-}}"
without=" ${RTUWIRE_RELEASE_WITHOUT:-} "
export LC_ALL=C TZ=UTC
cd "$project"

fail() {
    echo "release.sh: $*" >&2
    exit 1
}

# A folder that this script made holds what its checksums name, and nothing else.
is_release() {
    grep -q '  rtuwire\.hpp$' "$1/SHA256SUMS" 2>/dev/null || return 1
    [ "$(ls -A "$1" | grep -vx SHA256SUMS)" = "$(sed 's/^[^ ]*  //' "$1/SHA256SUMS")" ]
}

if [ "$(git rev-parse --show-prefix 2>&1)" ]; then
    fail "a release is made of a commit, and 'git status' in $project finds no repository of its own"
fi
if ! git diff --quiet HEAD --; then
    fail "there are changes that no commit has; a release is made of a commit"
fi
if [ -e "$output" ] && ! is_release "$output"; then
    fail "$output is there and is no release, or holds more than one; name another folder"
fi
number=$(sed -n 's/^#define RTUWIRE_VERSION \([0-9][0-9]*\)$/\1/p' include/rtuwire/core/version.hpp)
[ -n "$number" ] || fail "include/rtuwire/core/version.hpp defines no RTUWIRE_VERSION"
version=$((number / 10000)).$((number / 100 % 100)).$((number % 100))
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
umask 022
is_made() { [ "${without#* "$1" }" = "$without" ]; }
# shellcheck disable=SC2046 # nothing, or a word
sh tests/packages.sh build tool gateway packaging $(is_made download && echo download)

# Nothing half-made stands under the name of the release: it is put there whole, at the end.
mkdir -p "$(dirname "$output")"
place=$(mktemp -d "$output.XXXXXX")
trap 'rm -rf "$place"' EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM
made=$place/made
work=$place/work
mkdir "$made" "$work"
name=rtuwire-$version

step() {
    echo "release $version: $*"
}

# The output of a step is shown where it fails.
quietly() {
    "$@" >"$work/log" 2>&1 </dev/null && return
    cat "$work/log" >&2
    fail "'$*' failed"
}

# A folder as an archive that differs only where its files do.
pack() {
    tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=a+rX,u+w,go-w \
        --format=ustar -C "$1" -cf - "$2" | gzip -9n
}

step "archive"
git -c core.autocrlf=false -c core.eol=lf -c tar.umask=0022 archive --format=tar --prefix="$name/" HEAD | gzip -9n >"$made/$name.tar.gz"
tar -xzf "$made/$name.tar.gz" -C "$work"

step "single header, and the interface of the module"
/usr/bin/python3 -B "$work/$name/packaging/single_header.py" "$made/rtuwire.hpp"
/usr/bin/python3 -B "$work/$name/packaging/module_interface.py" "$made/rtuwire.cppm"

step "manifests"
/usr/bin/python3 -B "$work/$name/packaging/lay_out.py" "$work/$name" "$made/$name.tar.gz" "$made" \
    --url "$url" --home "$home" --epoch "$SOURCE_DATE_EPOCH"

# Before what takes long: it is what may refuse.
if is_made docs; then
    step "documentation"
    mkdir "$work/docs" "$work/source"
    tar -xzf "$made/$name.tar.gz" -C "$work/source"
    quietly sh "$work/source/$name/docs/build.sh" "$work/docs/$name-docs"
    pack "$work/docs" "$name-docs" >"$made/$name-docs.tar.gz"
fi

if is_made debian; then
    step "Debian packages"
    cp "$made/$name.tar.gz" "$work/rtuwire_$version.orig.tar.gz"
    cp -R "$work/$name/packaging/debian" "$work/$name/debian"
    # No symbols for a debugger: they would double what is built and kept.
    (
        cd "$work/$name"
        export DEB_BUILD_OPTIONS="noautodbgsym ${DEB_BUILD_OPTIONS:-parallel=$(nproc)}" DEB_CXXFLAGS_STRIP=-g
        quietly dpkg-buildpackage --unsigned-source --unsigned-changes
    )
    for file in "$work"/*.deb "$work"/*.dsc "$work"/*.debian.tar.xz "$work"/*.orig.tar.gz; do
        cp "$file" "$made/"
    done
fi

if is_made download; then
    . "$work/$name/packaging/download/make.sh"
fi

(
    cd "$made"
    sha256sum -- * >"$work/sums"
    mv "$work/sums" SHA256SUMS
)
# Between these two no signal ends it: the folder of work, which goes at the end, has the old release.
trap '' HUP INT TERM
[ ! -e "$output" ] || mv "$output" "$place/before"
mv "$made" "$output"
step "$output"

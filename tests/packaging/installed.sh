#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Debian's packages in a Debian of their own: sh installed.sh RELEASE PLACE. Lintian looks at them; the tool is installed and
# reads a simulated drive; purging it leaves nothing; then the packages' own tests run, as debian/tests/control lists them.
set -eu
release=$(CDPATH='' cd "$1" && pwd)
mkdir -p "$2"
place=$(CDPATH='' cd "$2" && pwd)
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)
root=$place/root

echo "lintian"
# Its complaints of each degree end this, and overrides that nothing needs.
(cd "$release" && lintian --fail-on error,warning,info,override --display-info --suppress-tags-from-file \
    "$here/lintian_left_out.txt" ./rtuwire_*.dsc ./*.deb)

echo "a root with apt and little else"
sh "$here/bare_debian.sh" "$place/root.tar"
rm -rf "$root"
mkdir "$root"
tar -xf "$place/root.tar" -C "$root"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$release"/*.deb "$here/installed_inside.sh" "$root/packages/"
cp -R "$project/packaging/debian/tests" "$root/packages/tests"

# The mounts end with the program.
unshare --mount --propagation private sh -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C \
        chroot "$1" sh -eu /packages/installed_inside.sh' sh "$root"
rm -rf "$root"

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# What tests/packaging/installed.sh runs inside of the other Debian, beside the packages in /packages.
set -eu
cd /packages

fail() {
    echo "installed_inside.sh: $*" >&2
    exit 1
}

apt() {
    apt-get -q -y -o APT::Install-Recommends=0 -o DPkg::Lock::Timeout=60 "$@" >/packages/apt.log 2>&1 </dev/null && return
    cat /packages/apt.log >&2
    fail "apt-get $* failed"
}

# Of ours, outside of what apt, dpkg and man write of their own acts.
ours() {
    find / -xdev \( -path /packages -o -path /proc -o -path /dev -o -path /var/log -o -path /var/cache/man \) -prune \
        -o -iname '*rtuwire*' -print
}

apt update
[ -z "$(ours)" ] || fail "the root is not clean: $(ours)"

echo "apt install ./rtuwire*.deb"
apt install ./rtuwire_*.deb
rtuwire --port sim:atv320:1 read RFR >said
cat said
grep -q '^.*RFR' said || fail "the tool says nothing of RFR"
rtuwire --version
files=$(dpkg -L rtuwire)

echo "apt purge rtuwire"
apt purge rtuwire
for file in $files; do
    [ -d "$file" ] || [ ! -e "$file" ] || fail "purging leaves $file"
done
[ -z "$(ours)" ] || fail "purging leaves $(ours)"
! dpkg-query -W rtuwire >/dev/null 2>&1 || fail "dpkg still knows rtuwire"

echo "apt install ./rtuwire-gateway*.deb"
apt install ./rtuwire_*.deb ./rtuwire-gateway_*.deb
rtuwire-gateway --check | grep -q meter1 || fail "the file that comes with the gateway is wrong"
[ -f /lib/systemd/system/rtuwire-gateway.service ] || fail "no unit"
getent passwd rtuwire >/dev/null || fail "no user for the service"
# What was typed into its file outlives an upgrade, and a removal; not a purge.
sed -i 's/^site = .*/site = "typed"/' /etc/rtuwire/gateway.toml
apt install --reinstall ./rtuwire-gateway_*.deb
grep -q '"typed"' /etc/rtuwire/gateway.toml || fail "an upgrade takes the file"
apt remove rtuwire-gateway
grep -q '"typed"' /etc/rtuwire/gateway.toml || fail "a removal takes the file"
echo "apt purge rtuwire-gateway rtuwire"
apt purge rtuwire-gateway rtuwire
[ -z "$(ours)" ] || fail "purging leaves $(ours)"

# The tests of the packages: a paragraph a test.
run_test() {
    echo "test $1"
    # shellcheck disable=SC2086 # a list of names
    apt install $2
    if ! sh -eu "tests/$1" >out 2>err; then
        cat out err
        fail "the test $1 failed"
    fi
    case $3 in
        *allow-stderr*) ;;
        *) [ ! -s err ] || fail "the test $1 says on the error stream: $(cat err)" ;;
    esac
    tail -1 out
}
apt install ./rtuwire_*.deb ./rtuwire-gateway_*.deb ./librtuwire-dev_*.deb
tests=$(sed -n 's/^Tests: *//p' tests/control)
[ -n "$tests" ] || fail "debian/tests/control lists no test"
for test in $tests; do
    paragraph=$(awk -v RS= -v name="$test" '$1 == "Tests:" && $2 == name' tests/control)
    needs=$(echo "$paragraph" | sed -n 's/^Depends: *//p' | tr -d ,)
    run_test "$test" "$needs" "$(echo "$paragraph" | sed -n 's/^Restrictions: *//p')"
done

echo "apt purge librtuwire-dev rtuwire-gateway rtuwire"
apt purge librtuwire-dev rtuwire-gateway rtuwire
[ -z "$(ours)" ] || fail "purging leaves $(ours)"
echo "nothing is left"

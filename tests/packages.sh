#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs the Debian packages that the named groups need, and only those that are missing.
#
#   sh tests/packages.sh build tests arm
set -eu

packages_of() {
    case $1 in
        examples) echo cmake make c++ ;;
        build) echo cmake ninja-build g++ ;;
        tests) echo catch2 libfmt-dev python3 binutils ;;
        models) echo spin ;;
        interop) echo pkg-config libmodbus-dev mbpoll python3 python3-pymodbus python3-serial python3-serial-asyncio socat tshark ;;
        tool) echo pkg-config libcli11-dev libfmt-dev nlohmann-json3-dev libtomlplusplus-dev libyaml-cpp-dev tmux python3 python3-pyte zsh ;;
        gateway) echo pkg-config libmosquitto-dev mosquitto mosquitto-clients openssl python3-jinja2 ;;
        arm) echo gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib ;;
        emulator) echo qemu-system-arm ;;
        clang) echo clang libclang-rt-dev ;;
        afl) echo afl++ pkg-config libmodbus-dev ;;
        bench) echo pkg-config libbenchmark-dev libmodbus-dev valgrind strace ;;
        portability) echo gcc-riscv64-unknown-elf gcc-xtensa-lx106 g++-s390x-linux-gnu qemu-user-static clang-19 libc++-19-dev libc++abi-19-dev ;;
        avr) echo clang-19 gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib ;;
        packaging) echo git cmake ninja-build g++ pkg-config python3 python3-yaml meson debhelper dpkg-dev lintian mmdebstrap ;;
        download) echo apt dpkg-dev g++-aarch64-linux-gnu qemu-user-static iproute2 g++-mingw-w64-x86-64-posix zip ;;
        wine) echo wine64 ;;
        style) echo clang-format clang-tidy ;;
        docs) echo doxygen doxygen-awesome-css graphviz g++ clang python3 ;;
        playground) echo python3 clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 ;;
        browser) echo chromium nodejs npm ;;
        npm) echo nodejs npm ;;
        proxies) echo prometheus stunnel4 openssl ;;
        newcomer) echo debootstrap ;;
        mingw) echo g++-mingw-w64-x86-64-posix ;;
        wine) echo wine wine64 ;;
        cache) echo ccache ;;
        *)
            echo "packages.sh: no group '$1'; the groups are examples build tests models interop tool gateway arm emulator clang afl bench portability avr packaging download style docs playground browser npm proxies newcomer mingw wine cache" >&2
            return 1
            ;;
    esac
}

# A tool counts however it came here; a library only counts as the package the build will look for.
present() {
    case $1 in
        cmake | make | c++ | g++ | clang | mbpoll | socat | tshark | pkg-config | qemu-system-arm | valgrind | strace | tmux | zsh | clang-format | clang-tidy | spin | git | doxygen | chromium | openssl | npm | debootstrap | ccache)
            command -v "$1" >/dev/null ;;
        ninja-build) command -v ninja >/dev/null ;;
        graphviz) command -v dot >/dev/null ;;
        nodejs) command -v node >/dev/null ;;
        # Only the distribution's interpreter sees the distribution's modules.
        python3) [ -x /usr/bin/python3 ] ;;
        *) [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ] ;;
    esac
}

missing=
for group in "$@"; do
    names=$(packages_of "$group")
    for name in $names; do
        present "$name" && continue
        [ "$name" = c++ ] && name=g++
        missing="$missing $name"
    done
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
    echo "packages.sh: please install these (Debian's names) and run again:$missing" >&2
    exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null; then
    as_root=sudo
else
    echo "packages.sh: run as root, or with sudo installed, to install:$missing" >&2
    exit 1
fi

apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -y -o DPkg::Lock::Timeout=600 "$@" </dev/null
}
echo "Installing, which takes as long as the network does:$missing"
# The lists at hand may be good enough where the mirror cannot be reached.
apt update || echo "packages.sh: the package lists could not be refreshed" >&2
# shellcheck disable=SC2086 # a list of names
apt install --no-install-recommends $missing

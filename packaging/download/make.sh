# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Read by packaging/release.sh, whose names and functions it uses: the tool for people without a compiler, an archive for each
# system, in which it is linked with all that it needs. What is linked stands in each archive with its licence, and the
# sources of glibc lie beside them, as the LGPL wants. The same packages of Debian give the same bytes.
downloads=$work/downloads
apt=$work/apt
arm64=$work/arm64 # what Debian's packages of that machine hold
export CCACHE_BASEDIR="$work" # what was compiled of the same text in another clone counts
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")

# apt for another machine, or for sources: beside the system's own, from the same places.
apt_for() {
    machine=$1
    shift
    apt-get -q -o Dir::State::lists="$apt/$machine/lists" -o Dir::Cache="$apt/$machine" -o Dir::State::status=/dev/null \
        -o Dir::Etc::sourcelist="$apt/$machine/sources.list" -o Dir::Etc::sourceparts=/dev/null -o APT::Sandbox::User=root \
        -o Acquire::Languages=none -o APT::Architecture="$machine" -o APT::Architectures::="$machine" "$@"
}

# apt_lists MACHINE TYPE
apt_lists() {
    mkdir -p "$apt/$1/lists/partial" "$apt/$1/archives/partial"
    apt-get indextargets --format "$2 \$(SITE) \$(RELEASE) \$(COMPONENT)" "Created-By: Packages" | grep " $suite" |
        sort -u >"$apt/$1/sources.list"
    [ -s "$apt/$1/sources.list" ] || {
        echo "apt knows no packages of $suite here: apt-get update"
        return 1
    }
    apt_for "$1" update
}

version_of() {
    # shellcheck disable=SC2016 # dpkg's own
    dpkg-query -W -f "\${$2}" "$1"
}

# download KIND MACHINE PACKAGES [OPTION OF CMAKE...]: builds it for a machine with linux or windows, and packs it with the
# licences of PACKAGES, which are linked.
download() {
    kind=$1 folder=$name-$1-$2 linked=$3
    tree=$work/build-$1-$2 laid=$downloads/$folder
    step "tool for $1-$2"
    shift 3
    case $kind in
        linux) target=rtuwire_tool_texts hardened="-fstack-protector-strong -D_FORTIFY_SOURCE=2" ;;
        windows) target=rtuwire_tool hardened= ;; # what prints a manual page would be Wine
    esac
    quietly cmake -S "$work/$name" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" \
        "-DCMAKE_CXX_FLAGS=-ffile-prefix-map=$work=. $hardened" -DRTUWIRE_STATIC_TOOL=ON -DRTUWIRE_COMPILE_JOINED=ON \
        -DRTUWIRE_BUILD_TOOL=ON -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_BUILD_EXAMPLES=OFF -DRTUWIRE_WARNINGS_ARE_ERRORS=OFF "$@"
    quietly cmake --build "$tree" --target "$target"
    quietly cmake --install "$tree" --strip --component rtuwire_tool --prefix "$laid"
    mkdir "$laid/licences"
    cp "$work/$name/LICENSE" "$laid/LICENSE"
    cp /usr/share/common-licenses/GPL-3 "$laid/licences/"
    [ "$kind" = windows ] || cp /usr/share/common-licenses/LGPL-2.1 "$laid/licences/"
    : >"$work/linked"
    for package in $linked; do
        cp "/usr/share/doc/$package/copyright" "$laid/licences/$package.txt"
        printf '    %-52s %s\n' "licences/$package.txt" "$(version_of "$package" Version)" >>"$work/linked"
    done
    sed -e "s/^@$kind //" -e '/^@[a-z]/d' -e "s/@VERSION@/$version/g" -e "s/@SYSTEM@/$kind-${folder##*-}/g" -e "/@LINKED@/{
        r $work/linked
        d
    }" "$work/$name/packaging/download/README.txt" >"$laid/README.txt"
    case $kind in
        linux) pack "$downloads" "$folder" >"$made/$folder.tar.gz" ;;
        windows)
            find "$laid" -type d -empty -delete
            find "$laid" -exec touch -hd "@$SOURCE_DATE_EPOCH" {} +
            (cd "$downloads" && find "$folder" | sort | zip -q -X -@ "$made/$folder.zip")
            ;;
    esac
}

headers="libcli11-dev nlohmann-json3-dev libtomlplusplus-dev"
download linux x86_64 "libc6-dev libstdc++-12-dev libyaml-cpp-dev $headers"

step "libraries of arm64, sources of glibc"
quietly apt_lists arm64 deb
(cd "$apt/arm64/archives" && quietly apt_for arm64 download \
    "libc6-dev=$(version_of libc6-dev Version)" "libyaml-cpp-dev=$(version_of libyaml-cpp-dev Version)")
for package in "$apt"/arm64/archives/*.deb; do
    dpkg-deb -x "$package" "$arm64"
done
download linux arm64 "libc6-dev libstdc++-12-dev-arm64-cross libyaml-cpp-dev $headers" \
    --toolchain "$work/$name/cmake/aarch64-linux-gnu.cmake" "-DRTUWIRE_ARM64_ROOT=$arm64"
download windows x86_64 "mingw-w64-common gcc-mingw-w64-x86-64-posix-runtime $headers" \
    --toolchain "$work/$name/cmake/x86_64-w64-mingw32.cmake"

quietly apt_lists amd64 deb-src
(cd "$made" && quietly apt_for amd64 source --download-only "glibc=$(version_of libc6-dev source:Version)")

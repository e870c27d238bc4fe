# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The port: the headers, and what find_package and pkg-config read. There is nothing to link, so one build is enough.
set(VCPKG_BUILD_TYPE release)

vcpkg_download_distfile(archive
    URLS "@URL@/rtuwire-@VERSION@.tar.gz"
    FILENAME "rtuwire-@VERSION@.tar.gz"
    SHA512 @SHA512@)
vcpkg_extract_source_archive(source ARCHIVE "${archive}")

vcpkg_cmake_configure(SOURCE_PATH "${source}"
    OPTIONS -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_BUILD_EXAMPLES=OFF -DRTUWIRE_BUILD_TOOL=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/rtuwire)
vcpkg_fixup_pkgconfig()

# Its place for a licence is another.
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")

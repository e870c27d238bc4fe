# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs the headers and the package that find_package(rtuwire) reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Headers serve every architecture, so the package lives under share/ and does not ask for one.
set(rtuwire_package_dir "${CMAKE_INSTALL_DATADIR}/cmake/rtuwire")
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/rtuwire-config-version.cmake"
    COMPATIBILITY SameMinorVersion
    ARCH_INDEPENDENT)

install(TARGETS rtuwire EXPORT rtuwire FILE_SET HEADERS)
install(EXPORT rtuwire
    NAMESPACE rtuwire::
    FILE rtuwire-config.cmake
    DESTINATION "${rtuwire_package_dir}")
install(FILES "${PROJECT_BINARY_DIR}/rtuwire-config-version.cmake"
    DESTINATION "${rtuwire_package_dir}")

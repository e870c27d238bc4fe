# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Installs the headers, their licence, and what find_package(rtuwire) and pkg-config read: the component
# `rtuwire_development`. The tool is a component of its own, see cmake/install_tool.cmake.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Headers serve every architecture, so the package lives under share/ and does not ask for one.
set(rtuwire_package_dir "${CMAKE_INSTALL_DATADIR}/cmake/rtuwire")
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/rtuwire-config-version.cmake"
    COMPATIBILITY SameMinorVersion
    ARCH_INDEPENDENT)

if(CMAKE_VERSION VERSION_LESS 3.23)
    install(TARGETS rtuwire EXPORT rtuwire INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    install(DIRECTORY "${RTUWIRE_INCLUDE_DIR}/rtuwire" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        COMPONENT rtuwire_development
        FILES_MATCHING PATTERN "*.hpp")
else()
    install(TARGETS rtuwire EXPORT rtuwire
        FILE_SET HEADERS COMPONENT rtuwire_development
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
endif()

# The interface of the module is made where somebody asks for the target `rtuwire_module`, and installed where it was made.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND)
    add_custom_target(rtuwire_module COMMAND "${Python3_EXECUTABLE}" -B
        "${PROJECT_SOURCE_DIR}/packaging/module_interface.py" "${PROJECT_BINARY_DIR}/rtuwire.cppm" VERBATIM)
    install(FILES "${PROJECT_BINARY_DIR}/rtuwire.cppm" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/rtuwire"
        COMPONENT rtuwire_development OPTIONAL)
endif()

install(EXPORT rtuwire
    NAMESPACE rtuwire::
    FILE rtuwire-config.cmake
    DESTINATION "${rtuwire_package_dir}" COMPONENT rtuwire_development)
install(FILES "${PROJECT_BINARY_DIR}/rtuwire-config-version.cmake"
    DESTINATION "${rtuwire_package_dir}" COMPONENT rtuwire_development)

set(rtuwire_pc_includedir "${CMAKE_INSTALL_INCLUDEDIR}")
if(NOT IS_ABSOLUTE "${rtuwire_pc_includedir}")
    set(rtuwire_pc_includedir "\${prefix}/${rtuwire_pc_includedir}")
endif()
file(RELATIVE_PATH rtuwire_pc_to_prefix "${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" rtuwire_pc_to_prefix "${rtuwire_pc_to_prefix}")
configure_file("${PROJECT_SOURCE_DIR}/packaging/pkg-config/rtuwire.pc.in" "${PROJECT_BINARY_DIR}/rtuwire.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/rtuwire.pc"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/pkgconfig" COMPONENT rtuwire_development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT rtuwire_development)

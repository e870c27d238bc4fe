# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The functions of vcpkg that the port calls, as vcpkg documents them, for `cmake -P`: they really unpack, configure and
# install, below CURRENT_PACKAGES_DIR. A call with words that they do not know ends the run.
function(vcpkg_download_distfile out)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILENAME;SHA512" "URLS")
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "vcpkg_download_distfile: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    file(SHA512 "${DOWNLOADS}/${arg_FILENAME}" sum)
    if(NOT sum STREQUAL arg_SHA512)
        message(FATAL_ERROR "${arg_FILENAME} has the sum ${sum}, not ${arg_SHA512}")
    endif()
    if(NOT arg_URLS MATCHES "^https://.*/${arg_FILENAME}$")
        message(FATAL_ERROR "${arg_URLS} is no address of ${arg_FILENAME}")
    endif()
    set(${out} "${DOWNLOADS}/${arg_FILENAME}" PARENT_SCOPE)
endfunction()

function(vcpkg_extract_source_archive out)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "ARCHIVE" "")
    file(ARCHIVE_EXTRACT INPUT "${arg_ARCHIVE}" DESTINATION "${WORK}/src")
    file(GLOB only LIST_DIRECTORIES TRUE "${WORK}/src/*")
    set(${out} "${only}" PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${arg_SOURCE_PATH}" -B "${WORK}/build" -G Ninja
        "-DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}" ${arg_OPTIONS} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(vcpkg_cmake_install)
    execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" --target install COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Moves what find_package reads to share/PORT.
function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "CONFIG_PATH" "")
    if(NOT EXISTS "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/${PORT}-config.cmake")
        message(FATAL_ERROR "${arg_CONFIG_PATH} has no ${PORT}-config.cmake")
    endif()
    file(GLOB moved "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/*")
    foreach(file IN LISTS moved)
        get_filename_component(name "${file}" NAME)
        file(READ "${file}" text)
        # A level less from the file to the prefix.
        string(REPLACE "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)\n" "" text "${text}")
        string(REPLACE "get_filename_component(_IMPORT_PREFIX \"\${_IMPORT_PREFIX}\" PATH)\nget_filename_component(_IMPORT_PREFIX"
            "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)\nget_filename_component(_IMPORT_PREFIX" text "${text}")
        file(WRITE "${CURRENT_PACKAGES_DIR}/share/${PORT}/${name}" "${text}")
        file(REMOVE "${file}")
    endforeach()
    file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/cmake")
endfunction()

function(vcpkg_fixup_pkgconfig)
    if(NOT EXISTS "${CURRENT_PACKAGES_DIR}/share/pkgconfig/rtuwire.pc")
        message(FATAL_ERROR "there is no rtuwire.pc")
    endif()
endfunction()

function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
    file(INSTALL ${arg_FILE_LIST} DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}" RENAME copyright)
endfunction()

include("${PORTFILE}")

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Most of a test's time to compile goes for what it includes: joined, the tests of a room take a tenth. Where they are not
# (.ci/nightly alone-libcxx), each shows that it includes what it uses.

# Puts what is compiled for `sources` in VARIABLE: files that include them, and those that can't be joined; the sources
# themselves without RTUWIRE_COMPILE_JOINED.
function(join_sources variable room)
    if(NOT RTUWIRE_COMPILE_JOINED)
        set(${variable} ${ARGN} PARENT_SCOPE)
        return()
    endif()
    set(join "${RTUWIRE_PYTHON}" -B "${PROJECT_SOURCE_DIR}/tests/support/join.py")
    execute_process(COMMAND ${join} --groups ${ARGN} OUTPUT_VARIABLE groups OUTPUT_STRIP_TRAILING_WHITESPACE
        COMMAND_ERROR_IS_FATAL ANY)
    # A group to each place of the list: between them stands "\n", within them ";".
    string(REPLACE ";" "|" groups "${groups}")
    string(REPLACE "\n" ";" groups "${groups}")
    set(compiled)
    foreach(group IN LISTS groups)
        string(REPLACE "|" ";" some "${group}")
        list(LENGTH some count)
        if(count EQUAL 1)
            list(APPEND compiled ${some})
            continue()
        endif()
        list(LENGTH compiled number)
        set(file "${CMAKE_CURRENT_BINARY_DIR}/joined/${room}_${number}.cpp")
        file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/joined")
        add_custom_command(OUTPUT "${file}" COMMAND ${join} "${file}" ${some}
            DEPENDS ${some} "${PROJECT_SOURCE_DIR}/tests/support/join.py" VERBATIM)
        list(APPEND compiled "${file}")
    endforeach()
    set(${variable} ${compiled} PARENT_SCOPE)
endfunction()

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Most of a test's time to compile goes for what it includes: joined, the tests of a room take a tenth. Where they are not
# (preset clang-alone), each shows that it includes what it uses.

# Puts files that include `sources` in their place in VARIABLE, so many at a time that two processors share a room.
function(join_sources variable room)
    set(sources ${ARGN})
    execute_process(COMMAND "${RTUWIRE_PYTHON}" -B "${PROJECT_SOURCE_DIR}/tests/support/join.py" --alone ${sources}
        OUTPUT_VARIABLE alone RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "join.py: which of the tests of ${room} can't be joined?")
    endif()
    set(together ${sources})
    if(alone)
        list(REMOVE_ITEM together ${alone})
    endif()
    set(most 14)
    file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/joined")
    set(number 0)
    list(LENGTH together count)
    while(count GREATER 0)
        list(SUBLIST together 0 ${most} some)
        set(file "${CMAKE_CURRENT_BINARY_DIR}/joined/${room}_${number}.cpp")
        add_custom_command(OUTPUT "${file}"
            COMMAND "${RTUWIRE_PYTHON}" -B "${PROJECT_SOURCE_DIR}/tests/support/join.py" "${file}" ${some}
            DEPENDS ${some} "${PROJECT_SOURCE_DIR}/tests/support/join.py" VERBATIM)
        list(APPEND alone "${file}")
        math(EXPR number "${number} + 1")
        if(count GREATER most)
            list(SUBLIST together ${most} -1 together)
        else()
            set(together)
        endif()
        list(LENGTH together count)
    endwhile()
    set(${variable} ${alone} PARENT_SCOPE)
endfunction()

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Most of a test's time to compile goes for what it includes: joined, the tests of a room take a tenth. Where they are not
# (preset clang-alone), each shows that it includes what it uses.

# Puts files that include `sources` in their place in VARIABLE, so many at a time that two processors share a room.
function(join_sources variable room)
    set(sources ${ARGN})
    set(alone)
    set(together)
    foreach(source IN LISTS sources)
        file(STRINGS "${source}" obstacles REGEX "^(# *define|# *if.*include|# *if defined|extern|namespace [a-z]|template <>|void rtuwire::)" LIMIT_COUNT 1)
        if(obstacles)
            list(APPEND alone "${source}")
        else()
            list(APPEND together "${source}")
        endif()
    endforeach()
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

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The warnings our own programs are built with; users of the library never inherit them.
add_library(rtuwire_warnings INTERFACE)
set(rtuwire_warning_flags
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum)
# For packages, which later compilers build again.
option(RTUWIRE_WARNINGS_ARE_ERRORS "Refuse what the compiler warns of" ON)
if(RTUWIRE_WARNINGS_ARE_ERRORS)
    list(APPEND rtuwire_warning_flags -Werror)
endif()
target_compile_options(rtuwire_warnings INTERFACE
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:${rtuwire_warning_flags}>")

# What users may have switched on besides: the headers on their own are clean under these, too. A cast is useless on one
# machine and needed on another, so that one is asked of 64 bits only.
add_library(rtuwire_header_warnings INTERFACE)
target_compile_options(rtuwire_header_warnings INTERFACE
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Weffc++;-Wold-style-cast>"
    "$<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wcomma>")
if(CMAKE_SIZEOF_VOID_P EQUAL 8)
    target_compile_options(rtuwire_header_warnings INTERFACE "$<$<CXX_COMPILER_ID:GNU>:-Wuseless-cast>")
endif()

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The warnings our own programs are built with; users of the library never inherit them.
add_library(rtuwire_warnings INTERFACE)
set(rtuwire_warning_flags
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum -Werror)
target_compile_options(rtuwire_warnings INTERFACE
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:${rtuwire_warning_flags}>")

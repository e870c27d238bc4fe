# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Linux on arm64, emulated where a program is to run. RTUWIRE_ARM64_ROOT has the system's static libraries as Debian's packages
# of that machine lay them; without it those that come with the compiler count, which lack its corrections.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
if(RTUWIRE_ARM64_ROOT)
    set(CMAKE_EXE_LINKER_FLAGS_INIT "-static-pie -B${RTUWIRE_ARM64_ROOT}/usr/lib/aarch64-linux-gnu")
endif()

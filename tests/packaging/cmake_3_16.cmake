# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# What a project finds after its project() in CMake 3.16, as far as it asks: that version, and no variables of later ones.
set(CMAKE_VERSION 3.16.9)
unset(PROJECT_IS_TOP_LEVEL)
unset(rtuwire_IS_TOP_LEVEL)

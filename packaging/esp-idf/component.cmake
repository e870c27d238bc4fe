# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# The component of ESP-IDF: the headers, and C++20 for whatever includes them. In a release this is the CMakeLists.txt of the
# component; in the project its CMakeLists.txt includes this file where ESP-IDF reads it.
idf_component_register(INCLUDE_DIRS "include")
target_compile_features(${COMPONENT_LIB} INTERFACE cxx_std_20)

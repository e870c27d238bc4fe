// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The version of rtuwire, the language that it needs, and how it is built. Everything is in an inline namespace
// that names the version and the switches that change code, so that two files of one program that were built
// differently (say, one with -DRTUWIRE_CHECKED=0) do not share a function by mistake. User code leaves it out:
// `rtuwire::client`. Every header includes this one before its own first declaration.
#pragma once

// The flag to add, in the words of the tool that runs the compiler.
#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#if __cplusplus > 201703L
#error "rtuwire needs C++20, of which this compiler has only a part: GCC 12, Clang 14 or later"
#elif defined(PLATFORMIO)
#error "rtuwire needs C++20. platformio.ini: build_unflags = -std=gnu++11 -std=gnu++17, build_flags = -std=gnu++20"
#elif defined(ARDUINO)
#error "rtuwire needs C++20. platform.local.txt beside the board's platform.txt: compiler.cpp.extra_flags=-std=gnu++20"
#elif defined(ESP_PLATFORM)
#error "rtuwire needs C++20. CMakeLists.txt: target_compile_options(${COMPONENT_LIB} PRIVATE -std=gnu++20)"
#else
#error "rtuwire needs C++20. GCC and Clang: -std=c++20; CMake: target_compile_features(<target> PRIVATE cxx_std_20)"
#endif
// There is no such file: a compiler that misses one stops, and does not tell of thousands of errors behind ours.
#include <rtuwire_needs_cpp20>
#endif

/// The version for the preprocessor: major * 10000 + minor * 100 + patch.
#define RTUWIRE_VERSION 900

// Whether there is an operating system, as on a host: 1 or 0.
#if defined(__unix__) || defined(__APPLE__) || defined(_WIN32)
#define RTUWIRE_HAS_SYSTEM 1
#else
#define RTUWIRE_HAS_SYSTEM 0
#endif

/// Whether reading the value of a result that has none, or a register that a view does not have, is caught at
/// run time: 1 or 0. By default on where there is an operating system, off on bare metal; NDEBUG does not
/// matter.
#ifndef RTUWIRE_CHECKED
#define RTUWIRE_CHECKED RTUWIRE_HAS_SYSTEM
#endif

/// The form of the CRC in the whole program; `crc_form` tells what each form needs.
#ifndef RTUWIRE_CRC_FORM
#define RTUWIRE_CRC_FORM_IS_DEFAULT
#if defined(__SIZEOF_POINTER__) && __SIZEOF_POINTER__ < 8
#define RTUWIRE_CRC_FORM nibble_table
#else
#define RTUWIRE_CRC_FORM host
#endif
#endif

// Behind the parameters of a consteval constructor: a condition under which its body refuses, and what it says then. Clang 14
// calls one that initialises a variable outside of functions at run time, and refuses nothing: there this does.
#if defined(__clang__) && __clang_major__ < 15
#define RTUWIRE_REFUSES(sentence, ...)                                                                                 \
    _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Wgcc-compat\"")                              \
        __attribute__((diagnose_if((__VA_ARGS__), #sentence, "error"))) _Pragma("clang diagnostic pop")
#else
#define RTUWIRE_REFUSES(sentence, ...)
#endif

#define RTUWIRE_JOIN_NAMES(version, checked, form) v##version##_##checked##_##form
#define RTUWIRE_JOIN(version, checked, form) RTUWIRE_JOIN_NAMES(version, checked, form)
#if RTUWIRE_CHECKED
#define RTUWIRE_BUILD RTUWIRE_JOIN(RTUWIRE_VERSION, checked, RTUWIRE_CRC_FORM)
#else
#define RTUWIRE_BUILD RTUWIRE_JOIN(RTUWIRE_VERSION, unchecked, RTUWIRE_CRC_FORM)
#endif

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The same version for the language.
inline constexpr int version = RTUWIRE_VERSION;

namespace detail {

/// Whether there is an operating system.
inline constexpr bool has_system = RTUWIRE_HAS_SYSTEM != 0;

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// In the place of Catch2, where tests are compiled for what they prove at compile time, and never run.
#pragma once

#define RTUWIRE_TEST_NAME_OF(line) compiled_test_##line
#define RTUWIRE_TEST_NAME(line) RTUWIRE_TEST_NAME_OF(line)
#define TEST_CASE(...) [[maybe_unused]] static void RTUWIRE_TEST_NAME(__COUNTER__)()
#define SECTION(...) if (true)
#define CHECK(...) static_cast<void>(__VA_ARGS__)
#define CHECK_FALSE(...) static_cast<void>(__VA_ARGS__)
#define REQUIRE(...) static_cast<void>(__VA_ARGS__)
#define REQUIRE_FALSE(...) static_cast<void>(__VA_ARGS__)
#define CAPTURE(...) static_cast<void>(0)
#define INFO(...) static_cast<void>(0)

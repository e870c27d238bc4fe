// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Catch2's own main, for machines whose distribution has only its headers here.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

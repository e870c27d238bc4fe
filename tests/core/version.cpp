// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The version, and that its namespace is not in anybody's way.
#include <rtuwire/core/version.hpp>

#include <type_traits>

#include "support/proof.hpp"

#include <rtuwire/core/result.hpp>

STATIC_CHECK(rtuwire::version == RTUWIRE_VERSION);
STATIC_CHECK(std::is_same_v<rtuwire::result<int>, rtuwire::RTUWIRE_BUILD::result<int>>);

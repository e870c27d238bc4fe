// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A text literal with its length.
#include <rtuwire/core/text.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

STATIC_CHECK(text{}.size() == 0);
// Behind no characters there is none to look at.
STATIC_CHECK(text{} == text{} and not(text{} == text{"E"}));
STATIC_CHECK(text{"ETA"}.size() == 3 and text{"ETA"}[2] == 'A');
STATIC_CHECK(text{"ETA"} == text{"ETA"} and not(text{"ETA"} == text{"ETI"}));
STATIC_CHECK(not(text{"ETA"} == text{"ET"}));
constexpr text eta{"ETA"};
STATIC_CHECK(*eta.begin() == 'E' and eta.end() - eta.begin() == 3);

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A text literal with its length.
#include <rtuwire/core/literal.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

STATIC_CHECK(literal{}.size() == 0);
// Behind no characters there is none to look at.
STATIC_CHECK(literal{} == literal{} and not(literal{} == literal{"E"}));
STATIC_CHECK(literal{"ETA"}.size() == 3 and literal{"ETA"}[2] == 'A');
STATIC_CHECK(literal{"ETA"} == literal{"ETA"} and not(literal{"ETA"} == literal{"ETI"}));
STATIC_CHECK(not(literal{"ETA"} == literal{"ET"}));
constexpr literal eta{"ETA"};
STATIC_CHECK(*eta.begin() == 'E' and eta.end() - eta.begin() == 3);

} // namespace

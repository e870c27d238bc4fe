// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whose turn it is on a line, and for whom the line is reserved.
#include <rtuwire/client/turns.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

struct somebody : asker {};

constexpr bool forgets_who_held_the_line_before()
{
    turns line;
    somebody who;
    reservation held;
    held.begin(line, who, 1);
    reservation anew;
    anew.begin(line, who, 1);
    anew = held;
    return held.is_on() and not anew.is_on();
}
PROOF("a client set up anew in its place is reserved for nobody", forgets_who_held_the_line_before)

} // namespace

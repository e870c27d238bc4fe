// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How many seeds, frames or moments a test takes where sanitizers look on.
#pragma once

#include <cstdlib>
#include <string_view>

namespace rtuwire::test {

/// The step of a loop over seeds or moments: 1, and with the sanitizers `each`. Those loops pass the same code again, so that
/// some of their rounds show what goes wrong in memory or arithmetic; whatever else is wrong is found without sanitizers,
/// where every round is made. RTUWIRE_DRAWS=all makes every round with them, too: .ci/nightly sanitized.
inline unsigned one_in([[maybe_unused]] unsigned each)
{
#ifdef RTUWIRE_SANITIZED
    char const* const wanted = std::getenv("RTUWIRE_DRAWS");
    return wanted != nullptr and std::string_view{wanted} == "all" ? 1U : each;
#else
    return 1;
#endif
}

} // namespace rtuwire::test

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sends what no client would, and looks whether a plain read is answered afterwards. No frame writes.
#pragma once

#include <chrono>
#include <cstdint>

#include "check/verdict.hpp"

namespace tool {

/// For clauses that need `hostile`. Random ones last for that time; the same seed sends the same. The frame behind which the unit
/// is deaf is looked for by halves, and made as short as it can be, where the unit comes back.
judgement hostile_judged(checked_unit& unit, clause const& which, std::chrono::seconds time, std::uint32_t seed);

} // namespace tool

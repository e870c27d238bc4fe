// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The deadline of what is there at once: only a test that fails meets it, however busy the machine is.
#pragma once

#include <rtuwire/port/chrono.hpp>

namespace rtuwire::test {

inline constexpr duration limit = milliseconds(60'000);

inline instant soon() { return steady_now() + limit; }

} // namespace rtuwire::test

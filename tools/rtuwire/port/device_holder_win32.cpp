// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/device_holder.hpp"

namespace tool {

std::string holder_of(std::string const&) { return {}; } // Windows tells nobody

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/device_holder.hpp"

namespace tool {

device_holder holder_of(std::string const&) { return {}; } // Windows tells nobody

std::string words_of_group(std::string const&) { return {}; }

} // namespace tool

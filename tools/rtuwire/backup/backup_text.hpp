// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Settings as a file: JSON that a diff reads well, a parameter a line, or comma-separated values for people.
#pragma once

#include <string>

#include "backup/saved_settings.hpp"

namespace tool {

[[nodiscard]] std::string json_text_of(saved_settings const& settings);
[[nodiscard]] std::string csv_text_of(saved_settings const& settings);

} // namespace tool

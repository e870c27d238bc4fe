// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All points of a SunSpec unit, by the files of its models.
#pragma once

#include <string_view>

#include "choices.hpp"
#include "exit_status.hpp"

namespace tool {

inline constexpr std::string_view sunspec_word = "@sunspec";

/// Reads each model of which the folder of --sunspec has a file. Refuses a unit without SunSpec's mark.
exit_status read_sunspec(choices const& chosen);

} // namespace tool

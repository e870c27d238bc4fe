// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a frame says, in one line: "read RFR, 3 registers", "RFR 50.0 Hz, FRH 50.0 Hz", "write CMD 0x000F".
#pragma once

#include <string>

#include <rtuwire/trace.hpp>

#include "frame/register_names.hpp"

namespace tool {

/// Names: null where none are known. A response is explained by the request it answers.
std::string summary_of(rtuwire::heard_frame const& heard, register_names const* names);

} // namespace tool

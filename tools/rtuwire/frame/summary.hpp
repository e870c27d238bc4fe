// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a frame says, in one line: "read RFR, 3 registers", "RFR 50.0 Hz, FRH 50.0 Hz", "write CMD 0x000F".
#pragma once

#include <string>

#include <rtuwire/trace.hpp>

#include "catalog/catalog.hpp"

namespace tool {

/// The names of registers are those of a drive; null: numbers. A response is explained by the request it answers.
std::string summary_of(rtuwire::heard_frame const& heard, drive_catalog const* drive);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The parts of frame_layouts.cpp: what only requests, only responses, or both have behind the function.
#pragma once

#include <optional>
#include <string>

#include <rtuwire/frames.hpp>

#include "frame/frame_fields.hpp"

namespace tool {

/// Of a function whose response has other fields than its request.
void read_request(field_reader& from, rtuwire::function_code code);
void read_response(field_reader& from, rtuwire::function_code code, std::optional<asked_run> const& asked);

/// Of a function whose response has the fields of its request; false for others, and nothing is read.
bool read_either(field_reader& from, rtuwire::function_code code);

/// Runs of records of files, with the records in function 21.
void read_runs(field_reader& from, bool with_records);

/// What a function reads or writes.
[[nodiscard]] register_space space_of(rtuwire::function_code code);

/// "coil", "discrete input".
[[nodiscard]] std::string bits_of_function(rtuwire::function_code code);

} // namespace tool

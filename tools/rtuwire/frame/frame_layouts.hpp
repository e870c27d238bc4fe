// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which fields the requests and responses of each function have (AP 6).
#pragma once

#include <optional>

#include <rtuwire/trace.hpp>

#include "frame/frame_fields.hpp"

namespace tool {

/// Reads the PDU as a request or as a response. `asked`: what the request of a response asked for, where
/// it is known.
void read_fields(field_reader& from, rtuwire::frame_role role, std::optional<asked_run> const& asked);

} // namespace tool

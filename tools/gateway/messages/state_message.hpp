// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is published of a device and of a line, as JSON.
#pragma once

#include <cstdint>
#include <string>

#include "device_slot.hpp"
#include "gateway_file.hpp"
#include "running_line.hpp"

namespace tool::gateway {

/// The values of rounds behind `published`, the `seq` of what was published before; 0: all that were ever read. One of an
/// older round than the message tells its own time. Empty where there is none.
[[nodiscard]] std::string state_text(device_plan const& plan, slot_content const& content, std::uint64_t published);

/// The counters of a line, with the time of its own loop.
[[nodiscard]] std::string status_text(line_state const& state);

} // namespace tool::gateway

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes as people write them.
#pragma once

#include <string>

#include <rtuwire/frames.hpp>

namespace tool {

/// "07 03 0C 82".
[[nodiscard]] std::string hex_of(rtuwire::byte_view bytes);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which serial device may have been meant by a path where there is none.
#pragma once

#include <string>

namespace tool {

/// The terminal in the folder of a path whose name is most like it; empty where none is like it.
[[nodiscard]] std::string nearest_device(std::string const& path);

} // namespace tool

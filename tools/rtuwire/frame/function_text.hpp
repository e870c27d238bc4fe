// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions in the words of the specification (AP 6).
#pragma once

#include <string>

#include <rtuwire/frames.hpp>
#include <rtuwire/serial_line.hpp>

namespace tool {

/// "read holding registers"; "function 65" for one that is not public.
[[nodiscard]] std::string function_text(rtuwire::function_code code);

/// "return query data"; "sub-function 5" for one that the specification does not have.
[[nodiscard]] std::string subfunction_text(rtuwire::subfunction what);

} // namespace tool

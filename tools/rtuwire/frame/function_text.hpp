// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions in the words of the specification (AP 6).
#pragma once

#include <string>

#include <rtuwire/frames.hpp>
#include <rtuwire/serial_line.hpp>

namespace tool {

/// "06", "22 (0x16)": its code in decimal, as the specification and the pages have it, and where that is written otherwise, in
/// hexadecimal besides.
[[nodiscard]] std::string function_number(rtuwire::function_code code);

/// "read holding registers"; "function 65 (0x41)" for one that is not public.
[[nodiscard]] std::string function_text(rtuwire::function_code code);

/// "return query data"; "sub-function 5" for one that the specification does not have.
[[nodiscard]] std::string subfunction_text(rtuwire::subfunction what);

} // namespace tool

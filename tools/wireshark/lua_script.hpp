// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A script for Wireshark that shows registers of the drives by name.
#pragma once

#include <ostream>

namespace wireshark {

/// Writes the script: the tables of all drives, and the code that shows them.
void write_lua_script(std::ostream& out);

} // namespace wireshark

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: word_bank<16> io;
#include <rtuwire/server.hpp>

using namespace rtuwire;

namespace meter {
inline constexpr reg<watts> power{.code = "P", .address = 0, .mode = access::read_only};
inline constexpr reg<count16> energy{.code = "E", .address = 1, .mode = access::read_only};
} // namespace meter

void snippet(line_timing const& timing, instant now)
{
    // BLOCK
}

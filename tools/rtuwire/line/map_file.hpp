// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register file of what a map found: an address each, as it comes, to be given names and types by hand.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "line/map_words.hpp"

namespace tool {

struct written_map {
    std::size_t registers{0}; ///< in the file; 0: it was not written
    std::size_t beyond{0};    ///< found, and more than a register file may have
};

/// Writes a file that is not there yet. Ends the command where that fails.
written_map write_map(std::string const& file, std::vector<address_range> const& found);

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Words of `map`: "input:1000-1999", "coil", "0x0C80-0x0CFF".
#pragma once

#include <string>
#include <vector>

#include "words/place.hpp"

namespace tool {

struct address_range {
    register_space space;
    unsigned first;
    unsigned last;
};

/// The ranges that words mean; refuses what is none. Without a word the first 10 000 holding and input registers, which
/// are those of the lists of manuals.
std::vector<address_range> ranges_in(std::vector<std::string> const& words);

} // namespace tool

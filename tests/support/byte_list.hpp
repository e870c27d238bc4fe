// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes from text at run time: "01 03 5A*255" stands for 257 of them.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::test {

using namespace detail;

using byte_list = std::vector<std::byte>;

inline byte_list bytes_of(std::string const& text)
{
    byte_list all;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        auto const star = word.find('*');
        std::size_t const count = star == std::string::npos ? 1 : std::stoul(word.substr(star + 1));
        auto const value = static_cast<std::byte>(std::stoul(word.substr(0, 2), nullptr, 16));
        all.insert(all.end(), count, value);
    }
    return all;
}

inline byte_list glued(byte_list first, byte_view second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

} // namespace rtuwire::test

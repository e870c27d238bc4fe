// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A packet of a pcapng file, with a sentence behind what the library says of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include <rtuwire/trace.hpp>

namespace tool {

/// The same block with one more comment.
inline std::vector<std::byte> commented(rtuwire::byte_view block, std::string_view comment)
{
    constexpr std::size_t end_size = 8; // the end of the options, and the block's length once more
    constexpr std::size_t longest = 1'024;
    constexpr std::size_t comment_option = 1;
    std::string_view const text = comment.substr(0, longest);
    std::vector<std::byte> out(block.begin(), block.end() - end_size);
    auto const add = [&out](std::size_t value, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i) {
            out.push_back(static_cast<std::byte>(value >> 8 * i & 0xFFU));
        }
    };
    add(comment_option, 2);
    add(text.size(), 2);
    std::ranges::transform(text, std::back_inserter(out), [](char each) { return static_cast<std::byte>(each); });
    add(0, (4 - text.size() % 4) % 4);
    add(0, 4);
    std::size_t const size = out.size() + 4;
    add(size, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        out[4 + i] = static_cast<std::byte>(size >> 8 * i & 0xFFU);
    }
    return out;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/typed_lines.hpp"

#include <chrono>
#include <cstddef>

#include "../support/platform.hpp"

namespace tool {

void forget_typed() noexcept
{
    if (is_terminal(STDIN_FILENO) and is_terminal_own()) {
        flush_typed();
    }
}

typed_lines::typed_lines() : is_open_{is_terminal(STDIN_FILENO)} {}

std::optional<std::string> typed_lines::next()
{
    constexpr std::size_t longest = 256;
    if (is_open_ and is_terminal_own()) {
        char place[longest];
        std::ptrdiff_t const size = read_within(STDIN_FILENO, place, std::chrono::milliseconds{0});
        is_open_ = size != 0;
        typed_.append(place, size > 0 ? static_cast<std::size_t>(size) : 0);
    }
    std::size_t const end = typed_.find('\n');
    if (end == std::string::npos) {
        typed_.erase(0, typed_.size() > longest ? typed_.size() : 0);
        return std::nullopt;
    }
    std::string const line = typed_.substr(0, end);
    typed_.erase(0, end + 1);
    return line;
}

void typed_lines::forget()
{
    forget_typed();
    typed_.clear();
}

} // namespace tool

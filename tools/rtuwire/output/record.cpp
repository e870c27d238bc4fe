// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/record.hpp"

#include <charconv>
#include <cmath>

namespace tool {

namespace {

struct to_text {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(std::uint64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const
    {
        char text[32];
        bool const is_whole = value == std::trunc(value) and std::abs(value) < 1e15; // 100000, not 1e+05
        auto const end = is_whole ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed)
                                  : std::to_chars(text, text + sizeof text, value);
        return {text, end.ptr};
    }
    std::string operator()(std::string const& value) const { return value; }
};

} // namespace

std::string text_of_cell(cell const& value) { return std::visit(to_text{}, value); }

} // namespace tool

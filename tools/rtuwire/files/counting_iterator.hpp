// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// For a parser of JSON, which does not tell where it is.
#pragma once

#include <cstddef>
#include <iterator>
#include <string>

namespace tool {

/// Walks over a text, and says how far somebody has come.
class counting_iterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = char const*;
    using reference = char const&;

    counting_iterator(char const* at, char const** farthest) : at_{at}, farthest_{farthest} {}

    reference operator*() const { return *at_; }
    counting_iterator& operator++()
    {
        *farthest_ = ++at_;
        return *this;
    }
    counting_iterator operator++(int)
    {
        counting_iterator const before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(counting_iterator const& left, counting_iterator const& right)
    {
        return left.at_ == right.at_;
    }
    friend bool operator!=(counting_iterator const& left, counting_iterator const& right) { return not(left == right); }

private:
    char const* at_;
    char const** farthest_;
};

/// The text behind the numbers and places that the parser of JSON puts before it.
inline std::string json_reason(std::string const& what)
{
    std::size_t const column = what.find("column ");
    std::size_t const colon = what.find(": ", column == std::string::npos ? 0 : column);
    return colon == std::string::npos ? what : what.substr(colon + 2);
}

} // namespace tool

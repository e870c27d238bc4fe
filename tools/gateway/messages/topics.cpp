// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/topics.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "words/words.hpp"

namespace tool::gateway {

namespace {

constexpr std::size_t longest_part = 40;

} // namespace

std::string why_no_topic_part(std::string_view word)
{
    auto const is_letter = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z'); };
    bool const is_part = not word.empty() and word.size() <= longest_part and std::ranges::all_of(word, [&](char c) {
        return is_letter(c) or is_digit(c) or c == '-' or c == '_';
    });
    return is_part ? std::string{} : "a part of topics has letters, digits, - and _, 1 to 40 of them";
}

std::optional<setting_topic> topics::setting_in(std::string_view topic) const
{
    if (not topic.starts_with(root_ + '/')) {
        return std::nullopt;
    }
    std::vector<std::string_view> const parts = tool::parts_of(topic.substr(root_.size() + 1), "/");
    bool const is_setting =
        parts.size() == 4 and parts[2] == "set" and
        std::ranges::all_of(parts, [](std::string_view each) { return why_no_topic_part(each).empty(); });
    return is_setting
               ? std::optional{setting_topic{std::string{parts[0]}, std::string{parts[1]}, std::string{parts[3]}}}
               : std::nullopt;
}

} // namespace tool::gateway

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Roles and verdicts in words: for people, and for the comments of packets in a capture, from which they are read back.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// "request", "response" or "unknown".
[[nodiscard]] constexpr literal name(frame_role role) noexcept
{
    switch (role) {
    case frame_role::request: return "request";
    case frame_role::response: return "response";
    case frame_role::unknown: break;
    }
    return "unknown";
}

/// The name of the enumerator: "damaged".
[[nodiscard]] constexpr literal name(frame_verdict verdict) noexcept
{
    switch (verdict) {
    case frame_verdict::good: break;
    case frame_verdict::damaged: return "damaged";
    case frame_verdict::late: return "late";
    case frame_verdict::foreign: return "foreign";
    case frame_verdict::echo: return "echo";
    case frame_verdict::stray: return "stray";
    }
    return "good";
}

/// Whether bytes are these characters.
/// Internal.
[[nodiscard]] constexpr bool spells(byte_view bytes, literal word) noexcept
{
    bool is_same = bytes.size() == word.size();
    for (std::size_t i = 0; is_same and i < bytes.size(); ++i) {
        is_same = static_cast<char>(to_u8(bytes[i])) == word[i];
    }
    return is_same;
}

/// Takes what one word of a comment says; any other word says nothing.
/// Internal.
constexpr void apply_word(byte_view word, traced_frame& frame) noexcept
{
    for (frame_role const role : {frame_role::request, frame_role::response}) {
        frame.role = spells(word, name(role)) ? role : frame.role;
    }
    for (auto const verdict : {frame_verdict::damaged, frame_verdict::late, frame_verdict::foreign, frame_verdict::echo,
                               frame_verdict::stray}) {
        frame.verdict = spells(word, name(verdict)) ? verdict : frame.verdict;
    }
}

/// Takes what a comment says: words, with a comma and a space between.
/// Internal.
constexpr void apply_comment(byte_view comment, traced_frame& frame) noexcept
{
    std::size_t start = 0;
    for (std::size_t i = 0; i <= comment.size(); ++i) {
        if (i == comment.size() or comment[i] == std::byte{','}) {
            apply_word(comment.subspan(start, i - start), frame);
            start = i + 2 <= comment.size() ? i + 2 : comment.size();
        }
    }
}

} // namespace rtuwire

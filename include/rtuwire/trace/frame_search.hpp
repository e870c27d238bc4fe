// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a listener holds of a line, and where in it frames are.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/frame_match.hpp>
#include <rtuwire/trace/heard_bytes.hpp>
#include <rtuwire/trace/passed_request.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::detail {

/// Internal: the bytes that were not handed out yet, and the requests that may get a response.
class frame_search {
protected:
    /// What begins at a byte, undamaged.
    constexpr frame_match match_at(std::size_t from, bool is_over) const noexcept
    {
        byte_view const bytes = held_.first(held_.size()).subspan(from);
        frame_match found = match_frame(bytes, pending_.bytes(), is_over);
        if (not found.is_whole() and begins_response(bytes, given_up_.bytes())) {
            frame_match const late = match_response(bytes, given_up_.bytes());
            found = late.is_verified ? response_or_longer(bytes, late, match_request(bytes), is_over) : found;
        }
        if (found.is_whole() and found.role == frame_role::request and lost_.is_any() and
            match_by_rule(direction::response, bytes).size == found.size and
            resembles(bytes.first(found.size), lost_.bytes())) {
            found.role = frame_role::response;
        }
        if (found.is_whole() and held_.is_damaged(from, found.size)) {
            found.is = frame_match::outcome::refuted;
        }
        return found;
    }

    /// Where among the bytes a frame begins for which more than a CRC speaks; 0 for nowhere.
    constexpr std::size_t find_frame(bool is_silent) const noexcept
    {
        for (std::size_t from = 1; from + min_adu_size <= held_.size(); ++from) {
            frame_match const found = match_at(from, is_silent);
            std::size_t const behind = from + found.size;
            bool const is_request = found.is_whole() and found.role == frame_role::request;
            if (found.is_verified or
                (is_request and ((is_silent and behind == held_.size()) or is_answered(from, found.size)))) {
                return from;
            }
        }
        return 0;
    }

    /// Whether right behind a request its response stands.
    constexpr bool is_answered(std::size_t from, std::size_t size) const noexcept
    {
        byte_view const bytes = held_.first(held_.size()).subspan(from);
        frame_match const found = match_response(bytes.subspan(size), bytes.first(size));
        return found.is_verified and not held_.is_damaged(from + size, found.size);
    }

    constexpr bool has_no_rule(byte_view bytes) const noexcept
    {
        return bytes.size() >= min_adu_size and bytes.size() <= max_adu_size and
               not held_.is_damaged(0, bytes.size()) and has_right_crc(bytes) and
               frame_length(direction::request, bytes).size() == 0;
    }

    constexpr frame_role role_of(byte_view bytes) const noexcept
    {
        return begins_response(bytes, pending_.bytes()) ? frame_role::response : frame_role::request;
    }

    static constexpr bool has_rule(byte_view bytes) noexcept
    {
        return frame_length(direction::response, bytes).size() != 0;
    }

    heard_bytes held_{};
    passed_request pending_{};
    passed_request given_up_{};
    passed_request lost_{}; ///< damaged bytes in the place of a request
};

} // namespace rtuwire::detail

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a listener said, to be compared with what was on the line.
#pragma once

#include <rtuwire/trace/line_listener.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "trace/listener/made_exchange.hpp"

namespace listening {

/// A frame, and the request that it answers.
struct heard_entry {
    rtuwire::frame_role role;
    rtuwire::frame_verdict verdict;
    bytes frame;
    bytes request;

    friend bool operator==(heard_entry const&, heard_entry const&) = default;
};

inline bytes copied(rtuwire::byte_view view) { return {view.begin(), view.end()}; }

struct heard_list {
    std::vector<heard_entry> frames{}; ///< those with a role
    std::size_t unanswered{0};
    std::size_t damaged_bytes{0};
    std::size_t all_bytes{0};

    void take(rtuwire::heard_frame const& it)
    {
        all_bytes += it.frame.bytes.size();
        if (it.is_unanswered) {
            ++unanswered;
        } else if (it.frame.role == rtuwire::frame_role::unknown) {
            damaged_bytes += it.frame.bytes.size();
        } else {
            frames.push_back({it.frame.role, it.frame.verdict, copied(it.frame.bytes), copied(it.request)});
        }
    }
};

inline std::string text_of(bytes const& frame)
{
    std::string text;
    for (std::byte const each : frame) {
        char pair[4];
        std::snprintf(pair, sizeof pair, "%02X ", std::to_integer<unsigned>(each));
        text += pair;
    }
    return text;
}

inline std::string text_of(heard_entry const& it)
{
    return "role " + std::to_string(static_cast<int>(it.role)) + ", verdict " +
           std::to_string(static_cast<int>(it.verdict)) + ": " + text_of(it.frame) + "for " + text_of(it.request);
}

/// Where two lists differ first; empty where they are the same.
inline std::string first_difference(std::vector<heard_entry> const& heard, std::vector<heard_entry> const& truth)
{
    for (std::size_t i = 0; i < heard.size() or i < truth.size(); ++i) {
        if (i >= heard.size() or i >= truth.size() or not(heard[i] == truth[i])) {
            return std::to_string(i) + ": heard " + (i < heard.size() ? text_of(heard[i]) : "nothing") + "\n   was " +
                   (i < truth.size() ? text_of(truth[i]) : "nothing");
        }
    }
    return {};
}

} // namespace listening

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "chaos/request_guard.hpp"

#include <algorithm>

#include "motion/raw_effect.hpp"

namespace tool {

bool request_guard::lets_pass(rtuwire::byte_view bytes, bool is_own, rtuwire::instant now)
{
    constexpr rtuwire::duration longest_pause = rtuwire::milliseconds(3'000);
    if (reached(now, gone_ + longest_pause)) {
        bytes_.clear();
        is_own_.clear();
    }
    std::size_t const before = bytes_.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    is_own_.insert(is_own_.end(), bytes.size(), is_own);
    if (holds_request(before)) {
        bytes_.resize(before);
        is_own_.resize(before);
        return false;
    }
    gone_ = now;
    if (bytes_.size() > rtuwire::max_adu_size) {
        auto const old = static_cast<std::ptrdiff_t>(bytes_.size() - rtuwire::max_adu_size);
        bytes_.erase(bytes_.begin(), bytes_.begin() + old);
        is_own_.erase(is_own_.begin(), is_own_.begin() + old);
    }
    return true;
}

bool request_guard::holds_request(std::size_t from) const
{
    if (std::ranges::find(is_own_, true) == is_own_.end()) {
        return false;
    }
    for (std::size_t at = 0; at < bytes_.size(); ++at) {
        rtuwire::running_crc16<> crc;
        bool is_own = false;
        for (std::size_t end = at; end < std::min(bytes_.size(), at + rtuwire::max_adu_size);) {
            crc.add(bytes_[end]);
            is_own = is_own or is_own_[end];
            ++end;
            if (is_own and end > from and crc.value() == 0 and is_refused(at, end)) {
                return true;
            }
        }
    }
    return false;
}

bool request_guard::is_refused(std::size_t at, std::size_t end) const
{
    rtuwire::byte_view const frame = rtuwire::byte_view{bytes_}.subspan(at, end - at);
    if (frame.size() < rtuwire::min_adu_size) {
        return false;
    }
    return way_ == frame_way::request ? rtuwire::all_functions.contains(static_cast<rtuwire::function_code>(frame[1]))
                                      : not changing_frame_in(frame, functions_within::public_ones, 0).empty();
}

} // namespace tool

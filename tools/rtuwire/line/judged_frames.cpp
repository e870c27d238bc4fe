// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/judged_frames.hpp"

namespace tool {

using rtuwire::byte_view;
using rtuwire::frame_role;
using rtuwire::frame_verdict;

namespace {

/// As `line_listener` has it.
constexpr std::uint64_t response_limit = 400'000;

rtuwire::instant instant_of(std::uint64_t at) { return rtuwire::instant{static_cast<std::uint32_t>(at)}; }

/// Whether a response may be to a request: of that unit and function.
bool may_answer(byte_view request, byte_view response)
{
    constexpr std::byte function_bits{0x7F};
    return request.size() > 1 and response.size() > 1 and request[0] == response[0] and
           (request[1] & function_bits) == (response[1] & function_bits);
}

} // namespace

void judged_frames::put(rtuwire::traced_frame const& frame, std::uint64_t at)
{
    rtuwire::heard_frame it{frame, frame.at - wire_.characters(frame.bytes.size() - 1)};
    bool const is_whole = frame.verdict != frame_verdict::damaged;
    if (frame.verdict == frame_verdict::echo) {
        take_({it, at, wire_});
    } else if (is_whole and frame.role == frame_role::request) {
        request(it, at);
    } else if (is_whole and frame.role == frame_role::response) {
        response(it, at);
    } else {
        other(it, at);
    }
}

void judged_frames::finish()
{
    if (not pending_.bytes.empty()) {
        give_up(pending_.end + response_limit);
    }
}

std::uint64_t judged_frames::start_of(rtuwire::heard_frame const& it, std::uint64_t at) const
{
    std::uint64_t const length = wire_.characters(it.frame.bytes.size()).microseconds;
    return at > length ? at - length : 0; // a board without a calendar begins at 0
}

void judged_frames::request(rtuwire::heard_frame& it, std::uint64_t at)
{
    give_up_in_time(start_of(it, at));
    if (not pending_.bytes.empty()) {
        give_up(at);
    }
    take_({it, at, wire_});
    bool const is_broadcast = it.frame.bytes[0] == std::byte{0};
    pending_.bytes.assign(it.frame.bytes.begin(), is_broadcast ? it.frame.bytes.begin() : it.frame.bytes.end());
    pending_.end = at;
}

void judged_frames::response(rtuwire::heard_frame& it, std::uint64_t at)
{
    bool const is_late = it.frame.verdict == frame_verdict::late;
    bool const is_stray = it.frame.verdict == frame_verdict::stray;
    if (is_late or is_stray) {
        give_up_in_time(start_of(it, at));
    }
    if (is_late and not may_answer(given_up_.bytes, it.frame.bytes) and may_answer(pending_.bytes, it.frame.bytes)) {
        give_up(at);
    }
    asked& which = is_late ? given_up_ : pending_;
    if (not is_stray and may_answer(which.bytes, it.frame.bytes)) {
        answer(it, at, which);
    } else {
        take_({it, at, wire_});
    }
}

void judged_frames::answer(rtuwire::heard_frame& it, std::uint64_t at, asked& which)
{
    std::uint64_t const start = at - wire_.characters(it.frame.bytes.size() - 1).microseconds;
    it.request = which.bytes;
    it.response_time = rtuwire::microseconds(start > which.end ? static_cast<std::uint32_t>(start - which.end) : 0U);
    take_({it, at, wire_});
    which.bytes.clear();
}

void judged_frames::other(rtuwire::heard_frame& it, std::uint64_t at)
{
    give_up_in_time(start_of(it, at));
    it.request = pending_.bytes;
    take_({it, at, wire_});
    if (it.frame.verdict == frame_verdict::damaged) {
        if (not pending_.bytes.empty()) {
            give_up(at);
        }
        given_up_.bytes.clear();
    }
}

void judged_frames::give_up(std::uint64_t at)
{
    rtuwire::heard_frame it{{{}, instant_of(at)}, instant_of(at)};
    it.request = pending_.bytes;
    it.response_time = rtuwire::microseconds(static_cast<std::uint32_t>(at - pending_.end));
    it.is_unanswered = true;
    take_({it, at, wire_});
    given_up_ = pending_;
    pending_.bytes.clear();
}

void judged_frames::give_up_in_time(std::uint64_t start)
{
    if (not pending_.bytes.empty() and start >= pending_.end + response_limit) {
        give_up(pending_.end + response_limit);
    }
}

} // namespace tool

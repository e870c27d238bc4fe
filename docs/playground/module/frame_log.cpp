// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame_log.hpp"

#include <algorithm>
#include <utility>

#include "explained.hpp"
#include "frame/hex_text.hpp"

namespace playground {

namespace {

std::string_view name_of(sender from)
{
    switch (from) {
    case sender::client: return "client";
    case sender::drive: return "drive";
    case sender::person: return "you";
    }
    return "";
}

void put_line(json_text& out, std::uint32_t number, seen_frame const& frame)
{
    out.open_object();
    out.put("number", number);
    out.put("begin", frame.begin_us);
    out.put("end", frame.end_us);
    out.put("from", name_of(frame.from));
    out.put("damaged", frame.is_damaged);
    out.put("unanswered", frame.is_unanswered);
    out.put("lost", frame.is_lost);
    out.put("exception", frame.is_exception);
    out.put("hex", tool::hex_of(frame.bytes));
    out.put("summary", frame.summary);
    out.close_object();
}

} // namespace

void frame_log::add(seen_frame frame)
{
    frames_.push_back(std::move(frame));
    if (frames_.size() > most) {
        frames_.erase(frames_.begin());
        ++first_;
    }
}

std::string frame_log::list(std::uint32_t from) const
{
    json_text out;
    out.open_list();
    for (std::uint32_t number = std::max(from, first_); number < end(); ++number) {
        put_line(out, number, frames_[number - first_]);
    }
    out.close_list();
    return out.text();
}

std::string frame_log::explain(std::uint32_t number, tool::register_names const* names) const
{
    json_text out;
    out.open_object();
    out.open_list("frames");
    if (number >= first_ and number < end()) {
        seen_frame const& frame = frames_[number - first_];
        tool::frame_decoder decoder{names};
        decoder.expect_answer_to(frame.request);
        for (auto const& each : decoder.decode(frame.is_unanswered ? frame.request : frame.bytes)) {
            put_frame(out, each);
        }
    }
    out.close_list();
    out.close_object();
    return out.text();
}

} // namespace playground

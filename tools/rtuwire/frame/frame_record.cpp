// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_record.hpp"

#include <string>

#include "frame/hex_text.hpp"
#include "frame/summary.hpp"
#include "line/time_text.hpp"

namespace tool {

using rtuwire::frame_role;
using rtuwire::frame_verdict;

namespace {

std::string role_of(rtuwire::heard_frame const& heard)
{
    return heard.is_unanswered ? std::string{"silence"} : std::string{name(heard.frame.role)};
}

std::string verdict_of(rtuwire::heard_frame const& heard)
{
    return heard.is_unanswered ? std::string{"unanswered"} : std::string{name(heard.frame.verdict)};
}

/// From the last byte of the request to the first of the response, which is computed from its last one: an adapter hands
/// over all at once.
cell response_milliseconds(tapped_frame const& it)
{
    rtuwire::heard_frame const& heard = it.heard;
    if (heard.is_unanswered) {
        return static_cast<double>(heard.response_time.microseconds) / 1'000.0;
    }
    if (heard.frame.role != frame_role::response or heard.request.empty()) {
        return {};
    }
    rtuwire::duration const whole = heard.response_time + (heard.frame.at - heard.first_byte);
    rtuwire::duration const itself = it.wire.characters(heard.frame.bytes.size());
    auto const left = static_cast<std::int64_t>(whole.microseconds) - static_cast<std::int64_t>(itself.microseconds);
    return static_cast<double>(left > 0 ? left : 0) / 1'000.0;
}

} // namespace

frame_records::frame_records(choices const& chosen)
    : units_{chosen.line}, is_table_{chosen.form == output_form::table}, results_{chosen.form, true}
{}

record frame_records::record_of(tapped_frame const& it) const
{
    auto const& heard = it.heard;
    record line{{"time", exact_time_text(it.unix_microseconds)},
                {"role", role_of(heard)},
                {"unit", std::int64_t{heard.unit()}},
                {"verdict", verdict_of(heard)},
                {"ms", response_milliseconds(it)},
                {"text", summary_of(heard, units_.of(heard.unit()))},
                {"bytes", hex_of(heard.frame.bytes)}};
    if (not is_table_) {
        line.add("own", heard.frame.is_own);
    }
    return line;
}

void frame_records::put(tapped_frame const& it)
{
    has_any_ = true;
    bool const is_bad = it.heard.is_unanswered or it.heard.frame.verdict != frame_verdict::good;
    results_.put(record_of(it), is_bad);
}

exit_status frame_records::finish()
{
    results_.finish();
    return has_any_ ? exit_status::done : exit_status::no_answer;
}

} // namespace tool

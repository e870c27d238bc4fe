// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/serve_events.hpp"

#include <chrono>

#include "../support/say.hpp"
#include "line/time_text.hpp"
#include "output/passing_text.hpp"
#include "output/plain_text.hpp"

namespace tool {

void serve_events::note(std::string_view event, record const& more, std::string const& text) const
{
    if (not is_json_) {
        return;
    }
    record line{{"time", time_text(unix_now())}, {"event", std::string{event}}};
    for (field const& each : more.fields()) {
        line.add(each.name, each.value);
    }
    line.add("text", text);
    standard_output.put(make_json()->text_of(line));
}

void serve_events::tell(std::string_view event, record const& more, std::string const& text) const
{
    note(event, more, text);
    tell_at_once("serve: " + plain_text(text) + '\n');
}

void serve_events::begin(record const& more, std::string const& text) const
{
    if (is_json_) {
        note("listening", more, text);
    } else {
        standard_output.put(plain_text(text) + '\n');
    }
    constexpr std::chrono::milliseconds longest{500};
    standard_output.finish(longest);
}

} // namespace tool

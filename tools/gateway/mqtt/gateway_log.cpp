// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "mqtt/gateway_log.hpp"

#include <unistd.h>

#include "../../support/platform.hpp"
#include "line/time_text.hpp"
#include "messages/utc_time.hpp"
#include "output/output.hpp"
#include "output/passing_text.hpp"
#include "output/plain_text.hpp"

namespace tool::gateway {

namespace {

cell text_or_nothing(std::string const& text) { return text.empty() ? cell{} : cell{text}; }

} // namespace

void gateway_log::tell(gateway_event const& event) const
{
    tell_at_once("rtuwire-gateway: " + plain_text(event.text) + '\n');
    if (has_json_) {
        std::uint64_t const time = event.time != 0 ? event.time : unix_now();
        write_at_once(STDOUT_FILENO, make_json()->text_of({{"time", utc_text(time)},
                                                           {"event", event.name},
                                                           {"line", text_or_nothing(event.line)},
                                                           {"device", text_or_nothing(event.device)},
                                                           {"text", event.text}}));
    }
}

} // namespace tool::gateway

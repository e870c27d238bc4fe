// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lets many clients ask the units of one line, one request at a time. It reads unless --write says otherwise, and passes on
// nothing by which the motor of a known drive may turn.
#include <chrono>
#include <string>

#include "../support/say.hpp"
#include "commands/commands.hpp"
#include "line/write_log.hpp"
#include "output/passing_text.hpp"
#include "serve/serve_settings.hpp"
#include "serve/served_clients.hpp"
#include "serve/served_line.hpp"

namespace tool {

namespace {

/// What is served besides what only reads, and what reading does to drives.
void tell_what_is_served(choices const& chosen, serve_settings const& settings)
{
    std::string text;
    if (settings.names_units()) {
        text +=
            "serve: --units " + chosen.serve.units +
            ": where one of them is a drive, each request feeds its supervision of the line: it begins where the drive "
            "is idle, and a motor whose controller has gone runs on while clients read\n";
    }
    if (settings.gate.may_write) {
        text +=
            "serve: --write: clients may write what the command write may, to whoever is served; nothing by which a "
            "motor of a known drive may turn, and 0000, which stops one; which registers run another maker's, nobody "
            "here "
            "knows\n";
    }
    tell_at_once(text);
}

} // namespace

exit_status run_serve(choices const& chosen)
{
    serve_settings const settings = serve_settings_in(chosen);
    for (std::string const& why : {why_it_asks_itself(settings, chosen.line), why_nobody_comes(settings)}) {
        if (not why.empty()) {
            refuse_word(why);
        }
    }
    // So long the request that is under way may take: whether something was written is answered.
    std::chrono::duration<double> const response_time{chosen.line.response_timeout.value_or(1.0)};
    serve_counts counts;
    serve_events const events{chosen.form};
    served_clients clients{settings, counts, events,
                           std::chrono::duration_cast<std::chrono::microseconds>(response_time)};
    if (settings.gate.may_write) {
        refuse_wrong_log();
    }
    clients.listen();
    reopened_line line{chosen, settings, clients, counts, events};
    tell_what_is_served(chosen, settings);
    clients.begin();
    line.run();
    clients.end();
    constexpr std::chrono::milliseconds longest{500};
    standard_output.finish(longest);
    return exit_status::done;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes what passes on a line to a file that Wireshark reads, or to a pipe that it reads meanwhile.
#include <cstdio>

#include "commands/commands.hpp"
#include "line/capture_output.hpp"
#include "line/end_wish.hpp"
#include "line/tap.hpp"
#include "line/time_text.hpp"

namespace tool {

exit_status run_capture(choices const& chosen)
{
    note_signals();
    any_port port = open_to_listen(chosen);
    line_calendar const calendar{unix_now()};
    capture_output file{chosen.file,
                        {.form = capture_form_in(chosen.capture_form), .bits_per_second = chosen.line.baud},
                        port.device(),
                        calendar};
    listen(
        port, chosen, calendar,
        [&](tapped_frame const& it) {
            if (not it.heard.is_unanswered) {
                file.put(it.heard.frame);
            }
        },
        [&] {
            file.advance(port.now());
            return file.is_open();
        });
    std::fprintf(stderr, "%zu frames\n", file.frames());
    return file.frames() > 0 ? exit_status::done : exit_status::no_answer;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Shows what others say on the line, a line a frame, and keeps it in a capture where one is named.
#include <memory>

#include "commands/commands.hpp"
#include "frame/frame_record.hpp"
#include "line/capture_output.hpp"
#include "line/end_wish.hpp"
#include "line/heard_setting.hpp"
#include "line/line_words.hpp"
#include "line/played_capture.hpp"
#include "line/tap.hpp"
#include "line/time_text.hpp"

namespace tool {

namespace {

std::unique_ptr<capture_output> kept(choices const& chosen, any_port const& port, line_calendar const& calendar)
{
    if (chosen.file == "-") {
        refuse_word("sniff shows frames on standard output: a capture goes there by `" +
                    shown_command(chosen.line, "capture -o -") + "`");
    }
    return chosen.file.empty()
               ? nullptr
               : std::make_unique<capture_output>(chosen.file,
                                                  rtuwire::capture_options{.bits_per_second = chosen.line.baud},
                                                  port.device(), calendar);
}

} // namespace

exit_status run_sniff(choices const& chosen)
{
    if (chosen.finds_setting) {
        return find_heard_setting(chosen);
    }
    if (is_capture(chosen)) {
        if (not chosen.file.empty()) {
            refuse_word("-o " + chosen.file + ": " + chosen.line.port + " is a capture already");
        }
        return run_replay(chosen);
    }
    note_signals();
    frame_records show{chosen};
    any_port port = open_to_listen(chosen);
    line_calendar const calendar{unix_now()};
    std::unique_ptr<capture_output> const file = kept(chosen, port, calendar);
    auto const take = [&](tapped_frame const& it) {
        show.put(it);
        if (file and not it.heard.is_unanswered) {
            file->put(it.heard.frame);
        }
    };
    auto const goes_on = [&] {
        if (file) {
            file->advance(port.now());
        }
        return show.is_open();
    };
    listen(port, chosen, calendar, take, goes_on);
    return show.finish();
}

} // namespace tool

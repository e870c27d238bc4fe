// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Explains bytes: no line is needed.
#include <iostream>
#include <sstream>
#include <string>

#include "commands/commands.hpp"
#include "frame/decode.hpp"
#include "frame/hex_lines.hpp"
#include "frame/hex_text.hpp"
#include "line/who_is_it.hpp"

namespace tool {

namespace {

/// Shows frames, a row a field. A table for people leaves out what is as in the row above.
class frame_printer {
public:
    explicit frame_printer(output_form form) : is_table_{form == output_form::table}, results_{form, false} {}

    void put(decoded_frame const& frame)
    {
        ++number_;
        for (frame_reading const& reading : frame.readings) {
            is_first_ = true;
            for (frame_field const& each : reading.fields) {
                put(frame, reading, each);
            }
            if (not reading.flaw.empty()) {
                put(frame, reading, {0, 0, "flaw", reading.flaw});
            }
        }
    }
    /// Shows what has waited: a run of frames in columns as wide as they need.
    void finish_run() { results_.finish(); }

    bool is_open() const { return results_.is_open(); }

private:
    void put(decoded_frame const& frame, frame_reading const& reading, frame_field const& each)
    {
        bool const is_flaw = each.length == 0;
        record row;
        row.add("frame", is_table_ and not is_first_ ? cell{std::string{}} : cell{number_});
        row.add("as", is_table_ and not is_first_ ? std::string{} : reading.as);
        row.add("at", is_flaw ? cell{} : cell{static_cast<std::int64_t>(frame.offset + each.offset)});
        row.add("bytes", hex_of(rtuwire::byte_view{frame.bytes}.subspan(each.offset, each.length)));
        row.add("field", each.name).add("value", each.value);
        results_.put(row);
        is_first_ = false;
    }

    bool is_table_;
    output results_;
    std::int64_t number_{0};
    bool is_first_{true};
};

std::string joined(std::vector<std::string> const& words)
{
    std::string text;
    for (std::string const& each : words) {
        text += (text.empty() ? "" : " ") + each;
    }
    return text;
}

} // namespace

exit_status run_decode(choices const& chosen)
{
    drive_catalog const* const drive = chosen.line.drive.empty() ? nullptr : &catalog_chosen(chosen.line.drive);
    bool const is_piped = chosen.words == std::vector<std::string>{"-"};
    std::istringstream words{joined(chosen.words)};
    hex_lines lines{is_piped ? std::cin : words};
    frame_decoder decoder{drive};
    frame_printer printer{chosen.form};
    exit_status status = exit_status::done;
    std::vector<std::byte> run;
    bool has_bytes = false;
    while (printer.is_open() and lines.next(run)) {
        has_bytes = true;
        for (decoded_frame const& frame : decoder.decode(run)) {
            printer.put(frame);
            status = frame.is_good() ? status : exit_status::differs;
        }
        printer.finish_run();
    }
    if (not has_bytes) {
        refuse_word("there are no bytes to explain");
    }
    return status;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Explains bytes: no line is needed.
#include <iostream>
#include <sstream>
#include <string>

#include "commands/commands.hpp"
#include "frame/decode.hpp"
#include "frame/frame_printer.hpp"
#include "frame/hex_lines.hpp"
#include "line/played_capture.hpp"

namespace tool {

namespace {

std::string joined(std::vector<std::string> const& words)
{
    std::string text;
    for (std::string const& each : words) {
        text += (text.empty() ? "" : " ") + each;
    }
    return text;
}

/// Explains runs of bytes; its status.
class explaining {
public:
    explicit explaining(choices const& chosen)
        : words_{joined(chosen.words)}, decoder_{known_units{chosen.line}}, printer_{chosen.form}
    {}

    /// A line's bytes; both readings of digits whose CRC is right in neither.
    void put(byte_run const& run, std::size_t line)
    {
        bool const is_either = not run.or_decimal.empty();
        put(run.bytes, run.is_decimal ? "decimal" : is_either ? "hexadecimal" : "");
        if (is_either) {
            put(run.or_decimal, "decimal");
            std::cerr << "rtuwire: line " << line
                      << ": its CRC is right neither in hexadecimal nor in decimal numbers\n";
        }
    }
    void put(rtuwire::byte_view run, std::string const& numbers = {})
    {
        has_bytes_ = true;
        for (decoded_frame const& frame : decoder_.decode(run)) {
            printer_.put(frame, numbers.empty() ? std::string{} : "numbers", numbers);
            status_ = frame.is_good() ? status_ : exit_status::differs;
        }
        printer_.finish_run();
    }
    /// A frame of which it was decided which request it answers.
    void put(rtuwire::heard_frame const& heard)
    {
        if (heard.frame.role == rtuwire::frame_role::response) {
            decoder_.expect_answer_to(heard.request);
        }
        put(heard.frame.bytes);
    }
    bool is_open() const { return printer_.is_open(); }
    exit_status finish() const
    {
        if (not has_bytes_) {
            bool const is_typed = not words_.empty() and words_ != "-";
            refuse_word(is_typed
                            ? words_ + ": there are no bytes to explain in this; a capture is shown by `decode -p " +
                                  words_ + "`, a file of lines on the standard input: decode - <" + words_
                            : "there are no bytes to explain");
        }
        return status_;
    }

private:
    std::string words_;
    frame_decoder decoder_;
    frame_printer printer_;
    exit_status status_{exit_status::done};
    bool has_bytes_{false};
};

} // namespace

exit_status run_decode(choices const& chosen)
{
    explaining explain{chosen};
    if (chosen.words.empty() and is_capture(chosen)) {
        play_capture(capture_in(chosen), setting_in(chosen.line), [&explain](tapped_frame const& it) {
            if (not it.heard.is_unanswered and explain.is_open()) {
                explain.put(it.heard);
            }
        });
        return explain.finish();
    }
    bool const is_piped = chosen.words == std::vector<std::string>{"-"};
    std::istringstream words{joined(chosen.words)};
    hex_lines lines{is_piped ? std::cin : words};
    byte_run run;
    while (explain.is_open() and lines.next(run)) {
        explain.put(run, lines.number());
    }
    return explain.finish();
}

} // namespace tool

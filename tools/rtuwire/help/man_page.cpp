// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "help/tool_texts.hpp"

namespace tool {

namespace {

/// A text that troff takes as it is.
std::string plain(std::string const& text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool const begins_line = i == 0 or text[i - 1] == '\n';
        out += begins_line and (text[i] == '.' or text[i] == '\'') ? "\\&" : "";
        if (text[i] == '\\') {
            out += "\\e";
        } else if (text[i] == '-') {
            out += "\\-";
        } else {
            out += text[i];
        }
    }
    return out;
}

std::string of_option(option_text const& option)
{
    std::string names;
    for (std::string const& each : option.names) {
        names += (names.empty() ? "" : ", ") + each;
    }
    return ".TP\n.B " + plain(names) + "\n" + plain(option.what) + "\n";
}

std::string of_command(command_text const& command)
{
    std::string text = ".SS " + plain(command.name) + (command.operand.empty() ? "" : " " + plain(command.operand)) +
                       "\n" + plain(command.what) + ".\n";
    if (not command.operand.empty()) {
        text += ".TP\n.I " + plain(command.operand) + "\n" + plain(command.operand_what) + "\n";
    }
    for (option_text const& each : command.options) {
        text += of_option(each);
    }
    return text + (command.example.empty() ? "" : ".PP\n.EX\n" + plain(command.example) + "\n.EE\n");
}

constexpr char const* files_and_statuses =
    R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
The device refused, or something is not as expected.
.TP
.B 2
A word of the command line or of the configuration file is wrong.
.TP
.B 3
Nobody answered.
.TP
.B 4
The port, or the output, failed.
.TP
.B 5
Refused for safety.
.TP
.B 128 + the number of a signal
A signal ended it.
.SH FILES
.TP
.I ./rtuwire.toml, $XDG_CONFIG_HOME/rtuwire.toml
The configuration, where \-\-config names none; the first that there is.
.TP
.I $XDG_STATE_HOME/rtuwire/writes.log
Who wrote what, and when.
.SH NOTES
Not a safety channel: a Modbus line does not guarantee that anything arrives.
Any request, a read as well, starts a drive's supervision of its line: where its next comes too late, it shows the fault SLF.
)";

} // namespace

std::string man_page(tool_texts const& texts)
{
    std::string text = ".TH RTUWIRE 1 \"\" \"rtuwire " + texts.version +
                       "\"\n.SH NAME\nrtuwire \\- Modbus RTU lines and Altivar drives from a terminal\n"
                       ".SH SYNOPSIS\n.B rtuwire\n[\\fIOPTION\\fR...] \\fICOMMAND\\fR [\\fIWORD\\fR...]\n"
                       ".SH DESCRIPTION\n" +
                       plain(texts.what) + "\n.SH OPTIONS\n";
    for (option_text const& each : texts.options) {
        text += of_option(each);
    }
    text += ".SH COMMANDS\n";
    for (command_text const& each : texts.commands) {
        text += of_command(each);
    }
    text += ".SH FIRST STEPS\n.EX\n" + plain(first_steps_text()) + ".EE\n";
    return text + ".SH PLACES OF ANY DEVICE\n.EX\n" + plain(places_text()) + ".EE\n" + files_and_statuses;
}

} // namespace tool

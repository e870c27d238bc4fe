// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "help/tool_texts.hpp"

#include <algorithm>
#include <string_view>

#include "catalog/catalog.hpp"
#include "line/line_words.hpp"
#include "words/register_words.hpp"

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

std::string drives()
{
    std::vector<std::string> names;
    for (drive_catalog const* const each : all_catalogs()) {
        names.emplace_back(each->name);
    }
    return joined(names);
}

std::string formats()
{
    std::vector<std::string> names;
    for (named_format const& each : all_formats) {
        names.emplace_back(each.name);
    }
    return joined(names);
}

/// Mnemonics and groups.
std::string registers_of(drive_catalog const& drive)
{
    std::vector<std::string> words;
    for (register_entry const& each : drive.registers) {
        words.emplace_back(each.code);
    }
    for (std::string_view const each : all_groups_of(drive)) {
        words.push_back("@" + std::string{each});
    }
    return joined(words);
}

std::string names_of(std::vector<option_text> const& options, bool must_take_value)
{
    std::vector<std::string> names;
    for (option_text const& each : options) {
        if (each.takes_value or not must_take_value) {
            names.insert(names.end(), each.names.begin(), each.names.end());
        }
    }
    return joined(names);
}

std::string pattern_of(std::string words)
{
    std::replace(words.begin(), words.end(), ' ', '|');
    return words;
}

bool takes(command_text const& command, std::string_view operand)
{
    return command.operand.find(operand) != std::string::npos;
}

/// What a command completes its own words with, as one of the shell's functions.
std::string_view operands_of(command_text const& command)
{
    if (takes(command, "REG=")) {
        return "settings";
    }
    if (takes(command, "REG") or takes(command, "PATTERN")) {
        return "registers";
    }
    if (takes(command, "DRIVE")) {
        return "drives";
    }
    if (takes(command, "SHELL")) {
        return "shells";
    }
    return takes(command, "FILE") or takes(command, "PORT") ? "files" : "nothing";
}

/// Functions that both shells understand: words, one function a kind.
std::string word_lists(tool_texts const& texts)
{
    std::string text = "_rtuwire_registers_of() {\n    case $1 in\n";
    for (drive_catalog const* const each : all_catalogs()) {
        text += "        " + std::string{each->name} + ") echo '" + registers_of(*each) + "' ;;\n";
    }
    text += "    esac\n}\n\n_rtuwire_options_of() {\n    case $1 in\n";
    for (command_text const& each : texts.commands) {
        text += "        " + each.name + ") echo '" + names_of(each.options, false) + "' ;;\n";
    }
    text += "    esac\n    echo '" + names_of(texts.options, false) + "'\n}\n\n";
    text += "_rtuwire_operands_of() {\n    case $1 in\n";
    for (command_text const& each : texts.commands) {
        text += "        " + each.name + ") echo " + std::string{operands_of(each)} + " ;;\n";
    }
    return text + "    esac\n}\n\n";
}

std::string names_of_commands(tool_texts const& texts)
{
    std::vector<std::string> names;
    for (command_text const& each : texts.commands) {
        names.push_back(each.name);
    }
    return joined(names);
}

std::string values_taking(tool_texts const& texts)
{
    std::string all = names_of(texts.options, true);
    for (command_text const& each : texts.commands) {
        std::string const own = names_of(each.options, true);
        all += own.empty() ? "" : " " + own;
    }
    return pattern_of(all);
}

/// Walks over the words before the one that is completed: sets `command` and `drive`.
std::string walk(tool_texts const& texts, std::string_view words)
{
    return "    local command= drive= before= each\n"
           "    for each in " +
           std::string{words} +
           "; do\n"
           "        case $before in\n"
           "            -d|--drive) drive=$each; before=; continue ;;\n"
           "            " +
           values_taking(texts) +
           ") before=; continue ;;\n"
           "        esac\n"
           "        before=$each\n"
           "        case $each in\n"
           "            --drive=*) drive=${each#--drive=} ;;\n"
           "            -*) ;;\n"
           "            *) [ -n \"$command\" ] || command=$each ;;\n"
           "        esac\n"
           "    done\n";
}

/// What stands behind an option that takes one of some words, and the commands' own words; `choose` takes the words.
std::string choices_of_words(tool_texts const& texts)
{
    return "    case $before in\n"
           "        -d|--drive) choose \"" +
           drives() + " none" +
           "\"; return ;;\n"
           "        -f|--format|--formats) choose '" +
           formats() +
           "'; return ;;\n"
           "        -b|--baud|--bauds) choose '4800 9600 19200 38400 57600 115200'; return ;;\n"
           "        --as) choose 'udp user0 rtac upper-pdu'; return ;;\n"
           "        -p|--port) choose \"$(ls /dev/ttyUSB* /dev/ttyACM* /dev/ttyS* /dev/serial/by-id/* 2>/dev/null)\"; "
           "return ;;\n"
           "        -o|--output|--config|--resume) files; return ;;\n"
           "        " +
           values_taking(texts) +
           ") return ;;\n"
           "    esac\n"
           "    case $current in -*) choose \"$(_rtuwire_options_of \"$command\")\"; return ;; esac\n"
           "    if [ -z \"$command\" ]; then choose '" +
           names_of_commands(texts) +
           "'; return; fi\n"
           "    case $(_rtuwire_operands_of \"$command\") in\n"
           "        registers) choose \"$(_rtuwire_registers_of \"$drive\")\" ;;\n"
           "        settings) settings \"$(_rtuwire_registers_of \"$drive\")\" ;;\n"
           "        drives) choose \"" +
           drives() +
           "\" ;;\n"
           "        shells) choose 'bash zsh' ;;\n"
           "        files) files ;;\n"
           "    esac\n";
}

std::string for_bash(tool_texts const& texts)
{
    return "# Completion of rtuwire " + texts.version + " for bash; made by: rtuwire completion bash\n" +
           word_lists(texts) +
           "_rtuwire() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} seen=(\"${COMP_WORDS[@]:1:COMP_CWORD-1}\")\n" +
           walk(texts, "\"${seen[@]}\"") +
           "    choose() { COMPREPLY=($(compgen -W \"$1\" -- \"$current\")); }\n"
           "    files() { COMPREPLY=($(compgen -f -- \"$current\")); }\n"
           "    settings() { COMPREPLY=($(compgen -S = -W \"${1//@*/}\" -- \"$current\")); compopt -o nospace "
           "2>/dev/null; }\n"
           "    COMPREPLY=()\n" +
           choices_of_words(texts) +
           "}\n"
           "complete -F _rtuwire rtuwire\n";
}

std::string for_zsh(tool_texts const& texts)
{
    return "#compdef rtuwire\n# Completion of rtuwire " + texts.version +
           " for zsh; made by: rtuwire completion zsh\n" + word_lists(texts) +
           "_rtuwire() {\n"
           "    local current=${words[CURRENT]}\n"
           "    local -a seen; seen=(\"${(@)words[2,CURRENT-1]}\")\n" +
           walk(texts, "\"${seen[@]}\"") +
           "    choose() { compadd -- ${=1}; }\n"
           "    files() { _files; }\n"
           "    settings() { compadd -S = -- ${=${1%%@*}}; }\n" +
           choices_of_words(texts) +
           "}\n"
           "if [ \"$funcstack[1]\" = _rtuwire ]; then _rtuwire \"$@\"; else compdef _rtuwire rtuwire; fi\n";
}

} // namespace

std::string completion_script(tool_texts const& texts, std::string const& shell)
{
    if (shell == "bash") {
        return for_bash(texts);
    }
    return shell == "zsh" ? for_zsh(texts) : std::string{};
}

} // namespace tool

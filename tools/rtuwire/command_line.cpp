// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "command_line.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>

#include "../support/platform.hpp"
#include "command_words.hpp"
#include "commands/commands.hpp"
#include "configuration.hpp"
#include "device/register_file.hpp"
#include "help/tool_texts.hpp"
#include "line/line_words.hpp"
#include "output/plain_text.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

option_text text_of(CLI::Option const& option)
{
    option_text text{{}, option.get_description(), option.get_items_expected_max() > 0};
    for (std::string const& each : option.get_snames()) {
        text.names.push_back("-" + each);
    }
    for (std::string const& each : option.get_lnames()) {
        text.names.push_back("--" + each);
    }
    return text;
}

command_text text_of(CLI::App const& command)
{
    command_text text{
        .name = command.get_name(), .what = command.get_description(), .example = example_of(command.get_name())};
    for (CLI::Option const* const each : command.get_options()) {
        if (each->get_positional()) {
            text.operand = each->get_name(true);
            text.operand_what = each->get_description();
        } else {
            text.options.push_back(text_of(*each));
        }
    }
    return text;
}

tool_texts texts_of(CLI::App const& app)
{
    tool_texts texts{app.get_description(), RTUWIRE_TOOL_VERSION, {}, {}};
    for (CLI::Option const* const each : app.get_options()) {
        texts.options.push_back(text_of(*each));
    }
    for (CLI::App const* const each : app.get_subcommands({})) {
        texts.commands.push_back(text_of(*each));
    }
    return texts;
}

exit_status print(std::string const& text)
{
    bool const is_printed =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() and std::fflush(stdout) == 0;
    if (not is_printed) {
        std::perror("rtuwire: standard output");
    }
    return is_printed ? exit_status::done : exit_status::port;
}

exit_status print_own_text(CLI::App const& app, choices const& chosen)
{
    if (chosen.command == "man") {
        return print(man_page(texts_of(app)));
    }
    std::string const& shell = chosen.words.front();
    std::string const script = completion_script(texts_of(app), shell);
    if (script.empty() or chosen.words.size() > 1) {
        refuse_word("there is no completion for '" + chosen.words.back() + "': say bash or zsh");
    }
    return print(script);
}

/// The file that --config names, or the one that is there without it. Read before the command line, which overrides it.
std::optional<std::string> configuration_among(int argc, char** argv)
{
    std::string_view const flag = "--config";
    for (int i = 1; i < argc; ++i) {
        std::string_view const word = argv[i];
        if (word == flag and i + 1 < argc) {
            return argv[i + 1];
        }
        if (word.starts_with(flag) and word.substr(flag.size()).starts_with('=')) {
            return std::string{word.substr(flag.size() + 1)};
        }
    }
    return configuration_file();
}

/// Why the configuration is refused; empty where it is not. Help is shown all the same.
std::string configure(int argc, char** argv, line_choices& line)
{
    try {
        if (auto const file = configuration_among(argc, argv)) {
            read_configuration(*file, line);
        }
    } catch (ended const& why) {
        line = {}; // nothing of a file that is wrong
        return why.what();
    }
    return {};
}

/// A file that is wrong keeps no stop from a motor whose line and address are typed; another command ends there.
void leave_out_configuration(CLI::App const& app, choices const& chosen, std::string const& wrong)
{
    bool const is_typed = app.get_option("--port")->count() > 0 and app.get_option("--unit")->count() > 0;
    if (chosen.command != "stop" or not is_typed) {
        refuse_word(wrong + (chosen.command == "stop" ? "; with --port and --unit it stops without the file" : ""));
    }
    std::fprintf(stderr, "note: %s; the file is left out: it stops at %u bit/s, %s\n", plain_text(wrong).c_str(),
                 chosen.line.baud, chosen.line.format.c_str());
}

/// An option as it was typed: " -p /dev/ttyUSB0"; empty where it was not.
std::string typed_text(CLI::Option const& option)
{
    if (option.count() == 0) {
        return {};
    }
    std::string const name =
        option.get_snames().empty() ? " --" + option.get_lnames().front() : " -" + option.get_snames().front();
    std::string text;
    for (std::string const& each : option.results()) {
        text += name + (option.get_items_expected_max() > 0 ? ' ' + quoted(each) : std::string{});
    }
    return text;
}

/// What says which line, and who is on it: neither what allows something, nor the form of the output.
typed_line typed_in(CLI::App const& app, std::string_view program)
{
    constexpr std::string_view others[] = {"help",      "version", "json",    "csv",  "write",
                                           "allow-run", "yes",     "verbose", "trace"};
    typed_line typed;
    if (program.find_first_of("/\\") != std::string_view::npos) { // it may not stand where a shell looks for it
        typed.program = quoted(std::string{program});
    }
    for (CLI::Option const* const each : app.get_options()) {
        std::string const& name = each->get_lnames().front();
        std::string& place = name == "unit"                       ? typed.unit
                             : name == "drive"                    ? typed.drive
                             : name == "baud" or name == "format" ? typed.rate
                                                                  : typed.options;
        place += std::ranges::count(others, name) == 0 ? typed_text(*each) : std::string{};
    }
    for (CLI::App const* const each : app.get_subcommands()) {
        CLI::Option const* const port = each->get_option_no_throw("PORT"); // of a scan
        if (port != nullptr and port->count() > 0) {
            typed.options += " -p " + quoted(port->as<std::string>());
        }
    }
    return typed;
}

bool is_one_file(std::string const& one, std::string const& other)
{
    std::error_code ignored;
    auto const place = [&ignored](std::string const& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
    };
    return not one.empty() and not other.empty() and place(one) == place(other);
}

/// Names of the command line stand beside those of the file, and in the place of the same name there; nothing is served
/// on the port of the file.
void mend(CLI::App const& app, choices& chosen, line_choices const& of_file)
{
    line_choices& line = chosen.line;
    if (app.get_option("--name")->count() > 0) {
        std::vector<named_unit> const typed = names_in(line);
        std::vector<named_unit> const kept = names_in(of_file);
        for (std::size_t i = kept.size(); i-- > 0;) {
            if (not std::ranges::count(typed, kept[i].name, &named_unit::name)) {
                line.names.insert(line.names.begin(), of_file.names[i]);
            }
        }
    }
    static_cast<void>(names_in(line)); // refuses what is wrong together
    constexpr std::string_view asking[] = {"read", "watch", "identify"};
    if (line.may_be_any_unit and std::ranges::count(asking, chosen.command) == 0) {
        refuse_word("--any-unit is for read, watch and identify: at 0 and 248 to 255 whatever hangs on the line may "
                    "answer, and "
                    "nothing is changed there");
    }
    if (chosen.command == "simulate" and (line.is_verbose or not line.trace_file.empty())) {
        refuse_word(std::string{line.is_verbose ? "-v" : "--trace"} +
                    ": simulate shows no frames; the command that asks its drives does, with the same option");
    }
    for (std::string const& each : {chosen.file, chosen.scan.resume_file}) {
        if (is_one_file(line.trace_file, each)) {
            refuse_word("--trace " + line.trace_file + ": " + each + " is another file of this command already");
        }
    }
    auto const is_typed = [&app](char const* name) { return app.get_option(name)->count() > 0; };
    line.is_unit_named = line.is_unit_named or is_typed("--unit");
    line.is_rate_named = line.is_rate_named or is_typed("--baud") or is_typed("--format");
    bool const is_served = chosen.command == "simulate" or chosen.check.is_client;
    if (is_served and app.get_option("--port")->count() == 0) {
        line.port.clear();
    }
}

std::vector<std::string_view> commands_of(CLI::App const& app)
{
    std::vector<std::string_view> names;
    for (CLI::App const* const each : app.get_subcommands({})) {
        names.emplace_back(each->get_name());
    }
    return names;
}

std::vector<std::string> options_of(CLI::App const& app)
{
    std::vector<std::string> names;
    for (CLI::Option const* const each : app.get_options()) {
        for (std::string const& name : each->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    for (CLI::App const* const each : app.get_subcommands()) {
        std::vector<std::string> const own = options_of(*each);
        names.insert(names.end(), own.begin(), own.end());
    }
    return names;
}

bool looks_like_port(std::string const& word)
{
    return word.starts_with("sim:") or word.starts_with("tcp://") or word.starts_with("mbap://") or
           word.starts_with("/dev/") or is_port_name(word);
}

/// What is wrong with the first word that nothing took; empty where none was left.
std::string wrong_word(CLI::App const& app)
{
    bool const has_command = not app.get_subcommands().empty();
    std::vector<std::string> const options = options_of(app);
    for (std::string const& word : app.remaining(true)) {
        if (word == "--") { // what stands behind it is no option
            break;
        }
        bool const is_option = word.starts_with('-');
        bool const is_of_command = has_command and std::ranges::find(options, word) != options.end();
        if (is_of_command) { // and stands in front of it
            return "'" + word + "' belongs behind '" + app.get_subcommands().front()->get_name() + "'";
        }
        if (is_option) {
            return "'" + word + "' is no option" +
                   suggestion(word, std::vector<std::string_view>{options.begin(), options.end()});
        }
        if (has_command and looks_like_port(word)) {
            return "'" + app.get_subcommands().front()->get_name() + "' takes no word '" + word +
                   "'; did you mean -p " + word + "?";
        }
        if (not has_command) {
            return "'" + word + "' is no command" +
                   (word == "help" ? "; `--help` names them" : suggestion(word, commands_of(app)));
        }
    }
    return {};
}

/// Shows help or the version, once all of the output has taken it.
exit_status show(CLI::App const& app, CLI::ParseError const& what)
{
    std::ostringstream text;
    app.exit(what, text);
    return print(with_own_words(text.str()));
}

/// The whole command, behind the complaint that something is missing; empty behind another.
std::string what_is_missing(CLI::App const& app, CLI::ParseError const& why)
{
    if (dynamic_cast<CLI::RequiredError const*>(&why) == nullptr) {
        return {};
    }
    auto const asked = app.get_subcommands();
    if (asked.empty()) {
        return "; `--help` names them";
    }
    std::string const name = asked.front()->get_name();
    return "; such as `" + example_of(name) + "`; `" + name + " --help` says more";
}

exit_status refuse(CLI::App const& app, CLI::ParseError const& why)
{
    std::string const word = wrong_word(app);
    std::string const text = word.empty() ? why.what() + what_is_missing(app, why) : word;
    tell_error(text);
    return exit_status::usage;
}

/// "read, watch, ... and simulate".
std::string commands_with_files()
{
    std::string text;
    for (command const& each : commands) {
        if (each.files == file_use::names) {
            text += (text.empty() ? "" : ", ") + std::string{each.name};
        }
    }
    for (command const& each : commands) {
        text += each.files == file_use::served ? " and " + std::string{each.name} : "";
    }
    return text;
}

/// Before anything is opened. The longest pause that one of them wants is that of the line, unless one is typed.
void read_register_files(choices& chosen, bool has_pause)
{
    line_choices& line = chosen.line;
    command const* const asked = command_named(chosen.command);
    bool const knows_names = asked != nullptr and asked->files == file_use::names;
    line.knows_registers = knows_names;
    if (not line.device.empty() and not knows_names) {
        std::string const list =
            chosen.command == "list" ? "; `device check " + line.device + "` lists its registers" : "";
        refuse_word("--device: " + commands_with_files() + " know register files, '" + chosen.command + "' does not" +
                    list);
    }
    std::vector<std::string> files;
    for (named_unit const& each : knows_names ? names_in(line) : std::vector<named_unit>{}) {
        files.push_back(is_register_file(each.drive) ? each.drive : std::string{});
    }
    files.push_back(line.device);
    std::optional<unsigned> pause;
    for (std::string const& each : files) {
        if (not each.empty()) {
            pause = std::max(pause, register_file_at(each).pause);
        }
    }
    line.pause = has_pause ? line.pause : pause.value_or(line.pause);
}

/// "--units=": CLI11 would take the next word for its value. A configuration without a name has words of its own.
std::optional<std::string> word_without_value(int argc, char** argv)
{
    for (int i = 1; i < argc and argv[i] != std::string_view{"--"}; ++i) {
        std::string_view const word = argv[i];
        if (word.starts_with("--") and word.find('=') + 1 == word.size() and word != "--config=") {
            return std::string{word};
        }
    }
    return std::nullopt;
}

} // namespace

parsed parse(int argc, char** argv)
{
    if (auto const word = word_without_value(argc, argv)) {
        refuse_word("'" + *word + "': no value stands behind it; say one, or leave the option out");
    }
    choices chosen;
    std::string const wrong = configure(argc, argv, chosen.line);
    line_choices const of_file = chosen.line;
    CLI::App app{"Modbus RTU lines and Altivar drives: find, read, write, watch, run, capture.\n"
                 "It reads unless --write or --allow-run says otherwise.",
                 "rtuwire"};
    app.set_version_flag("-V,--version", RTUWIRE_TOOL_VERSION);
    std::string ignored; // read already
    app.add_option(
        "--config", ignored,
        "a file with what is said each time: port, unit, baud, format, drive, name, timeout, retries, pause,\n"
        "echo, rs485, listen, such as port = \"/dev/ttyUSB0\" and name = [\"fan=7:atv320\"];\n"
        "without it ./rtuwire.toml, then " TOOL_CONFIGURATION);
    add_words(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (CLI::CallForHelp const& why) {
        return {std::nullopt, show(app, why)};
    } catch (CLI::CallForVersion const& why) {
        return {std::nullopt, show(app, why)};
    } catch (CLI::ParseError const& why) {
        return {std::nullopt, refuse(app, why)};
    }
    if (not wrong.empty()) {
        leave_out_configuration(app, chosen, wrong);
    }
    mend(app, chosen, of_file);
    if (chosen.command == "simulate" and not chosen.line.device.empty()) { // the device itself
        std::string const device = std::exchange(chosen.line.device, {});
        bool const has_unit = device.rfind(".toml:") != device.npos;
        chosen.words.push_back(has_unit ? device : device + ':' + std::to_string(unit_in(chosen.line).unit.byte()));
    }
    read_register_files(chosen, app.get_option("--pause")->count() > 0);
    chosen.line.typed = typed_in(app, argc > 0 ? argv[0] : "");
    if (chosen.command == "serve") { // one unit is named nowhere there, and no motor runs
        chosen.line.typed.form = option_form::of_serve;
        chosen.allowed.knows_run = false;
    }
    for (std::string const& each : chosen.words) {
        chosen.line.typed.stray_port = looks_like_port(each) ? each : chosen.line.typed.stray_port;
    }
    if (chosen.command == "completion" or chosen.command == "man") {
        return {std::nullopt, print_own_text(app, chosen)};
    }
    return {chosen, exit_status::done};
}

} // namespace tool

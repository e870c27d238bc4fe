// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "import/import.hpp"

#include <algorithm>

#include "exit_status.hpp"
#include "import/forms.hpp"

namespace tool {

namespace {

constexpr std::string_view imported_forms =
    "a template of wb-mqtt-serial, modbus: of Home Assistant, modbus_controller of "
    "ESPHome, inputs.modbus of Telegraf, or a model of SunSpec";

/// What stands first behind blanks and comments.
char first_sign(std::string_view text)
{
    while (not text.empty()) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        bool const is_line = text.starts_with("//") or text.starts_with('#');
        if (text.starts_with("/*")) {
            std::size_t const end = text.find("*/");
            text.remove_prefix(end == text.npos ? text.size() : end + 2);
        } else if (is_line) {
            text.remove_prefix(std::min(text.find('\n'), text.size()));
        } else {
            break;
        }
    }
    return text.empty() ? '\0' : text[0];
}

/// Whether a line is the head of a plugin of Telegraf.
bool has_plugin(std::string_view text)
{
    for (std::size_t at = text.find("inputs.modbus"); at != text.npos; at = text.find("inputs.modbus", at + 1)) {
        std::size_t const line = text.rfind('\n', at);
        std::string_view const before =
            text.substr(line == text.npos ? 0 : line + 1, at - (line == text.npos ? 0 : line + 1));
        if (before.find('[') != before.npos and before.find_first_not_of(" \t[") == before.npos) {
            return true;
        }
    }
    return false;
}

void import_from(std::string const& text, import_choices const& how, register_file_writer& into)
{
    bool const is_json = first_sign(text) == '{';
    bool const is_toml = not is_json and has_plugin(text);
    source_value const read = is_json   ? json_source(into.file(), text)
                              : is_toml ? toml_source(into.file(), text)
                                        : yaml_source(into.file(), text);
    static_cast<void>(has_names_twice(into, read));
    if (not is_json) {
        refuse_base(into, how.base);
    }
    if (is_json and is_wirenboard(read)) {
        import_wirenboard(read, how.base, into);
    } else if (is_json and is_sunspec(read)) {
        import_sunspec(read, how.base, into);
    } else if (is_toml and is_telegraf(read)) {
        import_telegraf(read, into);
    } else if (not is_json and is_esphome(read)) {
        import_esphome(read, into);
    } else if (not is_json and is_home_assistant(read)) {
        import_home_assistant(read, into);
    } else {
        refuse_word(into.file() + ": this is none of the files that are imported: " + std::string{imported_forms});
    }
}

} // namespace

register_file_writer import_file(std::string const& file, std::string const& text, import_choices const& how)
{
    if (text.size() > most_source_bytes) {
        refuse_word(file + ": " + std::to_string(text.size()) + " bytes; a file that is imported has at most " +
                    std::to_string(most_source_bytes));
    }
    if (std::size_t const zero = text.find('\0'); zero != text.npos) {
        refuse_word(told_place(file, place_counter{text}.of(zero)) + "a byte is zero: it is no text");
    }
    register_file_writer device{file, how.unit};
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    import_from(text.starts_with(mark) ? text.substr(mark.size()) : text, how, device);
    return device;
}

} // namespace tool

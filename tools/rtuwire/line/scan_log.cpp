// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The file: "19200 8E1 7" for a silent address; behind it a tabulator and name=value, separated by tabulators, for one
// that responded.
#include "line/scan_log.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "exit_status.hpp"

namespace tool {

namespace {

constexpr char const* heading = "# rtuwire scan";

std::string key_of(line_setting const& how, std::uint8_t unit)
{
    return std::to_string(how.baud) + ' ' + name_of_format(how.format) + ' ' + std::to_string(unit);
}

cell cell_of(std::string const& name, std::string const& word)
{
    bool const is_number = name == "unit" or name == "baud";
    return is_number ? cell{std::int64_t{std::atoll(word.c_str())}} : cell{word};
}

/// A tabulator or a line's end in a text would break the file.
std::string plain(std::string text)
{
    std::ranges::replace_if(
        text, [](unsigned char each) { return each < ' '; }, ' ');
    return text;
}

} // namespace

std::string name_of_format(rtuwire::character_format format)
{
    using rtuwire::character_format;
    switch (format) {
    case character_format::even_8_1: return "8E1";
    case character_format::odd_8_1: return "8O1";
    case character_format::none_8_1: return "8N1";
    case character_format::none_8_2: return "8N2";
    }
    return {};
}

scan_log::scan_log(std::string const& file) : file_{file}
{
    if (file.empty()) {
        return;
    }
    std::ifstream in{file};
    std::string line;
    if (std::getline(in, line) and line != heading) {
        refuse_word("--resume " + file + ": this is no file of a scan; it is left as it is");
    }
    while (std::getline(in, line)) {
        std::istringstream parts{line};
        std::string key;
        std::getline(parts, key, '\t');
        done_.insert(key);
        record found;
        for (std::string part; std::getline(parts, part, '\t');) {
            std::size_t const sign = part.find('=');
            if (sign == std::string::npos) {
                refuse_word("--resume " + file + ": this line is not of a scan: " + line);
            }
            std::string const name = part.substr(0, sign);
            found.add(name, cell_of(name, part.substr(sign + 1)));
        }
        if (not found.fields().empty()) {
            found_.push_back(found);
        }
    }
    out_.open(file, std::ios::app);
    if (out_.tellp() == 0) {
        write(heading);
    }
}

bool scan_log::is_done(line_setting const& how, std::uint8_t unit) const { return done_.contains(key_of(how, unit)); }

void scan_log::note_silent(line_setting const& how, std::uint8_t unit) { write(key_of(how, unit)); }

void scan_log::note_found(line_setting const& how, std::uint8_t unit, record const& line)
{
    std::string text = key_of(how, unit);
    for (field const& each : line.fields()) {
        text += '\t' + each.name + '=' + plain(text_of_cell(each.value));
    }
    write(text);
}

void scan_log::write(std::string const& line)
{
    if (file_.empty()) {
        return;
    }
    out_ << line << '\n' << std::flush;
    if (not out_) {
        throw ended{exit_status::port, file_ + ": " + std::strerror(errno)};
    }
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The file:
//     # rtuwire map
//     # line 19200 8E1
//     # unit 61
//     # device Acme M7 1.2
//     # range input:0-1999
//     61 input 1000 1011 here
//     61 input 0 999 none
//     61 holding 7 7 other server device failure
#include "line/map_log.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "exit_status.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

constexpr std::string_view first_line = "# rtuwire map";
constexpr std::string_view head_words[]{"# line ", "# unit ", "# device ", "# range "};
constexpr std::size_t addresses = 65'536;
constexpr std::string_view kinds[]{"unknown", "here", "none", "other"};

std::vector<std::string> lines_of(map_head const& head)
{
    std::vector<std::string> lines;
    for (std::string const* const each : {&head.line, &head.unit, &head.device, &head.range}) {
        lines.push_back(std::string{head_words[lines.size()]} + plain_text(*each));
    }
    return lines;
}

std::size_t index_of(register_space space) { return static_cast<std::size_t>(space); }

} // namespace

map_log::map_log(std::string const& file, unsigned unit) : file_{file}, unit_{unit}
{
    if (file.empty()) {
        return;
    }
    read(text_to_resume(file));
    out_ = appended_file{file};
    if (not out_.failure().empty()) {
        throw ended{exit_status::port, file + ": " + out_.failure()};
    }
}

void map_log::begin(map_head const& head)
{
    std::vector<std::string> const now = lines_of(head);
    for (std::size_t i = 0; i < kept_head_.size(); ++i) {
        if (kept_head_[i] != now[i]) {
            refuse_word("--resume " + file_ + ':' + std::to_string(i + 2) + ": the map was begun with '" +
                        kept_head_[i].substr(2) + "', and this is '" + now[i].substr(2) +
                        "': its rows would be those of something else; name another file");
        }
    }
    if (kept_head_.empty()) {
        new_head_ = std::string{first_line} + '\n';
        for (std::string const& each : now) {
            new_head_ += each + '\n';
        }
    }
}

/// Believes the file as a whole or not at all: a line that was cut short would hide addresses that are there.
void map_log::read(std::string const& text)
{
    constexpr unsigned lines_of_head = 1 + std::size(head_words);
    std::istringstream in{text};
    std::string line;
    unsigned number = 1;
    for (; std::getline(in, line); ++number) {
        bool const is_whole = not in.eof();
        bool const is_of_head =
            number <= lines_of_head and
            (number == 1 ? line == first_line : line.starts_with(head_words[std::min(number, lines_of_head) - 2]));
        if (number <= lines_of_head and not(is_of_head and is_whole)) {
            refuse_no_map();
        }
        if (number > 1 and number <= lines_of_head) {
            kept_head_.push_back(line);
        }
        if (number > lines_of_head and (not is_whole or not read_line(line))) {
            refuse_word(
                "--resume " + file_ + ":" + std::to_string(number) + ": '" + line +
                "' is no line of a map, is not whole, or contradicts another; the file is left as it is: mend or "
                "remove the line");
        }
    }
    if (number > 1 and number <= lines_of_head) {
        refuse_no_map();
    }
}

void map_log::refuse_no_map() const
{
    refuse_word("--resume " + file_ + ": this is no file of a map, or its head is not whole; it is left as it is");
}

bool map_log::read_line(std::string const& line)
{
    std::istringstream in{line};
    unsigned unit = 0;
    unsigned first = 0;
    unsigned last = 0;
    std::string space;
    std::string what;
    in >> unit >> space >> first >> last >> what;
    std::string why;
    std::getline(in, why);
    why.erase(0, why.starts_with(' ') ? 1 : 0);
    auto const kind = std::ranges::find(kinds, what) - std::begin(kinds);
    register_space where = register_space::holding;
    while (name_of(where) != space and where != register_space::discrete) {
        where = static_cast<register_space>(static_cast<unsigned>(where) + 1);
    }
    bool const is_right = not in.bad() and kept_head_[1] == std::string{head_words[1]} + std::to_string(unit) and
                          name_of(where) == space and first <= last and last < addresses and kind > 0 and kind < 4 and
                          (kind == 3) != why.empty();
    std::string const again = std::to_string(unit) + ' ' + space + ' ' + std::to_string(first) + ' ' +
                              std::to_string(last) + ' ' + what + (why.empty() ? "" : ' ' + why);
    if (not is_right or again != line) {
        return false;
    }
    if (unit != unit_) { // `begin` refuses it
        return true;
    }
    for (unsigned each = first; each <= last; ++each) {
        if (at(where, each).what != found_address::kind::unknown) {
            return false;
        }
    }
    keep(where, first, last, {static_cast<found_address::kind>(kind), why});
    return true;
}

found_address map_log::at(register_space space, unsigned address) const
{
    auto const& all = found_[index_of(space)];
    return all.empty() ? found_address{} : kinds_[all[address]];
}

void map_log::keep(register_space space, unsigned first, unsigned last, found_address const& found)
{
    auto const known = std::ranges::find(kinds_, found);
    auto const which = static_cast<std::uint16_t>(known - kinds_.begin());
    if (known == kinds_.end()) {
        kinds_.push_back(found);
    }
    auto& all = found_[index_of(space)];
    all.resize(addresses);
    std::fill(all.begin() + first, all.begin() + last + 1, which);
}

void map_log::note(register_space space, unsigned first, unsigned last, found_address const& found)
{
    found_address const plain{found.what, plain_text(found.why)};
    keep(space, first, last, plain);
    write(std::to_string(unit_) + ' ' + std::string{name_of(space)} + ' ' + std::to_string(first) + ' ' +
          std::to_string(last) + ' ' + std::string{kinds[static_cast<std::size_t>(plain.what)]} +
          (plain.why.empty() ? "" : ' ' + plain.why));
}

void map_log::write(std::string const& line)
{
    if (file_.empty()) {
        return;
    }
    out_.write(std::exchange(new_head_, {}) + line + '\n');
    if (not out_.failure().empty()) {
        throw ended{exit_status::port, file_ + ": " + out_.failure()};
    }
}

} // namespace tool

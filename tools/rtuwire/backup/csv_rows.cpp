// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// As RFC 4180 has it: what stands in quotes may have line ends and separators in it, and a quote twice is one. Spaces around
// a field are none of it.
#include <algorithm>
#include <array>

#include "backup/saved_text.hpp"

namespace tool {

namespace {

/// The one of the separators that the first line has most of, outside of quotes.
char separator_of(std::string_view line)
{
    constexpr std::string_view separators = ",;\t";
    std::array<std::size_t, separators.size()> counts{};
    bool is_quoted = false;
    for (char const each : line) {
        is_quoted = is_quoted != (each == '"');
        if (std::size_t const which = separators.find(each); not is_quoted and which != separators.npos) {
            ++counts[which];
        }
    }
    return separators[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
}

/// Makes rows of fields, each with its place.
class table_reader {
public:
    table_reader(std::string_view text, saved_text& found) : text_{text}, places_{text}, found_{found}
    {
        separator_ = separator_of(text.substr(0, text.find_first_of("\r\n")));
    }

    void read()
    {
        for (skip(" \t\r\n"); not has_ended(); skip(" \t\r\n")) {
            take_field();
            while (not has_ended() and text_[at_] == separator_) {
                ++at_;
                take_field();
            }
            end_row();
        }
        if (not found_.fault and names_.empty()) {
            refuse({}, "there is nothing in it");
        }
    }

private:
    [[nodiscard]] bool has_ended() const { return at_ == text_.size() or found_.fault; }

    /// Passes these, but never what separates fields.
    void skip(std::string_view these)
    {
        while (at_ < text_.size() and text_[at_] != separator_ and these.find(text_[at_]) != these.npos) {
            ++at_;
        }
    }

    void take_field()
    {
        std::size_t const begin = at_;
        skip(" \t");
        std::string field = at_ < text_.size() and text_[at_] == '"' ? quoted(begin) : bare();
        if (not found_.fault) {
            row_.push_back({std::move(field), places_.of(begin)});
        }
    }

    /// Up to a separator or the end of the line.
    std::string bare()
    {
        std::size_t const begin = at_;
        while (not is_at_end_of_field() and text_[at_] != '"') {
            ++at_;
        }
        expect_end_of_field();
        std::string_view const field = text_.substr(begin, at_ - begin);
        return std::string{field.substr(0, field.find_last_not_of(" \t") + 1)};
    }

    /// What stands in quotes, from the first of them on.
    std::string quoted(std::size_t begin)
    {
        std::string field;
        for (;;) {
            std::size_t const end = text_.find('"', at_ + 1);
            if (end == text_.npos) {
                refuse_quote(begin);
                return field;
            }
            field += text_.substr(at_ + 1, end - at_ - 1);
            at_ = end + 1;
            if (at_ == text_.size() or text_[at_] != '"') {
                break;
            }
            field += '"';
        }
        skip(" \t");
        expect_end_of_field();
        return field;
    }

    [[nodiscard]] bool is_at_end_of_field() const
    {
        return at_ == text_.size() or text_[at_] == separator_ or text_[at_] == '\r' or text_[at_] == '\n';
    }

    void expect_end_of_field()
    {
        if (not is_at_end_of_field()) {
            refuse_quote(at_);
        }
    }

    void refuse_quote(std::size_t byte) { refuse(places_.of(byte), "a quote does not belong here, or has no end"); }

    void end_row()
    {
        std::vector<placed_text> const row = std::move(row_);
        row_.clear();
        if (found_.fault or row.empty()) {
            return;
        }
        if (names_.empty()) {
            take_names(row);
        } else {
            take_row(row);
        }
    }

    void take_names(std::vector<placed_text> const& row)
    {
        for (placed_text const& each : row) {
            if (not is_row_field(each.text)) {
                return refuse(each.place, "'" + each.text +
                                              "' is no column of a backup: group, address, register, raw, value, unit, "
                                              "name, error");
            }
            if (std::ranges::count(names_, each.text) > 0) {
                return refuse(each.place, "'" + each.text + "' stands here a second time");
            }
            names_.push_back(each.text);
        }
        if (std::ranges::count(names_, "register") == 0) {
            refuse(row.front().place, "no column is called 'register'");
        }
    }

    void take_row(std::vector<placed_text> const& row)
    {
        if (row.size() != names_.size()) {
            return refuse(row.front().place, "there are " + std::to_string(row.size()) + " fields in this line, and " +
                                                 std::to_string(names_.size()) + " columns");
        }
        saved_row made{row.front().place, {}};
        for (std::size_t i = 0; i < row.size(); ++i) {
            made.fields.emplace(names_[i], row[i]);
        }
        placed_text const* const group = made.find("group");
        placed_text const* const name = made.find("register");
        if (group == nullptr or group->text != "backup" or name == nullptr) {
            found_.rows.push_back(std::move(made));
        } else if (placed_text const* const value = made.find("value"); value != nullptr) {
            if (not found_.head.emplace(name->text, *value).second) {
                refuse(name->place, "'" + name->text + "' of the backup stands here a second time");
            }
        }
    }

    void refuse(text_place place, std::string sentence)
    {
        if (not found_.fault) {
            found_.fault = file_fault{place, std::move(sentence)};
        }
    }

    std::string_view text_;
    char separator_{','};
    place_counter places_;
    saved_text& found_;
    std::size_t at_{0};
    std::vector<placed_text> row_{};
    std::vector<std::string> names_{};
};

} // namespace

saved_text read_csv_rows(std::string_view text)
{
    saved_text found;
    std::string_view const mark = "\xEF\xBB\xBF";
    table_reader{text.starts_with(mark) ? text.substr(mark.size()) : text, found}.read();
    return found;
}

} // namespace tool

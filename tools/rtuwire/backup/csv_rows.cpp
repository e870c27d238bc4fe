// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// libcsv reads the text; one byte at a time, so that each field has its place.
#include <algorithm>
#include <array>
#include <memory>

#include <csv.h>

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

/// Makes rows of the fields that the parser tells.
class table_reader {
public:
    table_reader(std::string_view text, saved_text& found) : text_{text}, places_{text}, found_{found} {}

    void read()
    {
        csv_set_delim(&parser_, static_cast<unsigned char>(separator_of(text_.substr(0, text_.find_first_of("\r\n")))));
        for (at_ = 0; at_ < text_.size() and not found_.fault; ++at_) {
            if (csv_parse(&parser_, &text_[at_], 1, on_field, on_row, this) != 1) {
                fail(at_);
            }
        }
        if (not found_.fault and csv_fini(&parser_, on_field, on_row, this) != 0) {
            fail(begin_);
        }
        if (not found_.fault and names_.empty()) {
            refuse({}, "there is nothing in it");
        }
    }

private:
    struct parser : csv_parser {
        parser() { csv_init(this, CSV_STRICT | CSV_STRICT_FINI); }
        parser(parser const&) = delete;
        parser& operator=(parser const&) = delete;
        ~parser() { csv_free(this); }
    };

    static void on_field(void* data, std::size_t size, void* self)
    {
        static_cast<table_reader*>(self)->take({static_cast<char const*>(data), data == nullptr ? 0 : size});
    }
    static void on_row(int, void* self) { static_cast<table_reader*>(self)->end_row(); }

    void take(std::string_view text)
    {
        // Line ends before a row are none of its first field.
        while (row_.empty() and begin_ < at_ and (text_[begin_] == '\r' or text_[begin_] == '\n')) {
            ++begin_;
        }
        row_.push_back({std::string{text}, places_.of(begin_)});
        begin_ = at_ + 1;
    }

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

    void fail(std::size_t byte)
    {
        refuse(places_.of(byte), csv_error(&parser_) == CSV_EPARSE ? "a quote does not belong here, or has no end"
                                                                   : csv_strerror(csv_error(&parser_)));
    }

    void refuse(text_place place, std::string sentence)
    {
        if (not found_.fault) {
            found_.fault = file_fault{place, std::move(sentence)};
        }
    }

    std::string_view text_;
    place_counter places_;
    saved_text& found_;
    parser parser_{};
    std::size_t at_{0};
    std::size_t begin_{0}; ///< of the field that is read
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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A table for people: columns as wide as their widest word, numbers to the right.
#include <algorithm>
#include <vector>

#include "output/output.hpp"
#include "output/plain_text.hpp"
#include "output/width.hpp"

namespace tool {

namespace {

bool is_number(cell const& value)
{
    return std::holds_alternative<std::int64_t>(value) or std::holds_alternative<std::uint64_t>(value) or
           std::holds_alternative<double>(value);
}

std::string shown(cell const& value) { return plain_text(text_of_cell(value)); }

class table : public form {
public:
    explicit table(bool is_stream) : is_stream_{is_stream} {}

    std::string text_of(record const& line) override
    {
        bool const is_new = not has_same_names(line);
        std::string text = is_new ? rest() : std::string{};
        if (is_new) {
            begin(line);
        }
        waiting_.push_back(line);
        return is_stream_ ? text + rest() : text;
    }

    std::string rest() override
    {
        for (record const& line : waiting_) {
            widen(line);
        }
        std::string text;
        if (not waiting_.empty() and not has_header_) {
            text = header(waiting_.front());
            has_header_ = true;
        }
        for (record const& line : waiting_) {
            text += row(line);
        }
        waiting_.clear();
        return text;
    }

private:
    bool has_same_names(record const& line) const
    {
        return std::ranges::equal(line.fields(), names_, {}, &field::name);
    }

    void begin(record const& line)
    {
        names_.clear();
        widths_.clear();
        has_header_ = false;
        for (field const& each : line.fields()) {
            names_.push_back(each.name);
            widths_.push_back(width_of(each.name));
        }
    }

    void widen(record const& line)
    {
        for (std::size_t i = 0; i < widths_.size(); ++i) {
            widths_[i] = std::max(widths_[i], width_of(shown(line.fields()[i].value)));
        }
    }

    std::string header(record const& like) const
    {
        record names;
        for (field const& each : like.fields()) {
            names.add(each.name, each.name);
        }
        return row(names);
    }

    std::string row(record const& line) const
    {
        std::string text;
        for (std::size_t i = 0; i < widths_.size(); ++i) {
            cell const& value = line.fields()[i].value;
            std::string const word = shown(value);
            std::string const space(widths_[i] - width_of(word), ' ');
            text += i == 0 ? "" : "  ";
            text += is_number(value) ? space + word : word + space;
        }
        return text.erase(text.find_last_not_of(' ') + 1) + '\n';
    }

    bool is_stream_;
    bool has_header_{false};
    std::vector<std::string> names_{};
    std::vector<std::size_t> widths_{};
    std::vector<record> waiting_{};
};

} // namespace

std::unique_ptr<form> make_table(bool is_stream) { return std::make_unique<table>(is_stream); }

} // namespace tool

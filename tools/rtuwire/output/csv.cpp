// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Comma-separated values (RFC 4180, but for the line's end); a line of names where the names change.
#include <algorithm>
#include <vector>

#include "output/output.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

std::string quoted(std::string const& raw)
{
    std::string const word = plain_text(raw);
    if (word.find_first_of(",\"") == std::string::npos) {
        return word;
    }
    std::string text = "\"";
    for (char const each : word) {
        text += each == '"' ? "\"\"" : std::string{each};
    }
    return text + '"';
}

template <typename Of> std::string line_of(record const& line, Of word)
{
    std::string text;
    for (field const& each : line.fields()) {
        text += (text.empty() and &each == line.fields().data() ? "" : ",") + quoted(word(each));
    }
    return text + '\n';
}

class csv : public form {
public:
    std::string text_of(record const& line) override
    {
        std::string text;
        if (not std::ranges::equal(line.fields(), names_, {}, &field::name)) {
            names_.clear();
            for (field const& each : line.fields()) {
                names_.push_back(each.name);
            }
            text = line_of(line, [](field const& each) { return each.name; });
        }
        return text + line_of(line, [](field const& each) { return text_of_cell(each.value); });
    }

private:
    std::vector<std::string> names_{};
};

} // namespace

std::unique_ptr<form> make_csv() { return std::make_unique<csv>(); }

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Comma-separated values (RFC 4180, but for the line's end); a line of names where the names change.
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "output/output.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

/// A number, or one with a unit: "-5.2 Hz", "+1e-3".
bool is_amount(std::string_view text)
{
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    double number = 0;
    auto const [end, why] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return why == std::errc{} and text.find_first_of("=+-@|!()'") == text.npos;
}

/// What a spreadsheet would take for a formula stands behind a mark that it takes for "this is text".
std::string without_formula(std::string text)
{
    bool const may_be_formula = not text.empty() and std::string_view{"=+-@"}.find(text[0]) != std::string_view::npos;
    return may_be_formula and text.size() > 1 and not is_amount(text) ? '\'' + std::move(text) : std::move(text);
}

std::string quoted(std::string const& raw)
{
    std::string const word = without_formula(plain_text(raw));
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

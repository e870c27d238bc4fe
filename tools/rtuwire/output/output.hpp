// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where results go: a table for people, or one JSON object or one line of comma-separated values a record for
// programs. What is said besides (progress, warnings) goes to the error output and never among the results.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "output/record.hpp"

namespace tool {

enum class output_form { table, json, csv };

/// How a record becomes text.
class form {
public:
    form() = default;
    form(form const&) = delete;
    form& operator=(form const&) = delete;
    virtual ~form() = default;

    /// The text for one more record; empty where it waits for others.
    virtual std::string text_of(record const& line) = 0;
    /// What has waited.
    virtual std::string rest() { return {}; }
};

/// `is_stream`: each record is shown as it comes, in columns as wide as those of the first need.
std::unique_ptr<form> make_table(bool is_stream);
std::unique_ptr<form> make_json();
std::unique_ptr<form> make_csv();

/// Results on standard output. A failure to write ends the command (`ended`, status 4), but for a reader that went
/// away, which `is_open` tells.
class output {
public:
    output(output_form how, bool is_stream);

    /// From here on a reader that went away ends the command, too: what changes a unit is to be told.
    void need_reader() noexcept { needs_reader_ = true; }

    /// `is_bad`: in red, in a table on a terminal.
    void put(record const& line, bool is_bad = false);
    /// Shows what has waited.
    void finish();
    /// False once the reader has gone.
    bool is_open() const { return is_open_; }

private:
    void write(std::string const& text);

    std::unique_ptr<form> form_;
    bool has_colours_;
    bool is_open_{true};
    bool needs_reader_{false};
};

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/output.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "../support/platform.hpp"
#include "exit_status.hpp"

namespace tool {

namespace {

std::unique_ptr<form> make(output_form how, bool is_stream)
{
    switch (how) {
    case output_form::json: return make_json();
    case output_form::csv: return make_csv();
    case output_form::table: break;
    }
    return make_table(is_stream);
}

} // namespace

output::output(output_form how, bool is_stream)
    : form_{make(how, is_stream)}, has_colours_{how == output_form::table and is_stream and
                                                is_terminal(STDOUT_FILENO) and std::getenv("NO_COLOR") == nullptr}
{}

void output::put(record const& line, bool is_bad)
{
    std::string const text = form_->text_of(line);
    if (not is_bad or not has_colours_ or text.empty()) {
        return write(text);
    }
    // Names of columns may stand in front.
    std::size_t const row = text.rfind('\n', text.size() - 2) + 1;
    write(text.substr(0, row) + "\x1b[31m" + text.substr(row, text.size() - row - 1) + "\x1b[0m\n");
}

void output::finish() { write(form_->rest()); }

void output::write(std::string const& text)
{
    if (not is_open_ or text.empty()) {
        return;
    }
    // Each record leaves at once: whoever reads a pipe waits for it.
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() and std::fflush(stdout) == 0) {
        return;
    }
    if (not is_reader_gone() or needs_reader_) {
        throw ended{exit_status::port, std::string{"standard output: "} + std::strerror(errno)};
    }
    is_open_ = false;
}

} // namespace tool

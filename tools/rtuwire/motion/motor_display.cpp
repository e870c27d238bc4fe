// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/motor_display.hpp"

#include <cmath>
#include <cstdio>

#include "../support/platform.hpp"
#include "../support/say.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

std::unique_ptr<form> form_for(output_form how)
{
    switch (how) {
    case output_form::json: return make_json();
    case output_form::csv: return make_csv();
    case output_form::table: break;
    }
    return make_table(true);
}

/// LCR, where its steps are known.
register_entry const* current_of(drive_catalog const& drive)
{
    register_entry const* const current = drive.by_code("LCR");
    return current != nullptr and current->steps_set_by.empty() ? current : nullptr;
}

constexpr std::size_t longest_state = 22;

} // namespace

motor_display::motor_display(output_form how, drive_catalog const& drive)
    : form_{form_for(how)}, is_table_{how == output_form::table}, is_line_{is_table_ and is_terminal(STDOUT_FILENO)},
      current_{current_of(drive)}
{}

void motor_display::show(motor_sight const& seen)
{
    was_linked_ = was_linked_ or seen.is_linked;
    if (seconds() < next_) {
        return;
    }
    next_ = std::floor(seconds() * (is_line_ ? 5 : 1) + 1) / (is_line_ ? 5 : 1);
    standard_output.put(is_line_ ? line_of(seen) : form_->text_of(record_of(seen, {})));
}

void motor_display::end(motor_sight const& seen, std::string const& sentence)
{
    standard_output.put(is_line_ ? line_of(seen) + '\n' : form_->text_of(record_of(seen, sentence)) + form_->rest());
}

void motor_display::say(motor_sight const& seen, std::string const& sentence)
{
    standard_output.put(is_line_ ? '\r' + plain_text(sentence) + "\x1b[K\n"
                                 : form_->text_of(record_of(seen, sentence)));
}

std::string motor_display::state_text(motor_sight const& seen) const
{
    return seen.is_linked and not seen.is_old ? std::string{std::string_view{name_of(seen.state)}}
                                              : std::string{was_linked_ ? "no link" : "nothing read yet"};
}

record motor_display::record_of(motor_sight const& seen, std::string const& note) const
{
    bool const is_known = seen.is_linked and seen.has_output;
    std::string state = state_text(seen);
    if (is_table_) { // a table that is shown line by line has columns as wide as its first line
        state.resize(longest_state, ' ');
    }
    return {{"seconds", std::round(seconds() * 10) / 10},
            {"state", state},
            {"frequency", is_known ? cell{hertz_of(seen)} : cell{}},
            {"current", is_known and current_ != nullptr ? cell{amperes_of(seen)} : cell{}},
            {"note", note}};
}

std::string motor_display::line_of(motor_sight const& seen) const
{
    char text[128];
    if (seen.is_linked and seen.has_output) {
        std::snprintf(text, sizeof text, "\r%6.1f s  %-22s %7.1f Hz  %6.2f A\x1b[K", seconds(),
                      state_text(seen).c_str(), hertz_of(seen), amperes_of(seen));
    } else {
        std::snprintf(text, sizeof text, "\r%6.1f s  %-22s\x1b[K", seconds(), state_text(seen).c_str());
    }
    return text;
}

double motor_display::hertz_of(motor_sight const& seen) const
{
    double const size = std::abs(seen.output) / 10.0;
    return seen.output < 0 or (seen.output > 0 and seen.is_backwards) ? -size : size;
}

/// Divides last: the quotient is the double that its fewest digits mean.
double motor_display::amperes_of(motor_sight const& seen) const
{
    return current_ == nullptr ? 0
                               : static_cast<double>(seen.current) * static_cast<double>(current_->step.numerator) /
                                     static_cast<double>(current_->step.denominator);
}

double motor_display::seconds() const
{
    return std::chrono::duration<double>{std::chrono::steady_clock::now() - began_}.count();
}

} // namespace tool

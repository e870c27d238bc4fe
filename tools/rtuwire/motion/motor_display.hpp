// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a motor does, while it does it: one line that changes on a terminal, a line a second elsewhere. Nothing here
// waits for the output.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "catalog/catalog.hpp"
#include "motion/motor.hpp"
#include "output/output.hpp"

namespace tool {

class motor_display {
public:
    motor_display(output_form how, drive_catalog const& drive);

    /// Shows it where it is time to; to be called in each pass.
    void show(motor_sight const& seen);

    /// Shows it now, with a sentence behind it: how it ended.
    void end(motor_sight const& seen, std::string const& sentence);

    /// Shows a sentence now, and goes on.
    void say(motor_sight const& seen, std::string const& sentence);

private:
    std::string state_text(motor_sight const& seen) const;
    record record_of(motor_sight const& seen, std::string const& note) const;
    std::string line_of(motor_sight const& seen) const;
    double hertz_of(motor_sight const& seen) const;
    double amperes_of(motor_sight const& seen) const;
    double seconds() const;

    std::unique_ptr<form> form_;
    bool is_table_;
    bool is_line_;                  ///< one line that changes
    bool was_linked_{false};        ///< something was read
    register_entry const* current_; ///< null where nobody knows its steps
    std::chrono::steady_clock::time_point began_{std::chrono::steady_clock::now()};
    double next_{0}; ///< seconds after `began_`
};

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The life of one motor: from the check before the order to where it was seen to stand. However it is left, the motor is
// stopped.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "../support/reason_to_end.hpp"
#include "catalog/catalog.hpp"
#include "choices.hpp"
#include "exit_status.hpp"
#include "motion/motor.hpp"
#include "motion/motor_display.hpp"
#include "motion/typed_lines.hpp"

namespace tool {

/// How it ended, in words.
struct motion_end {
    exit_status status;
    std::string sentence;
};

class running {
public:
    /// For as long as the choices say, at what was asked, and then at what is typed on the terminal.
    running(std::unique_ptr<motor> which, asked_motion const& asked, any_port& port, rtuwire::unit_id unit,
            drive_catalog const& drive, choices const& chosen);
    running(running const&) = delete;
    running& operator=(running const&) = delete;
    /// Stops the motor where it was not seen to stand: an exception is on its way.
    ~running();

    /// All of it. Ends early (`ended`) where the port, or the output, fails before the motor was ordered to run.
    motion_end run();

private:
    using clock = std::chrono::steady_clock;

    bool pass();
    bool go_on();
    /// Each until it is so; or why it ends before.
    std::optional<motion_end> connect();
    std::optional<motion_end> order();
    motion_end keep_running();
    void change(std::string const& typed);
    void tell_limit(motor_sight const& seen);
    std::string stop(motion_end& end);

    motion_end refusal_of_check() const;
    std::string remedy_for(rtuwire::altivar::outcome_kind finding, register_entry const& entry) const;
    motion_end order_lost() const;
    motion_end interrupted() const;
    motion_end not_begun() const;
    std::string own_stop() const;
    std::string limit_text() const;
    std::string fault_text() const;
    void heed_interrupts();
    bool stands() const;

    std::unique_ptr<motor> motor_;
    any_port& port_;
    rtuwire::unit_id unit_;
    drive_catalog const& drive_;
    motor_display display_;
    reason_to_end must_end_;
    missed_time pause_;
    std::optional<std::chrono::duration<double>> length_{};
    std::optional<clock::time_point> limit_due_{};      ///< when to look whether the drive limits what was typed
    std::optional<clock::time_point> interrupted_at_{}; ///< by the first Ctrl-C
    int heeded_interrupts_{0};
    bool is_coasting_{false};
    line_choices line_; ///< for the commands that are shown
    asked_motion asked_;
    typed_lines typed_{};
};

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Runs a motor until somebody ends this program, and stops it then: on every way out that a program has.
#include <string>

#include "../support/emergency_stop.hpp"
#include "../support/platform.hpp"
#include "../support/reason_to_end.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "motion/asked_motion.hpp"
#include "motion/motor.hpp"
#include "motion/question.hpp"
#include "motion/running.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

constexpr double quick_response = 0.3; ///< seconds: one exchange without an answer must not take the drive's time-out

line_choices line_for_motion(line_choices line)
{
    line.response_timeout = line.response_timeout.value_or(quick_response);
    return line;
}

std::uint16_t word_at(std::uint16_t address, char const* what, open_line& line, rtuwire::unit_id unit)
{
    auto const read = line.ask(unit, rtuwire::read_holding_registers{.start = address, .count = 1});
    if (not read) {
        throw ended{status_of(read.error()),
                    std::string{"the drive's "} + what + " could not be read: " + line.words_of_failure(read.error())};
    }
    return read->registers[0];
}

/// Nobody is asked whether a motor shall run that cannot. The whole check of the drive comes behind the answer: only that
/// tells why a drive is in local control.
void refuse_where_it_cannot_run(open_line& line, rtuwire::unit_id unit, drive_catalog const& drive,
                                line_choices const& how)
{
    auto const state = rtuwire::cia402::decode(word_at(drive.layout.eta, "status", line, unit));
    if (rtuwire::cia402::is_in_fault(state)) {
        register_entry const* const lft = drive.at(drive.layout.lft);
        std::uint16_t const fault = word_at(drive.layout.lft, "last fault", line, unit);
        throw ended{exit_status::differs, "the motor is not started: the drive is in fault: " +
                                              (lft == nullptr ? std::to_string(fault) : text_of(*lft, fault)) + "; `" +
                                              shown_command(how, "--write reset") + "` resets it"};
    }
    if (rtuwire::cia402::has_power(state)) {
        refuse_for_safety(
            "the motor has power already: somebody else commands it, and only there its speed is changed: "
            "a line such as 30Hz on the terminal of the start that runs it does; `" +
            shown_command(how, "stop") + "` stops it");
    }
}

std::string announcement(choices const& chosen, named_unit const& who, drive_catalog const& drive,
                         asked_motion const& asked)
{
    std::string const length = chosen.last ? "for " + text_of_cell(cell{*chosen.last}) + " s" : "until Ctrl-C";
    std::string const unit =
        "unit " + std::to_string(who.unit.byte()) + (who.name.empty() ? "" : " (" + who.name + ")");
    std::string const other = asked.is_speed ? "900rpm" : "30Hz";
    bool const is_typed_to = is_terminal(STDIN_FILENO);
    return unit + ", " + std::string{drive.name} + " on " + chosen.line.port + ": runs the motor at " + asked.text +
           words_of_least(asked) + ", " + length +
           (is_typed_to ? "; a line such as " + other + " changes that meanwhile" : std::string{});
}

exit_status start_on(line_choices const& how, choices const& chosen)
{
    named_unit const who = unit_to_change(chosen);
    open_line line{how};
    drive_catalog const& drive = catalog_of(line, who.unit, who.drive);
    motor_maker const make = maker_of(drive.name);
    if (make == nullptr) {
        refuse_word("this program does not run the motor of an " + std::string{drive.name});
    }
    auto const looked = [&] {
        asked_motion const asked = motion_asked(chosen.motion, line, who.unit, drive);
        refuse_where_it_cannot_run(line, who.unit, drive, chosen.line);
        return asked;
    };
    asked_motion asked = looked();
    if (not may_go_on(chosen.allowed, announcement(chosen, who, drive, asked), "run?")) {
        throw ended{exit_status::refused, "the motor is not started"};
    }
    if (is_asked(chosen.allowed)) {
        asked = looked();
    }
    running motor{make({line.port(), line.options(), line.exchange()}, who.unit, asked),
                  asked,
                  line.port(),
                  who.unit,
                  drive,
                  chosen};
    motion_end const end = motor.run();
    complain("rtuwire: %s\n", plain_text(end.sentence).c_str());
    return end.status;
}

} // namespace

exit_status run_start(choices const& chosen)
{
    if (not chosen.allowed.may_run) {
        refuse_for_safety("this program moves nothing; to run a motor, say --allow-run");
    }
    refuse_wrong_words(chosen.motion);
    static_cast<void>(unit_to_change(chosen)); // refuses where nobody said which
    take_signals();
    stop_motor_before_dying();
    exit_status const status = start_on(line_for_motion(chosen.line), chosen);
    if (noted.suspend != 0) {
        standard_output.finish(std::chrono::milliseconds{500});
        suspend(); // nothing is asked of the drive any more
    }
    bool const is_shown = end_of_output("rtuwire", 0) == 0;
    return status == exit_status::done and not is_shown ? exit_status::port : status;
}

} // namespace tool

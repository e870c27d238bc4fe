// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Resets a fault, and says which it was.
#include <string>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "line/write_log.hpp"
#include "motion/question.hpp"
#include "port/named_drives.hpp"

namespace tool {

namespace {

using rtuwire::altivar::outcome_kind;

class resetting {
public:
    explicit resetting(choices const& chosen)
        : chosen_{chosen}, who_{unit_to_change(chosen)}, line_{chosen.line}, drive_{catalog_of(line_, who_.unit,
                                                                                               who_.drive)}
    {}

    exit_status run()
    {
        refuse_wrong_log();
        rtuwire::cia402::state const before = rtuwire::cia402::decode(read(drive_.layout.eta));
        std::string const fault = fault_text(read(drive_.layout.lft));
        if (not rtuwire::cia402::is_in_fault(before)) {
            return tell("", "the drive is not in fault: " + std::string{std::string_view{name_of(before)}},
                        exit_status::done);
        }
        if (not may_go_on(chosen_.allowed, "unit " + std::to_string(who_.unit.byte()) + " is in fault: " + fault,
                          "reset it?")) {
            return exit_status::refused;
        }
        rtuwire::altivar::reason why{};
        std::string const name{drive_.name};
        with_drive(name, [&](auto device) {
            using type = typename decltype(device)::type;
            rtuwire::altivar::reset_fault conversation{station_at<type>(who_.unit.byte(), name)};
            why = line_.command(conversation);
        });
        return judge(fault, why);
    }

private:
    std::uint16_t read(std::uint16_t address)
    {
        auto const outcome = line_.ask(who_.unit, rtuwire::read_holding_registers{.start = address, .count = 1});
        if (not outcome) {
            throw ended{status_of(outcome.error()),
                        "unit " + std::to_string(who_.unit.byte()) + ": " + line_.words_of_failure(outcome.error())};
        }
        return outcome->registers[0];
    }

    std::string fault_text(std::uint16_t code) const
    {
        register_entry const* const lft = drive_.at(drive_.layout.lft);
        return lft == nullptr ? std::to_string(code) : text_of(*lft, code);
    }

    exit_status judge(std::string const& fault, rtuwire::altivar::reason const& why)
    {
        std::string const after = why.kind == outcome_kind::succeeded  ? "reset"
                                  : why.kind == outcome_kind::in_fault ? "fault " + fault_text(why.fault)
                                                                       : "unknown";
        std::string const failure =
            log_write({chosen_.line.port, unsigned{who_.unit.byte()}, "CMD", "fault " + fault, after});
        std::string const log = failure.empty() ? std::string{} : "; not noted: " + failure;
        if (why.kind == outcome_kind::succeeded) {
            return tell(fault, "reset" + log, failure.empty() ? exit_status::done : exit_status::port);
        }
        if (why.kind == outcome_kind::silent) {
            return tell(fault, "no answer: " + words_of(why.error) + log,
                        why.error == rtuwire::errc::none ? exit_status::no_answer : status_of(why.error));
        }
        std::string const still = why.kind == outcome_kind::in_fault
                                      ? "still in fault: its cause is there (" + fault_text(why.fault) + ")"
                                      : "not reset: " + std::string{std::string_view{name_of(why.kind)}};
        return tell(fault, still + log, exit_status::differs);
    }

    exit_status tell(std::string const& fault, std::string const& outcome, exit_status status) const
    {
        output results{chosen_.form, false};
        results.put({{"unit", std::int64_t{who_.unit.byte()}}, {"fault", fault}, {"outcome", outcome}});
        results.finish();
        return status;
    }

    choices const& chosen_;
    named_unit who_;
    open_line line_;
    drive_catalog const& drive_;
};

} // namespace

exit_status run_reset(choices const& chosen)
{
    if (not chosen.allowed.may_write) {
        refuse_for_safety("this program only reads; to reset a fault, say --write");
    }
    return resetting{chosen}.run();
}

} // namespace tool

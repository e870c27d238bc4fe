// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/unsafe_write.hpp"

#include <string>

#include "exit_status.hpp"
#include "motion/moving_registers.hpp"

namespace tool {

namespace {

/// Refuses for safety, unless --allow-run was said.
void refuse_without_run(permissions const& allowed, std::string const& why)
{
    if (not allowed.may_run) {
        refuse_for_safety(why + "; to write it, say --allow-run besides");
    }
}

void refuse_unsafe_value(register_entry const& entry, std::uint16_t word, drive_catalog const& drive,
                         permissions const& allowed)
{
    if (std::string const never = why_it_is_never_written(entry, word, drive); not never.empty()) {
        refuse_for_safety(never);
    }
    if (std::string const why = why_it_runs_on(entry.address, word, drive); not why.empty()) {
        refuse_without_run(allowed, std::string{entry.code} + "=" + std::to_string(word) + " " + why +
                                        ": a motor runs on when its controller, its cable or something else fails");
    }
}

} // namespace

void refuse_unsafe_write(value_to_write const& value, drive_catalog const& drive, permissions const& allowed)
{
    std::string const label = value.entry != nullptr ? std::string{value.entry->code} : std::to_string(value.address);
    if (commands_a_motor(value.address, drive)) {
        refuse_for_safety(label + " commands the motor: use `rtuwire start` and `rtuwire stop`");
    }
    if (value.entry == nullptr) {
        refuse_without_run(allowed, "register " + label + " is none of the parameters of an " +
                                        std::string{drive.name} + " that are known: nobody knows what it does");
        return;
    }
    if (std::string const why = why_it_may_move(*value.entry); not why.empty()) {
        refuse_without_run(allowed, label + " " + why + ": a motor may turn after it");
    }
    if (value.is_ready()) {
        refuse_unsafe_value(*value.entry, value.word, drive, allowed);
    }
}

} // namespace tool

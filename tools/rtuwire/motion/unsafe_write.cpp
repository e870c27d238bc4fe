// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/unsafe_write.hpp"

#include <algorithm>
#include <string>

#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "line/register_reader.hpp"
#include "motion/moving_registers.hpp"

namespace tool {

namespace {

/// Refuses for safety, unless --allow-run was said.
void refuse_without_run(permissions const& allowed, std::string const& why)
{
    if (not allowed.may_run) {
        refuse_for_safety(why + allowed.by_run("write"));
    }
}

void refuse_unsafe_value(register_entry const& entry, std::uint16_t word, drive_catalog const& drive,
                         permissions const& allowed)
{
    if (std::string const never = why_it_is_never_written(entry, word, drive); not never.empty()) {
        refuse_for_safety(never);
    }
    std::string const value = std::string{entry.code} + "=" + std::to_string(word) + " ";
    if (std::string const why = why_it_runs_on(entry.address, word, drive); not why.empty()) {
        refuse_without_run(allowed,
                           value + why + ": a motor runs on when its controller, its cable or something else fails");
    }
    if (std::string const why = why_it_is_out_of_reach(entry, word); not why.empty()) {
        refuse_without_run(allowed, value + why + ": nobody can read it, nor stop it alone");
    }
}

/// The first type of drive whose motor a register commands. The type that was said may be wrong.
drive_catalog const* commanded_there(std::uint16_t address)
{
    auto const found = std::ranges::find_if(
        all_catalogs(), [address](drive_catalog const* each) { return commands_a_motor(address, *each); });
    return found == all_catalogs().end() ? nullptr : *found;
}

/// What is wrong with a drive that has to be without power; nothing where nothing is.
std::optional<ended> why_not_at_rest(open_line& line, rtuwire::unit_id unit, drive_catalog const& drive)
{
    std::uint16_t const eta = drive.layout.eta;
    std::uint16_t const rfr = drive.layout.rfr;
    register_reader status{{{{eta}, drive.at(eta)}, {{rfr}, drive.at(rfr)}}, &drive};
    status.read(line, unit);
    if (status.first_error() != rtuwire::errc::none) {
        return ended{status_of(status.first_error()),
                     "the drive does not tell whether its motor runs: " + status.first_failure()};
    }
    auto const state = rtuwire::cia402::decode(*status.at(eta));
    if (not rtuwire::cia402::is_at_rest(state)) {
        return ended{exit_status::refused, "the drive is in \"" + std::string{std::string_view{name_of(state)}} + '"'};
    }
    if (*status.at(rfr) != 0) {
        return ended{exit_status::refused, "the drive's output frequency is not 0"};
    }
    return std::nullopt;
}

} // namespace

bool is_target_of_profile(unsigned address)
{
    constexpr unsigned objects[]{0x6040, 0x6042, 0x6060, 0x6071, 0x607A, 0x60FF};
    return std::ranges::find(objects, address) != std::end(objects);
}

std::optional<ended> why_not_now(std::vector<value_to_write> const& values, open_line& line, rtuwire::unit_id unit,
                                 drive_catalog const& drive, permissions const& allowed)
{
    auto const which = std::ranges::find_if(values, [](value_to_write const& each) {
        return each.entry != nullptr and not why_it_runs_otherwise(*each.entry).empty();
    });
    if (allowed.may_run or which == values.end()) {
        return std::nullopt;
    }
    std::optional<ended> const why = why_not_at_rest(line, unit, drive);
    if (not why) {
        return std::nullopt;
    }
    return ended{why->status,
                 std::string{which->entry->code} + " " + why_it_runs_otherwise(*which->entry) +
                     ": a motor that runs turns otherwise after it, and " + why->what() +
                     (allowed.knows_run ? "; to write it to a drive with power, say --allow-run besides" : "")};
}

void refuse_command(value_to_write const& value, write_rules const& rules, choices const& chosen)
{
    unsigned const first = value.where.address;
    unsigned const count = value.where.space == register_space::holding ? value.where.form.registers() : 0U;
    for (unsigned each = first; each < first + count; ++each) {
        auto const address = static_cast<std::uint16_t>(each);
        drive_catalog const* const drive = rules.drive;
        if (drive != nullptr and commands_a_motor(address, *drive)) {
            register_entry const* const entry = drive->at(address);
            refuse_for_safety((entry != nullptr ? std::string{entry->code} : std::to_string(address)) +
                              " commands the motor: that is what the command start is for; `" +
                              shown_command(chosen.line, chosen.line.typed.stop) + "` stops it");
        }
        if (rules.command == address) {
            refuse_for_safety("register " + std::to_string(address) +
                              " commands the motor of a drive, which this unit may be");
        }
        if (is_target_of_profile(address) and not rules.says_it_is_none) {
            refuse_without_run(chosen.allowed, "register " + std::to_string(address) +
                                                   " commands the motor of a drive of CiA 402, which this unit may be");
        }
        drive_catalog const* const other =
            drive == nullptr or drive->at(address) == nullptr ? commanded_there(address) : nullptr;
        if (other == nullptr) {
            continue;
        }
        std::string const what = " commands the motor of an " + std::string{other->name} + ", which this unit may be: ";
        if (drive != nullptr or rules.command) {
            refuse_for_safety("register " + std::to_string(address) +
                              (drive != nullptr ? " is none of an " + std::string{drive->name} + ", and" : "") + what +
                              "`identify` asks it");
        }
        if (not rules.says_it_is_none) { // one that starts, or hides its registers, answers as if it had none
            refuse_without_run(chosen.allowed,
                               "register " + std::to_string(address) + what + "it does not say who it is");
        }
    }
}

void refuse_what_moves(value_to_write const& value, permissions const& allowed)
{
    if (value.named != nullptr and value.named->moves) {
        refuse_without_run(allowed, value.named->where.name + " moves something, as its register file says in line " +
                                        std::to_string(value.named->line));
    }
}

void refuse_unsafe_write(value_to_write const& value, drive_catalog const& drive, choices const& chosen)
{
    permissions const& allowed = chosen.allowed;
    std::string const label =
        value.entry != nullptr ? std::string{value.entry->code} : std::to_string(value.where.address);
    if (value.entry == nullptr) {
        refuse_without_run(allowed, "register " + label + " is none of the parameters of an " +
                                        std::string{drive.name} + " that are known: nobody knows what it does");
        return;
    }
    if (std::string const why = why_it_may_move(*value.entry); not why.empty()) {
        refuse_without_run(allowed, label + " " + why + ": a motor may turn after it");
    }
    if (value.is_ready()) {
        refuse_unsafe_value(*value.entry, value.words[0], drive, allowed);
    }
}

} // namespace tool

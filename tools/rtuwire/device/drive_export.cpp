// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "device/drive_export.hpp"

#include <algorithm>

#include <rtuwire/maintenance.hpp>

#include "motion/moving_registers.hpp"

namespace tool {

namespace {

/// By whatever value: a register file knows no values that move.
bool moves(register_entry const& entry, drive_catalog const& drive)
{
    constexpr std::uint16_t values[]{0, 4, 5};
    return commands_a_motor(entry.address, drive) or not why_it_may_move(entry).empty() or
           not why_it_runs_otherwise(entry).empty() or std::ranges::any_of(values, [&](std::uint16_t word) {
               return not why_it_runs_on(entry.address, word, drive).empty();
           });
}

/// Whether this program never writes one of its values.
bool has_forbidden_value(register_entry const& entry, drive_catalog const& drive)
{
    return not why_it_is_never_written(entry, 1, drive).empty() or not why_it_is_out_of_reach(entry, 0).empty();
}

void add_limits(register_entry const& entry, written_register& one, register_file_writer& into)
{
    auto const read = [&](rtuwire::bound const& limit, std::optional<double>& into_limit) {
        if (limit.is_number()) {
            into_limit = static_cast<double>(limit.raw()) * static_cast<double>(entry.step.numerator) /
                         static_cast<double>(entry.step.denominator);
        } else if (not limit.is_open()) {
            into.lose({}, one.name + ": its limit, " + text_of_bound(limit) + ", is not carried over");
        }
    };
    read(entry.min, one.lowest);
    read(entry.max, one.highest);
    if (entry.gap_last >= entry.gap_first) {
        into.lose({}, one.name + ": that it never takes " + std::to_string(entry.gap_first) + " to " +
                          std::to_string(entry.gap_last) + " counts is not carried over");
    }
}

written_register register_of(register_entry const& entry, drive_catalog const& drive, register_file_writer& into)
{
    written_register one;
    one.name = std::string{entry.code};
    one.comment = std::string{entry.name};
    one.address = entry.address;
    one.type = entry.kind == register_kind::signed_number ? "i16" : entry.kind == register_kind::bits ? "hex" : "";
    one.unit = std::string{entry.unit};
    one.scale = static_cast<double>(entry.step.numerator) / static_cast<double>(entry.step.denominator);
    one.moves = moves(entry, drive);
    one.is_writable = entry.is_writable();
    if (one.is_writable and has_forbidden_value(entry, drive)) {
        into.lose({}, one.name + " is read only there: a value of it takes the drive's settings or its address away");
        one.is_writable = false;
    }
    one.is_setting =
        not one.moves and rtuwire::altivar::role_of(*entry.row) == rtuwire::altivar::parameter_role::setting;
    for (rtuwire::choice const& each : entry.values()) {
        one.choices.emplace_back(std::string{std::string_view{each.mnemonic}}, each.word);
    }
    if (not entry.steps_set_by.empty()) {
        one.not_the_value = "the size of its steps is what " + std::string{entry.steps_set_by} + " holds";
    }
    if (entry.is_amount()) {
        add_limits(entry, one, into);
    }
    return one;
}

} // namespace

void export_drive(drive_catalog const& drive, register_file_writer& into)
{
    into.add_comment("The registers of an " + std::string{drive.name} + ", exported by rtuwire.");
    into.add_comment(
        "Of a drive that rtuwire recognises its own table counts; this is for other programs, and to change.");
    into.limit_requests({}, drive.limits.read);
    for (register_entry const& each : drive.registers) {
        into.add(register_of(each, drive, into));
    }
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/moving_registers.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <rtuwire/maintenance.hpp>

namespace tool {

namespace {

using rtuwire::altivar::parameter_role;

constexpr std::uint16_t first_scanner_output = 12'761; ///< NC1: what the scanner writes to the command
constexpr std::uint16_t save_to_eeprom = 2;            ///< the order in CMI

/// Groups in which each register may have that effect.
constexpr std::pair<std::string_view, std::string_view> groups[] = {
    {"function_blocks", "is a part of the program of the function blocks, which may command the motor"},
    {"functions_parameter_sets", "is a part of the parameter sets, which an input loads into any register"},
};

parameter_role role_of(register_entry const& entry) { return rtuwire::altivar::role_of(*entry.row); }

std::string reason_for(register_entry const& entry)
{
    return std::string{std::string_view{rtuwire::altivar::why(*entry.row)}};
}

bool has_value_named(register_entry const& entry, std::string_view name)
{
    return std::ranges::any_of(entry.values(),
                               [name](auto const& each) { return std::string_view{each.mnemonic} == name; });
}

/// Whether it is what a drive does at a fault: to ignore it is one of the choices, and the value tells.
bool is_reaction(register_entry const& entry) { return has_value_named(entry, "LFF") and has_value_named(entry, "nO"); }

/// Orders that save, recall, reset or count, and move nothing.
bool is_quiet_order(register_entry const& entry)
{
    constexpr std::string_view quiet[]{"CMI", "SCS", "FCS", "RPR"};
    return std::ranges::count(quiet, entry.code) > 0;
}

/// Whether its role in a drive's configuration makes it one after whose writing a motor may turn.
bool is_moving_role(register_entry const& entry)
{
    switch (role_of(entry)) {
    case parameter_role::macro:
    case parameter_role::restart:
    case parameter_role::run_input:
    case parameter_role::channel:
    case parameter_role::safety: return true;
    case parameter_role::order: return not is_quiet_order(entry);
    // What depends on its value is told by `why_it_runs_on`; an input or a key that stops the motor has no such value.
    case parameter_role::supervision: return not entry.is_amount() and not is_reaction(entry);
    case parameter_role::setting:
    case parameter_role::step_size:
    case parameter_role::frequency_limit:
    case parameter_role::motion:
    case parameter_role::link_timeout:
    case parameter_role::other_link:
    case parameter_role::link:
    case parameter_role::read_only:
    case parameter_role::derived:
    case parameter_role::measured:
    case parameter_role::of_this_drive: return false;
    }
    return false;
}

} // namespace

bool commands_a_motor(std::uint16_t address, drive_catalog const& drive)
{
    register_entry const* const entry = drive.at(address);
    bool const is_scanner_output =
        entry != nullptr and entry->code.starts_with("NC") and address >= first_scanner_output;
    bool const is_command =
        entry != nullptr and (entry->code == "CMDD" or entry->code == "LFRD" or entry->code == "LFR");
    return address == drive.layout.cmd or address == drive.speed_reference or address == drive.frequency_reference or
           is_command or is_scanner_output;
}

bool runs_a_drive(std::uint16_t address)
{
    // Those that are not rows of every drive: CMDD and LFRD, what is between the command and its extension, and the ATV28's.
    constexpr std::uint16_t others[]{400, 401, 8501, 8502, 8503, 8504, 8601, 8602};
    return std::ranges::count(others, address) > 0 or
           std::ranges::any_of(all_catalogs(), [address](drive_catalog const* each) {
               register_entry const* const entry = each->at(address);
               bool const is_channel = entry != nullptr and role_of(*entry) == parameter_role::channel;
               return is_channel or commands_a_motor(address, *each);
           });
}

std::string why_it_may_move(register_entry const& entry)
{
    if (not entry.is_writable()) {
        return {};
    }
    if (is_moving_role(entry)) {
        return reason_for(entry);
    }
    for (auto const& [group, why] : groups) {
        if (entry.group == group) {
            return std::string{why};
        }
    }
    bool const names_a_signal = has_value_named(entry, "LI1") or has_value_named(entry, "AI1");
    return names_a_signal ? "says which signal does it, and that may be on now" : "";
}

std::string why_it_runs_otherwise(register_entry const& entry)
{
    bool const acts = entry.is_writable() and rtuwire::altivar::acts_on_running_motor(role_of(entry));
    return acts and why_it_may_move(entry).empty() ? reason_for(entry) : std::string{};
}

std::string why_it_runs_on(std::uint16_t address, std::uint16_t word, drive_catalog const& drive)
{
    rtuwire::altivar::safeguard_layout const& at = drive.layout.safeguards;
    bool const is_link = at.sll != 0 and address == at.sll;
    bool const is_timeout = at.tto != 0 and address == at.tto;
    constexpr std::uint16_t off = 0, takes_fallback_speed = 4, keeps_speed = 5;
    bool const runs_on = word == takes_fallback_speed or word == keeps_speed;
    if (is_link or is_timeout) {
        return word == off           ? "switches the supervision of the link off"
               : is_link and runs_on ? "lets the motor run without its link"
                                     : "";
    }
    register_entry const* const entry = drive.at(address);
    if (entry == nullptr or not entry->is_writable() or role_of(*entry) != parameter_role::supervision) {
        return {};
    }
    return word == off or (is_reaction(*entry) and runs_on) ? reason_for(*entry) : std::string{};
}

std::string why_it_is_out_of_reach(register_entry const& entry, std::uint16_t word)
{
    return entry.code == "ADD" and word == 0
               ? "switches the drive's address off: it responds at no address any more, and "
                 "takes broadcasts only"
               : "";
}

std::string why_it_is_a_guard(register_entry const& entry)
{
    parameter_role const role = role_of(entry);
    bool const is_guard = role == parameter_role::link or role == parameter_role::link_timeout or
                          role == parameter_role::other_link or role == parameter_role::supervision;
    return is_guard ? reason_for(entry) : std::string{};
}

std::string why_it_is_never_written(register_entry const& entry, std::uint16_t word, drive_catalog const& drive)
{
    if (entry.address == drive.layout.cmi and word != save_to_eeprom) {
        return "CMI has orders that take a drive's settings away; this program writes only 2, which saves to EEPROM";
    }
    if (entry.code == "FCS" and word != 0) {
        return "FCS takes a drive's settings away, for others that it keeps or for those of the factory; this program "
               "does not write it";
    }
    return {};
}

bool takes_orders(register_entry const& entry, drive_catalog const& drive)
{
    constexpr std::string_view orders[]{"SCS", "RPR", "RP", "TUN", "VAL", "FBCD"};
    return entry.address == drive.layout.cmi or std::ranges::count(orders, entry.code) > 0;
}

} // namespace tool

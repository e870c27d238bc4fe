// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/left_alone.hpp"

namespace tool {

namespace {

constexpr std::uint32_t tenth = 100'000;

std::optional<std::uint16_t> word_at(open_line& line, rtuwire::unit_id unit, std::uint16_t address)
{
    auto const outcome = line.ask(unit, rtuwire::read_holding_registers{.start = address, .count = 1});
    return outcome ? std::optional{outcome->registers[0]} : std::nullopt;
}

/// Whether a silent line ends in a fault, by the value of SLL: not where it is ignored (0), ends in a stop alone (2), or
/// has the drive go on (4, 5).
bool ends_in_fault(std::uint16_t reaction)
{
    return reaction != 0 and reaction != 2 and reaction != 4 and reaction != 5;
}

/// "after 10.0 s"; nothing where the drive does not trip.
std::optional<std::string> end_of(open_line& line, rtuwire::unit_id unit, rtuwire::altivar::drive_layout const& layout)
{
    line_supervision const found = supervision_of(line, unit, layout);
    if (found.is_off or not found.ends_in_fault) {
        return std::nullopt;
    }
    std::uint32_t const tenths = found.tenths ? *found.tenths : layout.longest_silence.microseconds / tenth;
    return (found.tenths ? "after " : "after at most ") + std::to_string(tenths / 10) + '.' +
           std::to_string(tenths % 10) + " s";
}

} // namespace

line_supervision supervision_of(open_line& line, rtuwire::unit_id unit, rtuwire::altivar::drive_layout const& layout)
{
    auto const& at = layout.safeguards;
    line_supervision found;
    if (auto const reaction = word_at(line, unit, at.nto != 0 ? layout.cmi : at.sll)) {
        found.is_off = at.nto != 0 ? (*reaction & at.nto) != 0 : *reaction == 0;
        found.ends_in_fault = at.nto != 0 ? not found.is_off : ends_in_fault(*reaction);
    }
    if (not found.is_off) {
        found.tenths = at.tto != 0 ? word_at(line, unit, at.tto)
                                   : std::optional{static_cast<std::uint16_t>(at.fixed_timeout.microseconds / tenth)};
        found.is_off = found.tenths == std::uint16_t{0};
    }
    return found;
}

void left_alone::note(open_line& line, rtuwire::unit_id unit, drive_catalog const& drive, std::string const& reset)
{
    trips_after_.erase(unit.byte());
    if (auto const end = end_of(line, unit, drive.layout)) {
        trips_after_.emplace(unit.byte(), tripping{*end, reset});
    }
}

std::string left_alone::sentence() const
{
    if (trips_after_.empty()) {
        return {};
    }
    std::string units;
    for (auto const& [unit, trips] : trips_after_) {
        units += (units.empty() ? "unit " : ", unit ") + std::to_string(unit) + ' ' + trips.end;
    }
    return "a drive that no program goes on asking trips (SLF): " + units + "; `" + trips_after_.begin()->second.reset +
           "` resets unit " + std::to_string(trips_after_.begin()->first);
}

} // namespace tool

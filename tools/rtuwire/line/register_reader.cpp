// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/register_reader.hpp"

#include <algorithm>

namespace tool {

using rtuwire::errc;

register_reader::register_reader(std::vector<chosen_register> const& chosen, drive_catalog const* drive)
    : drive_{drive}, limit_{drive != nullptr ? drive->limits.read : rtuwire::max_read_quantity}
{
    std::set<std::uint16_t> addresses;
    for (chosen_register const& each : chosen) {
        addresses.insert(each.address);
        if (each.entry != nullptr and drive != nullptr and not each.entry->steps_set_by.empty()) {
            if (register_entry const* const other = drive->by_code(each.entry->steps_set_by)) {
                addresses.insert(other->address);
            }
        }
    }
    group(addresses);
}

bool register_reader::may_reach(std::uint16_t from, std::uint16_t to) const
{
    for (unsigned each = from + 1U; each < to; ++each) {
        if (drive_ == nullptr or drive_->at(static_cast<std::uint16_t>(each)) == nullptr) {
            return false;
        }
    }
    return true;
}

void register_reader::group(std::set<std::uint16_t> const& addresses)
{
    for (std::uint16_t const each : addresses) {
        if (not blocks_.empty()) {
            block& last = blocks_.back();
            auto const end = static_cast<std::uint16_t>(last.start + last.count - 1U);
            if (each - last.start < static_cast<int>(limit_) and may_reach(end, each)) {
                last.count = static_cast<std::uint16_t>(each - last.start + 1);
                continue;
            }
        }
        blocks_.push_back({each, 1});
    }
}

errc register_reader::read(open_line& line, rtuwire::unit_id unit, block const& which)
{
    auto const outcome = line.ask(unit, rtuwire::read_holding_registers{.start = which.start, .count = which.count});
    std::string const failure = outcome ? std::string{} : line.words_of_failure(outcome.error());
    for (std::uint16_t i = 0; i < which.count; ++i) {
        auto const address = static_cast<std::uint16_t>(which.start + i);
        if (outcome) {
            failures_.erase(address);
        } else {
            failures_.insert_or_assign(address, failure);
        }
        words_.insert_or_assign(address, outcome ? rtuwire::result<std::uint16_t>{outcome->registers[i]}
                                                 : rtuwire::result<std::uint16_t>{outcome.error()});
    }
    return outcome.error();
}

/// What refuses a block may tell some of it alone; what takes no block so long, halves of it.
errc register_reader::read_parts(open_line& line, rtuwire::unit_id unit, block const& which)
{
    errc const whole = read(line, unit, which);
    bool const is_too_long = whole == errc::illegal_data_value;
    if (which.count < 2 or not(is_too_long or whole == errc::illegal_data_address)) {
        return whole;
    }
    auto const part = static_cast<std::uint16_t>(is_too_long ? (which.count + 1U) / 2U : 1U);
    errc outcome = errc::none;
    for (unsigned done = 0; done < which.count; done += part) {
        errc const one = read_parts(line, unit,
                                    {static_cast<std::uint16_t>(which.start + done),
                                     static_cast<std::uint16_t>(std::min<unsigned>(part, which.count - done))});
        outcome = outcome == errc::none ? one : outcome;
    }
    return outcome;
}

void register_reader::read(open_line& line, rtuwire::unit_id unit)
{
    first_error_ = errc::none;
    first_failure_.clear();
    failures_.clear();
    for (block const& each : blocks_) {
        errc const outcome = read_parts(line, unit, each);
        if (status_of(outcome) == exit_status::port) {
            throw ended{exit_status::port, line.port().failure()};
        }
        if (first_error_ == errc::none and outcome != errc::none) {
            first_error_ = outcome;
            first_failure_ = failures_.begin()->second;
        }
    }
}

std::string register_reader::why_not(std::uint16_t address) const
{
    auto const found = failures_.find(address);
    return found == failures_.end() ? words_of(at(address).error()) : found->second;
}

rtuwire::result<std::uint16_t> register_reader::at(std::uint16_t address) const
{
    auto const found = words_.find(address);
    return found == words_.end() ? errc::invalid_address_range : found->second;
}

known_words register_reader::known() const
{
    return [this](std::string_view code) -> std::optional<std::uint16_t> {
        register_entry const* const entry = drive_ == nullptr ? nullptr : drive_->by_code(code);
        if (entry == nullptr) {
            return std::nullopt;
        }
        auto const word = at(entry->address);
        return word ? std::optional{*word} : std::nullopt;
    };
}

} // namespace tool

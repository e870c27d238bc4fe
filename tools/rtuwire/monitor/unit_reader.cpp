// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/unit_reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <rtuwire/drives.hpp>

#include "catalog/value_text.hpp"
#include "line/reading.hpp"
#include "line/who_is_it.hpp"

namespace tool {

using rtuwire::errc;

namespace {

bool is_silence(errc why) { return why != errc::none and not rtuwire::is_exception(why); }

chosen_register whole_register(drive_catalog const& drive, std::uint16_t address)
{
    return {{address}, drive.at(address)};
}

double sample_of(cell const& value)
{
    if (auto const* const amount = std::get_if<double>(&value)) {
        return *amount;
    }
    if (auto const* const large = std::get_if<std::uint64_t>(&value)) {
        return static_cast<double>(*large);
    }
    auto const* const count = std::get_if<std::int64_t>(&value);
    return count != nullptr ? static_cast<double>(*count) : NAN;
}

bool has_curve(chosen_register const& which)
{
    return (which.entry == nullptr or which.entry->is_amount()) and which.where.bit < 0;
}

} // namespace

unit_reader::unit_reader(unit_wish wish) : wish_{std::move(wish)}, patience_{wish_.misses}
{
    shown_.address = wish_.unit.unit.byte();
    shown_.name = wish_.unit.name;
    if (not wish_.unit.drive.empty()) {
        begin(catalog_or_none(wish_.unit.drive));
    }
}

void unit_reader::begin(drive_catalog const* drive)
{
    is_known_ = true;
    drive_ = drive;
    choose_all();
    std::vector<chosen_register> all = registers_;
    if (drive != nullptr) {
        shown_.drive = std::string{drive->name};
        state_reader_.emplace(std::vector{whole_register(*drive, drive->layout.eta)}, drive);
        all.push_back(whole_register(*drive, drive->layout.lft));
    }
    reader_.emplace(all, vocabulary{drive, wish_.unit.names});
}

void unit_reader::choose_all()
{
    for (std::string const& word : wish_.words) {
        if (choose_registers(word).empty()) {
            shown_.lacks += (shown_.lacks.empty() ? "has no " : ", ") + word;
        }
    }
    if (wish_.words.empty() and drive_ != nullptr) {
        choose_registers("@monitor");
        // What the lines above the values say already.
        std::erase_if(registers_, [this](chosen_register const& each) {
            return each.where.address == drive_->layout.eta or each.where.address == drive_->layout.lft;
        });
    } else if (wish_.words.empty() and wish_.unit.names != nullptr) {
        choose_registers("*");
    }
    if (registers_.empty() and not shown_.lacks.empty()) {
        shown_.note = std::exchange(shown_.lacks, {});
    }
    std::vector<std::size_t> plotted;
    for (std::string const& word : wish_.plots) {
        std::vector<std::size_t> const found = choose_registers(word);
        plotted.insert(plotted.end(), found.begin(), found.end());
        note_lack(found.empty() ? word : std::string{});
    }
    std::vector<std::pair<std::size_t, value_limit const*>> limited;
    for (value_limit const& limit : wish_.limits) {
        std::vector<std::size_t> const found = choose_registers(limit.word);
        std::ranges::for_each(found, [&](std::size_t which) { limited.emplace_back(which, &limit); });
        note_lack(found.empty() ? limit.word : std::string{});
    }
    for (chosen_register const& each : registers_) {
        shown_.values.push_back(
            {label_of(each), each.entry == nullptr ? std::string{} : std::string{each.entry->name}});
    }
    before_.resize(registers_.size());
    std::ranges::for_each(plotted, [this](std::size_t which) { shown_.values[which].is_plotted = true; });
    for (auto const& [which, limit] : limited) {
        before_[which].limit = *limit;
    }
}

/// A curve or an alarm that somebody asked for by name, and that there will not be.
void unit_reader::note_lack(std::string const& word)
{
    if (not word.empty()) {
        shown_.note += (shown_.note.empty() ? "has no " : ", ") + word;
    }
}

std::vector<std::size_t> unit_reader::choose_registers(std::string const& word)
{
    std::string_view const one[]{word};
    std::vector<std::size_t> chosen;
    for (chosen_register const& each : select_registers(one, {drive_, wish_.unit.names}).registers) {
        auto const found = std::ranges::find(registers_, each);
        chosen.push_back(static_cast<std::size_t>(found - registers_.begin()));
        if (found == registers_.end()) {
            registers_.push_back(each);
        }
    }
    return chosen;
}

std::string unit_reader::leave_out_menu_numbers()
{
    std::vector<std::string_view> views{wish_.words.begin(), wish_.words.end()};
    views.insert(views.end(), wish_.plots.begin(), wish_.plots.end());
    std::ranges::transform(wish_.limits, std::back_inserter(views), &value_limit::word);
    std::string_view const number = first_menu_number(views);
    std::string const why = number.empty() ? std::string{} : ambiguity_of(number);
    auto const is_one = [](std::string const& word) {
        std::string_view const one[]{word};
        return not first_menu_number(one).empty();
    };
    std::erase_if(wish_.words, is_one);
    std::erase_if(wish_.plots, is_one);
    std::erase_if(wish_.limits, [&is_one](value_limit const& each) { return is_one(each.word); });
    return why;
}

bool unit_reader::identify(open_line& line)
{
    identity_words const who = who_is_it(line, wish_.unit.unit);
    if (who.drive.empty() and who.outcome == exit_status::port) {
        throw ended{exit_status::port, line.port().failure()};
    }
    if (who.drive.empty() and who.outcome == exit_status::no_answer and not who.has_answered) {
        return false;
    }
    std::string const unclear = who.drive.empty() and not who.is_another ? leave_out_menu_numbers() : std::string{};
    begin(who.drive.empty() ? nullptr : catalog_named(who.drive));
    shown_.note = unclear.empty() ? shown_.note : unclear;
    if (drive_ == nullptr and registers_.empty()) {
        shown_.note = "no drive of this program; say --name NAME=" + std::to_string(shown_.address) + ":DRIVE";
    }
    return true;
}

void unit_reader::round(open_line& line, clock::time_point now)
{
    if (patience_.is_due(now)) {
        line.count_in(&shown_.counts);
        bool const has_responded = (is_known_ or identify(line)) and read_state(line);
        if (has_responded) {
            read_values(line);
        } else {
            miss_values();
        }
        note_response(has_responded, clock::now());
        line.count_in(nullptr);
    }
    shown_.silent_seconds = std::chrono::duration<double>(clock::now() - last_response_).count();
}

bool unit_reader::read_state(open_line& line)
{
    if (not state_reader_) {
        return true; // not a drive: its registers tell whether it responds
    }
    state_reader_->read(line, wish_.unit.unit);
    auto const word = state_reader_->at(drive_->layout.eta);
    if (word) {
        shown_.unread.clear();
        auto const state = rtuwire::cia402::decode(*word);
        shown_.state = std::string{std::string_view{rtuwire::cia402::name_of(state)}};
        shown_.is_local = not rtuwire::altivar::status_word{*word}.has(rtuwire::altivar::status_bit::remote);
        shown_.fault = rtuwire::cia402::is_in_fault(state) ? "its number is not read yet" : "";
    } else if (rtuwire::is_exception(word.error())) {
        // It responds: what it said before is not what it says now.
        shown_.unread = words_of(word.error());
        shown_.state.clear();
        shown_.fault.clear();
        shown_.is_local = false;
    }
    return not is_silence(state_reader_->first_error());
}

void unit_reader::read_values(open_line& line)
{
    reader_->read(line, wish_.unit.unit, true);
    if (drive_ != nullptr and not shown_.fault.empty()) {
        auto const word = reader_->at(drive_->layout.lft);
        register_entry const* const entry = drive_->at(drive_->layout.lft);
        shown_.fault = word and entry != nullptr ? text_of(*entry, *word) : "its number could not be read";
    }
    for (std::size_t i = 0; i < registers_.size(); ++i) {
        note_value(i);
    }
    shown_.add_time(std::chrono::duration<double>(clock::now() - began_).count());
}

void unit_reader::note_value(std::size_t which)
{
    tool::reading const it = reading_of(registers_[which], *reader_, drive_);
    shown_value& value = shown_.values[which];
    shown_before& before = before_[which];
    value.text = it.text;
    value.is_bad = not it.is_read;
    double const sample = it.is_read ? sample_of(it.value) : NAN;
    if (has_curve(registers_[which])) {
        value.add_sample(sample);
    }
    if (before.limit) {
        value.outside = it.is_read ? outside_text(*before.limit, sample, it.measure) : "not read: " + it.text;
    }
    auto const now = clock::now();
    if (before.text != it.text) {
        before.changed = before.text.empty() ? before.changed : now;
        before.text = it.text;
    }
    value.unchanged = before.changed ? std::chrono::duration<double>(now - *before.changed).count() : HUGE_VAL;
}

/// A gap in each curve.
void unit_reader::miss_values()
{
    for (shown_value& each : shown_.values) {
        if (not each.samples.empty()) {
            each.add_sample(NAN);
        }
    }
    shown_.add_time(std::chrono::duration<double>(clock::now() - began_).count());
}

void unit_reader::note_response(bool has_responded, clock::time_point now)
{
    if (has_responded and not state_reader_) {
        has_responded = not is_silence(reader_->first_error());
    }
    patience_.note(has_responded, now);
    if (has_responded) {
        shown_.link = link_state::linked;
        last_response_ = now;
        return;
    }
    shown_.link = patience_.is_silent() ? link_state::lost : shown_.link;
}

} // namespace tool

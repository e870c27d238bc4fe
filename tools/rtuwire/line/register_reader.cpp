// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/register_reader.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace tool {

using rtuwire::errc;

namespace {

/// What a response has, as words; or why there is none.
struct words_read {
    errc why;
    std::vector<std::uint16_t> words;
};

template <typename Request, typename Values>
words_read words_by(open_line& line, unit_address unit, bool is_sent_once, Request const& request, Values values)
{
    auto const outcome = is_sent_once ? line.ask_once(rtuwire::unit_id{unit}, request) : line.ask(unit, request);
    words_read read{outcome.error(), {}};
    for (std::size_t i = 0; outcome and i < request.count; ++i) {
        read.words.push_back(static_cast<std::uint16_t>(values(*outcome)[i]));
    }
    return read;
}

words_read words_of(open_line& line, unit_address unit, register_space space, std::uint16_t start, std::uint16_t count,
                    bool is_sent_once = false)
{
    auto const registers = [](auto const& response) { return response.registers; };
    switch (space) {
    case register_space::holding: break;
    case register_space::input:
        return words_by(line, unit, is_sent_once, rtuwire::read_input_registers{.start = start, .count = count},
                        registers);
    case register_space::coil:
        return words_by(line, unit, is_sent_once, rtuwire::read_coils{.start = start, .count = count},
                        [](auto const& response) { return response.coils; });
    case register_space::discrete:
        return words_by(line, unit, is_sent_once, rtuwire::read_discrete_inputs{.start = start, .count = count},
                        [](auto const& response) { return response.inputs; });
    }
    return words_by(line, unit, is_sent_once, rtuwire::read_holding_registers{.start = start, .count = count},
                    registers);
}

held_words held_of(words_read read, open_line const& line)
{
    return {read.why, std::move(read.words), read.why == errc::none ? std::string{} : line.words_of_failure(read.why)};
}

} // namespace

held_words read_run(open_line& line, unit_address unit, register_space space, std::uint16_t start, std::uint16_t count)
{
    return held_of(words_of(line, unit, space, start, count), line);
}

held_words read_place(open_line& line, unit_address unit, place const& where)
{
    return read_run(line, unit, where.space, where.address, where.size());
}

held_words look_at_place(open_line& line, unit_address unit, place const& where)
{
    return held_of(words_of(line, unit, where.space, where.address, where.size(), true), line);
}

register_reader::register_reader(std::vector<chosen_register> const& chosen, vocabulary const& known)
    : drive_{known.drive}, names_{known.names}
{
    std::set<run> runs;
    for (chosen_register const& each : chosen) {
        runs.insert(run_of(each.where));
        if (each.entry != nullptr and drive_ != nullptr and not each.entry->steps_set_by.empty()) {
            if (register_entry const* const other = drive_->by_code(each.entry->steps_set_by)) {
                runs.insert(run_of({other->address}));
            }
        }
    }
    for (run const& each : runs) {
        add(each);
    }
}

register_reader::run register_reader::run_of(place const& where) { return {where.space, where.address, where.size()}; }

/// From the first to the last of them; runs may overlap.
register_reader::run register_reader::whole(block const& which)
{
    unsigned const end = std::ranges::max(which, {}, &run::end).end();
    return {which[0].space, which[0].start, static_cast<std::uint16_t>(end - which[0].start)};
}

bool register_reader::may_reach(run const& from, run const& to) const
{
    for (unsigned each = from.end(); each < to.start; ++each) {
        if (drive_ == nullptr or from.space != register_space::holding or
            drive_->at(static_cast<std::uint16_t>(each)) == nullptr) {
            return false;
        }
    }
    return true;
}

unsigned register_reader::limit_of(register_space space) const
{
    if (space >= register_space::coil) {
        return rtuwire::max_bit_quantity;
    }
    bool const is_of_drive = drive_ != nullptr and space == register_space::holding;
    unsigned const most =
        names_ == nullptr ? rtuwire::max_read_quantity : names_->max_registers.value_or(rtuwire::max_read_quantity);
    return is_of_drive ? drive_->limits.read : most;
}

void register_reader::add(run const& one)
{
    if (not blocks_.empty() and blocks_.back()[0].space == one.space) {
        run const last = whole(blocks_.back());
        unsigned const size = std::max(last.end(), one.end()) - last.start;
        if (size <= limit_of(one.space) and may_reach(last, one)) {
            blocks_.back().push_back(one);
            return;
        }
    }
    blocks_.push_back({one});
}

errc register_reader::ask(open_line& line, unit_address unit, block const& which)
{
    run const all = whole(which);
    ++asked_;
    words_read const read = words_of(line, unit, all.space, all.start, all.count);
    std::string const failure = read.why == errc::none ? std::string{} : line.words_of_failure(read.why);
    for (run const& each : which) {
        held_words one{read.why, {}, failure};
        if (read.why == errc::none) {
            auto const first = read.words.begin() + (each.start - all.start);
            one.words.assign(first, first + each.count);
        }
        held_.insert_or_assign(each, std::move(one));
        last_turn_.insert(each);
    }
    return read.why;
}

/// What refuses a block, or takes none so long, may tell halves of it.
errc register_reader::read_parts(open_line& line, unit_address unit, block const& which, std::vector<block>& learned)
{
    errc const why = ask(line, unit, which);
    bool const may_be_read_in_parts = why == errc::illegal_data_value or why == errc::illegal_data_address;
    if (which.size() < 2 or not may_be_read_in_parts) {
        learned.push_back(which);
        return why;
    }
    auto const middle = which.begin() + static_cast<std::ptrdiff_t>(which.size() / 2);
    errc const first = read_parts(line, unit, {which.begin(), middle}, learned);
    errc const second = read_parts(line, unit, {middle, which.end()}, learned);
    return first != errc::none ? first : second;
}

void register_reader::fail(block const& which, errc why, std::string const& failure)
{
    for (run const& each : which) {
        held_.insert_or_assign(each, held_words{why, {}, failure});
        last_turn_.insert(each);
    }
}

/// The first block, or its parts, go to the end.
errc register_reader::read_next(open_line& line, unit_address unit, bool ends_at_silence)
{
    block const next = blocks_.front();
    blocks_.erase(blocks_.begin());
    --left_;
    errc const outcome = read_parts(line, unit, next, blocks_);
    if (status_of(outcome) == exit_status::port) {
        begin_anew();
        throw ended{exit_status::port, line.port().failure()};
    }
    auto const failed = std::ranges::find(next, outcome, [this](run const& one) { return held_[one].why; });
    std::string const failure = failed == next.end() ? tool::words_of(outcome) : held_[*failed].failure;
    if (first_error_ == errc::none and outcome != errc::none) {
        first_error_ = outcome;
        first_failure_ = failure;
    }
    if (ends_at_silence and status_of(outcome) == exit_status::no_answer) {
        std::for_each_n(blocks_.begin(), std::exchange(left_, 0),
                        [&](block const& each) { fail(each, outcome, failure); });
    }
    return outcome;
}

void register_reader::begin_turn()
{
    first_error_ = errc::none;
    first_failure_.clear();
    last_turn_.clear();
}

void register_reader::read(open_line& line, unit_address unit, bool ends_at_silence)
{
    begin_turn();
    for (left_ = blocks_.size(); left_ > 0;) {
        read_next(line, unit, ends_at_silence);
    }
}

bool register_reader::read_on(open_line& line, unit_address unit)
{
    begin_turn();
    left_ = left_ == 0 ? blocks_.size() : left_;
    auto const sent = line.exchange().sent() - asked_;
    for (bool ends = false; not ends;) {
        errc const outcome = read_next(line, unit, true);
        was_repeated_ = line.exchange().sent() - asked_ != sent;
        bool const has_come = outcome == errc::none or is_refusal_of_unit(outcome);
        ends = left_ == 0 or (was_repeated_ and has_come and drive_ == nullptr);
    }
    return left_ == 0;
}

held_words const& register_reader::held(place const& where) const
{
    static held_words const nothing{.failure = tool::words_of(errc::invalid_address_range)};
    auto const found = held_.find(run_of(where));
    return found == held_.end() ? nothing : found->second;
}

rtuwire::result<std::uint16_t> register_reader::at(std::uint16_t address) const
{
    held_words const& one = held({address});
    return one.why == errc::none ? rtuwire::result<std::uint16_t>{one.words[0]} : one.why;
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

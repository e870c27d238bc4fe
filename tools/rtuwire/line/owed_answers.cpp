// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/owed_answers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "frame/frame_fit.hpp"
#include "line/line_words.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::function_code;

std::byte function_of(byte_view frame) { return frame[1] & std::byte{0x7F}; }
function_code code_of(std::byte function) { return static_cast<function_code>(function); }

/// How many registers are asked for; 0 where it is not known.
unsigned registers_in(byte_view frame)
{
    bool const counts = frame.size() == 8 and (frame[1] == std::byte{3} or frame[1] == std::byte{4});
    return counts ? tool::word_at(frame, 4) : 0;
}

std::vector<std::byte> read_of(std::byte function, byte_view from, unsigned count)
{
    return {function, from[2], from[3], std::byte{0}, static_cast<std::byte>(count)};
}

bool may_write(std::byte function)
{
    using enum function_code;
    constexpr rtuwire::function_set writing{
        write_single_coil,   write_single_register,         write_multiple_coils, write_multiple_registers,
        mask_write_register, read_write_multiple_registers, write_file_record};
    return writing.contains(code_of(function));
}

bool is_answer(byte_view request, byte_view frame)
{
    auto const found = rtuwire::check_response(request, rtuwire::adu{frame});
    return found == rtuwire::errc::none or rtuwire::is_exception(found);
}

rtuwire::byte_view whole(byte_view frame)
{
    return frame.size() >= rtuwire::min_adu_size and rtuwire::check_frame(frame) == rtuwire::errc::none ? frame
                                                                                                        : byte_view{};
}

} // namespace

void owed_answers::begin(rtuwire::client_options const& options, bool has_numbers)
{
    using std::chrono::microseconds;
    timeout_ = microseconds{options.response_timeout.microseconds};
    constexpr int times = 10;
    constexpr std::chrono::seconds least{5};
    longest_ = std::max<clock::duration>(times * (timeout_ + microseconds{options.late_response.microseconds}), least);
    tries_ = 1U + options.retries;
    has_numbers_ = has_numbers;
}

void owed_answers::note(rtuwire::traced_frame const& frame)
{
    using rtuwire::frame_verdict;
    auto const now = clock::now();
    if (not frame.is_own) {
        return note_heard_bytes(frame, now);
    }
    if (frame.verdict != frame_verdict::good or frame.bytes.size() < rtuwire::min_adu_size) {
        return;
    }
    answered_.clear();
    was_late_ = false;
    if (std::byte const unit = frame.bytes[0]; unit != std::byte{0}) {
        unit_record& of = units_[unit];
        forget_old(of, now);
        if (has_numbers_) {
            of.owed.clear();
        }
        of.owed.push_back({{frame.bytes.begin(), frame.bytes.end()}, now});
    }
}

void owed_answers::note_unawaited(byte_view bytes)
{
    auto const now = clock::now();
    if (now - unawaited_at_ > longest_gap) {
        unawaited_.clear();
    }
    unawaited_at_ = now;
    unawaited_.insert(unawaited_.end(), bytes.begin(), bytes.end());
    auto const end = note_answers_in(unawaited_, now);
    // What is left of several answers may be the begin of another.
    std::size_t const most = rtuwire::max_adu_size;
    auto const over = std::max(end, unawaited_.size() - std::min(unawaited_.size(), most));
    unawaited_.erase(unawaited_.begin(), unawaited_.begin() + static_cast<std::ptrdiff_t>(over));
    if (end == 0) {
        note_heard(now);
    }
}

void owed_answers::note_heard_bytes(rtuwire::traced_frame const& heard, clock::time_point now)
{
    if (not whole(heard.bytes).empty()) {
        return note_response(heard.bytes, heard.verdict, now);
    }
    if (note_answers_in(heard.bytes, now) == 0) {
        note_heard(now);
    }
}

/// What came while nobody waited may be several answers in one lump. Where the last of them ends; 0 where there is none.
std::size_t owed_answers::note_answers_in(byte_view heard, clock::time_point now)
{
    std::size_t end = 0;
    for (byte_view rest = heard; not rest.empty();) {
        bool const is_unit = units_.count(rest[0]) > 0;
        std::size_t const size = is_unit ? frame_at_begin(rest, rtuwire::frame_role::response) : 0;
        if (size > 0) {
            note_response(rest.first(size), rtuwire::frame_verdict::stray, now);
        }
        rest = rest.subspan(std::max(size, std::size_t{1}));
        end = size > 0 ? heard.size() - rest.size() : end;
    }
    return end;
}

/// In their order: whatever it answers, none is owed that was asked before the first that it may answer.
void owed_answers::note_response(byte_view bytes, rtuwire::frame_verdict verdict, clock::time_point now)
{
    using rtuwire::frame_verdict;
    auto const unit = units_.find(bytes[0]);
    if (unit == units_.end()) {
        return;
    }
    unit_record& of = unit->second;
    forget_old(of, now);
    of.heard = now;
    of.answered.insert(function_of(bytes));
    of.unanswered.erase(function_of(bytes));
    // Of a size that its own bytes contradict it answers the first request of its function, as far as anybody can tell.
    bool const has_form = verdict != frame_verdict::damaged;
    auto const may_be_of = [&](sending const& each) {
        return has_form ? is_answer(each.frame, bytes) : function_of(each.frame) == function_of(bytes);
    };
    bool const is_awaited = verdict == frame_verdict::good;
    // One that is awaited, and may be of several: not of one so old that its answer will not come any more.
    clock::time_point const oldest = now - may_come_for(of);
    auto first = std::ranges::find_if(
        of.owed, [&](sending const& each) { return may_be_of(each) and (not is_awaited or each.at > oldest); });
    first = first == of.owed.end() ? std::ranges::find_if(of.owed, may_be_of) : first;
    bool const was_passed_over = std::ranges::any_of(
        of.passed_over, [&](sending const& each) { return has_form and is_answer(each.frame, bytes); });
    if (was_passed_over and not is_awaited) {
        was_late_ = true;
        return note_unasked(of, bytes, now);
    }
    if (first == of.owed.end() and is_awaited and not of.owed.empty()) {
        first = of.owed.end() - 1;
    }
    if (first == of.owed.end()) {
        if (not is_awaited) {
            note_unasked(of, bytes, now);
        }
        return;
    }
    if (is_awaited) {
        answered_ = first->frame;
        frame_bytes& longest = of.longest[bytes[1]]; // of an exception there is none
        longest = registers_in(answered_) > registers_in(longest) ? answered_ : longest;
    } else if (has_form) {
        note_late(of, first->at, now);
        was_late_ = true;
    }
    if (of.is_out_of_order) {
        of.owed.erase(first);
    } else {
        of.passed_over.insert(of.passed_over.end(), of.owed.begin(), first);
        of.owed.erase(of.owed.begin(), first + 1);
    }
}

void owed_answers::note_late(unit_record& of, clock::time_point asked, clock::time_point now) const
{
    of.latest = now - asked;
    of.latest_of_all = std::max(of.latest_of_all, now - asked);
}

/// What answers nothing that is owed: one that was passed over, or the answer to a later request, in whose place that one came.
void owed_answers::note_unasked(unit_record& of, byte_view frame, clock::time_point now) const
{
    auto const its = std::ranges::find_if(of.passed_over, [&](sending const& each) {
        return is_answer(each.frame, frame) or function_of(each.frame) == function_of(frame);
    });
    if (its != of.passed_over.end()) {
        note_late(of, its->at, now);
        of.is_out_of_order = true;
        of.passed_over.clear();
    }
    if (of.is_out_of_order) {
        of.unasked_at = now;
        of.rests_until = now + longest_of(of);
    }
}

owed_answers::clock::duration owed_answers::longest_of(unit_record const& of) const
{
    return std::min(longest_, std::max<clock::duration>(2 * of.latest_of_all, timeout_ + longest_lateness));
}

owed_answers::clock::duration owed_answers::may_come_for(unit_record const& of) const
{
    constexpr std::chrono::milliseconds more{500};
    auto const latest = std::chrono::duration_cast<clock::duration>(of.latest);
    return std::min(longest_, std::max<clock::duration>(timeout_ + longest_lateness, latest + more));
}

void owed_answers::note_heard(clock::time_point now)
{
    for (auto& [unit, of] : units_) {
        forget_old(of, now);
        of.heard = now;
    }
}

void owed_answers::forget_old(unit_record& of, clock::time_point now) const
{
    if (of.is_out_of_order and now - of.unasked_at > trusted_again) {
        of.is_out_of_order = false;
        of.latest_of_all = {};
    }
    clock::duration const out_of_order = longest_of(of);
    std::erase_if(of.passed_over, [&](sending const& each) { return now - each.at > longest_; });
    std::erase_if(of.owed, [&](sending const& each) {
        return of.is_out_of_order ? now - each.at > out_of_order : now - std::max(each.at, of.heard) > longest_;
    });
}

bool owed_answers::hides(byte_view question)
{
    auto const unit = units_.find(question[0]);
    if (unit == units_.end() or may_write(function_of(question)) or has_numbers_) {
        return false;
    }
    auto const now = clock::now();
    forget_old(unit->second, now);
    return now < unit->second.rests_until or std::ranges::any_of(unit->second.owed, [&](sending const& each) {
               return function_of(each.frame) == function_of(question);
           });
}

std::map<std::byte, owed_answers::clock::time_point> owed_answers::functions_owed(std::byte unit) const
{
    std::map<std::byte, clock::time_point> functions;
    auto const found = units_.find(unit);
    if (found == units_.end()) {
        return functions;
    }
    unit_record const& of = found->second;
    clock::duration const most = may_come_for(of);
    for (auto const* const each : {&of.owed, &of.passed_over}) {
        for (sending const& one : *each) {
            clock::time_point& until = functions[function_of(one.frame)];
            until = std::max(until, one.at + most);
        }
    }
    return functions;
}

owed_answers::clock::time_point owed_answers::rests_until(std::byte unit) const
{
    auto const found = units_.find(unit);
    return found == units_.end() ? clock::time_point{} : found->second.rests_until;
}

bool owed_answers::is_late(std::byte unit) const
{
    auto const found = units_.find(unit);
    return found != units_.end() and found->second.latest > timeout_;
}

bool owed_answers::owes_registers(unit_record const& of, std::byte function, unsigned count)
{
    return std::ranges::any_of(of.owed, [&](sending const& each) {
        return function_of(each.frame) == function and registers_in(each.frame) == count;
    });
}

/// By the same function, a part of what the unit has answered before, of a size that no answer which it owes has; empty where
/// there is none.
owed_answers::frame_bytes owed_answers::part_of_known(unit_record const& of, std::byte function)
{
    auto const known = of.longest.find(function);
    for (unsigned count = known == of.longest.end() ? 0 : registers_in(known->second); count > 0; --count) {
        if (not owes_registers(of, function, count)) {
            return read_of(function, known->second, count);
        }
    }
    return {};
}

/// Twice as many registers, which may be more than there are.
owed_answers::frame_bytes owed_answers::longer_read(unit_record const& of, byte_view question)
{
    unsigned const registers = registers_in(question);
    unsigned const other = 2 * registers <= rtuwire::max_read_quantity ? 2 * registers : registers / 2;
    std::byte const function = function_of(question);
    return other == 0 or owes_registers(of, function, other) ? frame_bytes{} : read_of(function, question, other);
}

/// Whether the answer to a function could be one that the unit owes since before it was last asked by another one.
bool owed_answers::is_ambiguous(unit_record const& of, std::byte function, std::byte asked)
{
    auto const is_by = [](std::byte which) {
        return [which](sending const& each) { return function_of(each.frame) == which; };
    };
    return std::any_of(std::find_if(of.owed.rbegin(), of.owed.rend(), is_by(asked)), of.owed.rend(), is_by(function));
}

owed_answers::frame_bytes owed_answers::mark_for(byte_view question)
{
    unit_record const& of = units_.at(question[0]);
    std::byte const asked = function_of(question);
    constexpr std::byte none[]{std::byte{0}, std::byte{0}, std::byte{0}, std::byte{0}};
    byte_view const place = asked <= std::byte{4} and question.size() == 8 ? question : byte_view{none};
    auto const read_one = [&](std::uint8_t usual, std::uint8_t other) {
        return read_of(std::byte{asked == std::byte{usual} ? other : usual}, place, 1);
    };
    ++nonce_;
    frame_bytes const all[]{
        part_of_known(of, asked),
        read_one(4, 3),
        longer_read(of, question),
        {std::byte{8}, std::byte{0}, std::byte{0}, static_cast<std::byte>(nonce_ >> 8U),
         static_cast<std::byte>(nonce_ & 0xFFU)},
        {std::byte{0x2B}, std::byte{0x0E}, std::byte{1}, std::byte{0}},
        read_one(2, 1),
    };
    // First what the unit is known to answer, then what it was seldom silent to, in the order of what most units answer.
    auto const cost = [&](frame_bytes const& pdu) -> unsigned {
        constexpr unsigned never = 1'000, seldom = 100;
        if (pdu.empty()) {
            return never;
        }
        bool const is_known = pdu[0] == asked ? &pdu == all : of.answered.contains(pdu[0]);
        auto const silent = of.unanswered.find(pdu[0]);
        return (is_known                        ? 0U
                : silent == of.unanswered.end() ? 1U
                                                : 1U + silent->second) +
               (pdu[0] != asked and is_ambiguous(of, pdu[0], asked) ? seldom : 0U);
    };
    return frame_of(question[0], *std::ranges::min_element(all, {}, cost));
}

void owed_answers::note_unanswered(byte_view mark) { ++units_[mark[0]].unanswered[function_of(mark)]; }

bool owed_answers::has_answered(byte_view request) const
{
    return request[0] == std::byte{0} or std::ranges::equal(answered_, request);
}

void owed_answers::note_question(byte_view question, bool is_asked)
{
    asked_unit_ = question[0];
    was_asked_ = is_asked;
}

std::string owed_answers::words_of_silence(option_form form) const
{
    auto const unit = units_.find(asked_unit_);
    if (unit == units_.end()) {
        return {};
    }
    double const latest = unit->second.latest.count();
    std::string const not_asked =
        was_asked_ ? "" : "; not asked: a late answer of this unit could be taken for this one";
    if (not is_late(asked_unit_)) {
        return not_asked +
               (was_asked_ ? "" : "; a longer " + option_words(form, line_option::timeout) + " waits for it");
    }
    return "; its answers come too late, the last after " + longer_timeout(latest, form) + not_asked;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes registers, and reads them back. All words are checked before the first frame leaves; what commands a motor is
// refused: `start` and `stop` do that.
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "commands/device_commands.hpp"
#include "line/asked_registers.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/raw_request.hpp"
#include "line/reading.hpp"
#include "line/who_is_it.hpp"
#include "line/write_log.hpp"
#include "motion/checked_values.hpp"
#include "motion/moving_registers.hpp"
#include "motion/question.hpp"
#include "motion/raw_effect.hpp"
#include "motion/unsafe_write.hpp"
#include "motion/value_sender.hpp"
#include "output/plain_text.hpp"
#include "words/value_block.hpp"
#include "words/value_words.hpp"

namespace tool {

namespace {

using rtuwire::errc;

constexpr char const* unknown = "unknown"; ///< in the log and on the screen: what could not be read

/// What a unit holds in words; nothing where it could not be read.
using held_text = std::optional<std::string>;

/// What it held before a write.
struct held_before {
    held_text text{};
    std::vector<std::uint16_t> words{}; ///< of bits those of all their register; empty where it could not be read
    std::string note{};                 ///< where that is not what somebody confirmed
};

constexpr char const* not_tried = "not tried";

/// What is told of a value.
struct shown_value {
    value_to_write const* value;
    held_text before;
    held_text after;
    std::string error{};
    std::string note{};
    bool is_only_read{false};
};

/// What one request writes.
struct value_request {
    value_list values;
    std::vector<held_before> before;

    [[nodiscard]] bool is_of_coils() const { return values[0].where.is_single_bit(); }
};

std::vector<value_request> requests_of(value_list const& values, std::vector<held_before> const& before)
{
    std::vector<value_request> requests;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (not values[i].is_with_previous) {
            requests.emplace_back();
        }
        requests.back().values.push_back(values[i]);
        requests.back().before.push_back(before[i]);
    }
    return requests;
}

std::string shown(held_text const& text) { return text.value_or(unknown); }

class writing {
public:
    /// Of the words that were typed, or of values that are ready.
    explicit writing(choices const& chosen, std::vector<value_to_write> given = {})
        : chosen_{chosen}, unit_{unit_to_change(chosen)}, given_{std::move(given)}, results_{chosen.form, true}
    {
        results_.need_reader();
    }

    exit_status run()
    {
        refuse_wrong_log();
        open_line line{chosen_.line};
        return run(line);
    }

    exit_status run(open_line& line)
    {
        rules_ = rules_to_write(line, unit_, chosen_.allowed);
        refuse_menu_number();
        std::vector<value_to_write> const values = checked(line);
        then_read_ = read_behind(values);
        if (std::optional<ended> const why = why_not(values, line)) {
            throw ended{*why};
        }
        std::vector<held_before> before = read(line, values);
        if (is_asked(chosen_.allowed)) {
            if (not is_confirmed(values, before)) {
                return exit_status::refused;
            }
            if (not(rules_to_write(line, unit_, chosen_.allowed) == rules_)) {
                throw ended{exit_status::refused, "another unit answers than when you were asked; nothing is written"};
            }
            refuse_changed_values(values, checked(line));
            before = read_again(line, values, before);
        }
        note_signals();
        exit_status status = exit_status::done;
        for (value_request const& each : requests_of(values, before)) {
            if (status == exit_status::done and noted_signal() != 0) { // between two of them: what was begun is told
                status = static_cast<exit_status>(128 + noted_signal());
            }
            if (status == exit_status::done) {
                status = write(line, each);
            } else {
                show_unwritten(each, {}, not_tried);
            }
        }
        return status;
    }

private:
    std::vector<value_to_write> checked(open_line& line) const
    {
        if (not given_.empty()) {
            refuse_unsafe_values(given_, rules_, chosen_);
        }
        std::vector<value_to_write> values =
            given_.empty() ? checked_values(chosen_.words, line, unit_, rules_, chosen_) : given_;
        for (value_request const& each : requests_of(values, std::vector<held_before>(values.size()))) {
            refuse_frame_within(each.values);
        }
        return values;
    }

    void refuse_frame_within(value_list const& values) const
    {
        if (rules_.drive == nullptr) {
            tool::refuse_frame_within(unit_.unit, values);
        }
    }

    /// What function 23 reads behind its write: of one word, and of what is no drive.
    value_list read_behind(value_list const& values) const
    {
        value_list wanted;
        if (chosen_.then_read.empty()) {
            return wanted;
        }
        bool const is_one_write = std::ranges::count(values, false, &value_to_write::is_with_previous) == 1 and
                                  not values[0].where.is_single_bit() and values[0].where.bit < 0;
        if (rules_.drive != nullptr or not is_one_write) {
            refuse_word(
                "--then-read: function 23 writes the registers of one word, 40=5 or 40-41=1,2, of what is no drive");
        }
        std::vector<chosen_register> const registers = registers_in(chosen_.then_read, {nullptr, unit_.names});
        std::string const why = why_no_neighbours(registers, rtuwire::max_exchange_read_quantity);
        if (not why.empty() or registers[0].where.space != register_space::holding) {
            refuse_word("--then-read: " + (why.empty() ? "function 23 reads holding registers only" : why));
        }
        for (chosen_register const& each : registers) {
            wanted.push_back({.where = each.where, .named = each.named});
        }
        std::vector<std::byte> const bytes = bytes_of(values);
        std::array<std::byte, rtuwire::max_adu_size> memory{};
        auto const frame = rtuwire::encode_into(memory, unit_.unit, exchange_of(values, bytes, wanted));
        if (not frame) {
            refuse_word("--then-read: function 23 writes at most " +
                        std::to_string(rtuwire::max_exchange_write_quantity) + " registers");
        }
        tool::refuse_frame_within(*frame, functions_within::public_ones);
        return wanted;
    }

    static rtuwire::read_write_multiple_registers<> exchange_of(value_list const& values, rtuwire::byte_view bytes,
                                                                value_list const& wanted)
    {
        place const& first = wanted.front().where;
        place const& last = wanted.back().where;
        return {first.address, static_cast<std::uint16_t>(last.address + last.size() - first.address),
                values[0].where.address, rtuwire::register_view{bytes}};
    }

    /// Of a unit that was said to be no drive, a number is an address; where it is or may be one, it may mean another register.
    void refuse_menu_number() const
    {
        bool const has_two_meanings = unit_.drive == no_drive and (rules_.drive != nullptr or rules_.command);
        for (std::string const& word : chosen_.words) {
            std::string_view const name = std::string_view{word}.substr(0, word.find('='));
            std::string_view const number = first_menu_number({&name, 1});
            bool const is_of_menu = rules_.drive == nullptr or rules_.drive->by_menu(number) != nullptr;
            if (has_two_meanings and not number.empty() and is_of_menu) {
                refuse_word(ambiguity_of(number));
            }
        }
    }

    std::optional<ended> why_not(std::vector<value_to_write> const& values, open_line& line) const
    {
        return rules_.drive == nullptr ? std::nullopt
                                       : why_not_now(values, line, unit_.unit, *rules_.drive, chosen_.allowed);
    }

    std::vector<held_before> read(open_line& line, std::vector<value_to_write> const& values)
    {
        std::vector<chosen_register> all;
        for (value_to_write const& each : values) {
            all.push_back({each.where, each.entry, each.named});
        }
        register_reader reader{all, {rules_.drive, unit_.names}};
        reader.read(line, unit_.unit);
        std::vector<held_before> before;
        for (chosen_register const& each : all) {
            reading const it = reading_of(each, reader, rules_.drive);
            before.push_back(it.is_read ? held_before{it.text, reader.held(each.where).words} : held_before{});
        }
        return before;
    }

    /// What is overwritten is what stands there behind the question.
    std::vector<held_before> read_again(open_line& line, std::vector<value_to_write> const& values,
                                        std::vector<held_before> const& asked)
    {
        std::vector<held_before> now = read(line, values);
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (now[i].text != asked[i].text) {
                now[i].note = "it was " + shown(asked[i].text) + " when you were asked";
            }
        }
        return now;
    }

    bool is_confirmed(std::vector<value_to_write> const& values, std::vector<held_before> const& before) const
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::string const line =
                label_of({values[i].where, values[i].entry}) + ": " + shown(before[i].text) + " -> " + values[i].text;
            std::fprintf(stderr, "unit %u: %s\n", unsigned{unit_.unit.byte()}, plain_text(line).c_str());
        }
        return is_answered_yes("write?");
    }

    /// Writes, and says what the unit holds then: what was read back, whatever was answered to the write. Since the values
    /// were checked somebody was asked, and others were written: a motor may run by now.
    exit_status write(open_line& line, value_request const& request)
    {
        value_list const& values = request.values;
        std::optional<ended> why = why_not(values, line);
        if (std::string const log = why ? std::string{} : why_nothing_can_be_noted(values.size()); not log.empty()) {
            why.emplace(exit_status::port, "nothing could be noted: " + log);
        }
        if (why) {
            show_unwritten(request, request.before, std::string{"not written: "} + why->what());
            return why->status;
        }
        // Of bits, that the others stay is looked at: those of a value before it are written by now.
        std::vector<held_before> const before = values[0].where.bit >= 0 ? read(line, values) : request.before;
        std::string how;
        std::vector<std::uint16_t> words;
        errc const outcome = then_read_.empty() ? sender(line).send(values, how) : exchange(line, values, words);
        std::string const failure = line.words_of_failure(outcome) +
                                    hint_at_list({values[0].where, values[0].entry}, outcome) +
                                    remedy_of(values, outcome);
        std::vector<held_words> const held = read_back(line, values, outcome, failure);
        exit_status status = exit_status::done;
        std::vector<shown_value> rows;
        std::string missed;
        for (std::size_t i = 0; i < values.size(); ++i) { // all of them are noted before one is shown
            rows.push_back({&values[i], before[i].text, {}, {}, how});
            exit_status const one = judge(rows.back(), before[i], held[i], outcome, failure, missed);
            append(rows.back().note, request.before[i].note);
            status = status == exit_status::done ? one : status;
        }
        for (value_to_write const& each : then_read_) {
            auto const first = words.begin() + (words.empty() ? 0 : each.where.address - then_read_[0].where.address);
            std::vector<std::uint16_t> const own{first, first + (words.empty() ? 0 : each.where.size())};
            rows.push_back({&each,
                            {},
                            own.empty() ? held_text{} : each.text_of_words(own),
                            own.empty() ? failure : "",
                            "read by the same request",
                            true});
        }
        show(rows);
        return missed.empty() or status != exit_status::done ? status : exit_status::port;
    }

    value_sender sender(open_line& line) const
    {
        return {line, unit_.unit, rules_.drive != nullptr, chosen_.line.retries > 0, chosen_.may_rewrite};
    }

    /// By function 23; what it read.
    errc exchange(open_line& line, value_list const& values, std::vector<std::uint16_t>& words) const
    {
        std::vector<std::byte> const bytes = bytes_of(values);
        auto const request = exchange_of(values, bytes, then_read_);
        rtuwire::unit_id const unit{unit_.unit};
        auto once = line.with(request_once<rtuwire::read_write_multiple_registers<>>{unit, request});
        auto again = line.with(rtuwire::single_request{unit, request});
        auto const outcome = chosen_.line.retries > 0 ? line.run(again) : line.run(once);
        for (std::size_t i = 0; outcome and i < request.read_count; ++i) {
            words.push_back(rtuwire::register_view{outcome->pdu().subspan(2)}[i]);
        }
        return outcome.error();
    }

    /// What the unit holds; by as many requests as it takes, each value by one. A unit that is silent meanwhile is not asked on.
    std::vector<held_words> read_back(open_line& line, value_list const& values, errc outcome,
                                      std::string const& failure) const
    {
        // An order is no value that stays, and a drive that saves is silent meanwhile.
        if (rules_.drive != nullptr and values[0].entry != nullptr and takes_orders(*values[0].entry, *rules_.drive)) {
            return {{outcome, values[0].words, failure}};
        }
        std::size_t count = 0;
        for (value_to_write const& each : values) {
            count += each.words.size();
        }
        held_words const all = read_run(line, unit_.unit, values[0].where.space, values[0].where.address,
                                        static_cast<std::uint16_t>(count));
        bool const is_in_parts =
            values.size() > 1 and (all.why == errc::illegal_data_address or all.why == errc::illegal_data_value);
        std::vector<held_words> held;
        std::size_t at = 0;
        for (value_to_write const& each : values) {
            bool const is_asked_on = is_in_parts and (held.empty() or held.back().why == errc::none or
                                                      rtuwire::is_exception(held.back().why));
            if (is_asked_on) {
                held.push_back(read_place(line, unit_.unit, each.where));
            } else {
                held.push_back(is_in_parts ? held.back() : held_words{all.why, {}, all.failure});
            }
            if (all.why == errc::none) {
                auto const first = all.words.begin() + static_cast<std::ptrdiff_t>(at);
                held.back().words.assign(first, first + static_cast<std::ptrdiff_t>(each.words.size()));
            }
            at += each.words.size();
        }
        return held;
    }

    /// What came of a value, which is noted where it may be written.
    exit_status judge(shown_value& row, held_before const& before, held_words const& held, errc outcome,
                      std::string const& failure, std::string& missed) const
    {
        value_to_write const& value = *row.value;
        bool const is_taken = outcome == errc::none;
        bool const is_read = held.why == errc::none;
        row.after = is_read ? held_text{value.text_of_words(held.words)} : std::nullopt;
        exit_status status = exit_status::done;
        if (not is_read) {
            row.error = is_taken ? held.failure : failure;
            status = status_of(is_taken ? held.why : outcome);
        } else if (not value.is_held_by(held.words)) {
            row.error = is_taken ? "the unit holds another value" : failure;
            status = is_taken ? exit_status::differs : status_of(outcome);
        } else if (is_refusal_to_write(outcome)) {
            row.error = failure;
            status = exit_status::differs;
        }
        append(row.note, is_taken or not row.error.empty() ? std::string{} : failure + ": read back");
        if (may_be_written(value, before, held, outcome)) {
            append(row.note, logged(value, before.text, row.after, missed));
        }
        if (has_changed_others(value, before, held)) {
            std::string const all[]{counts_text(before.words[0]), counts_text(held.words[0])};
            append(row.error, "other bits of the register changed: " + all[0] + " -> " + all[1]);
            status = status == exit_status::done ? exit_status::differs : status;
            value_to_write whole = value;
            whole.where = {.address = value.where.address, .space = value.where.space};
            append(row.note, logged(whole, all[0], all[1], missed));
        }
        return status;
    }

    static std::string counts_text(std::uint16_t word)
    {
        char text[8] = "";
        std::snprintf(text, sizeof text, "0x%04X", unsigned{word});
        return text;
    }

    static bool has_changed_others(value_to_write const& value, held_before const& before, held_words const& held)
    {
        return value.where.bit >= 0 and before.words.size() == 1 and held.words.size() == 1 and
               ((before.words[0] ^ held.words[0]) & ~unsigned{value.where.mask()}) != 0;
    }

    /// A unit that says that it did not write may have written all the same: what it holds tells.
    static bool may_be_written(value_to_write const& value, held_before const& before, held_words const& held,
                               errc outcome)
    {
        if (is_refusal_to_write(outcome) and held.why == errc::none) {
            return value.is_held_by(held.words) or before.words != held.words;
        }
        bool const is_before_doing = outcome == errc::illegal_function or outcome == errc::illegal_data_address or
                                     outcome == errc::illegal_data_value;
        return not is_before_doing;
    }

    /// What to do where the unit has no function that writes such a value.
    std::string remedy_of(value_list const& values, errc why) const
    {
        if (why != errc::illegal_function or rules_.drive != nullptr) {
            return {};
        }
        value_to_write const& value = values[0];
        if (not then_read_.empty()) {
            return "; the unit has no function 23: it is written by 16, and read by 03, without --then-read";
        }
        if (value.where.bit >= 0 and not chosen_.may_rewrite) {
            return "; the unit has no function 22, which changes bits alone: --read-modify-write behind write reads "
                   "the "
                   "register and writes all of it back, so that what the unit changes in between is lost";
        }
        bool const has_long_one =
            std::ranges::any_of(values, [](value_to_write const& each) { return each.words.size() > 1; });
        return has_long_one ? "; the unit has no function 16, the only one by which no half of a value of several "
                              "registers stands there"
               : values.size() == 1 ? ""
               : value.where.is_single_bit()
                   ? "; the unit has no function 15: coils that have a word each are written one by one, by 05"
                   : "; the unit has no function 16: registers that have a word each are written one by one, by 06";
    }

    /// Of what was not sent: what the unit holds, where that is known.
    void show_unwritten(value_request const& request, std::vector<held_before> const& after, std::string const& error)
    {
        std::vector<shown_value> rows;
        for (std::size_t i = 0; i < request.values.size(); ++i) {
            rows.push_back({&request.values[i], request.before[i].text, after.empty() ? held_text{} : after[i].text,
                            error, request.before[i].note});
        }
        show(rows);
    }

    /// What was done is told all the same where the output takes it no more.
    void show(std::vector<shown_value> const& rows)
    {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            try {
                put(rows[i]);
            } catch (ended const& why) {
                std::string text = why.what();
                for (std::size_t rest = i; rest < rows.size(); ++rest) {
                    text += "; unit " + std::to_string(unit_.unit.byte()) + ": " + sentence_of(rows[rest]);
                }
                throw ended{why.status, text + "; what stands behind it was not tried"};
            }
        }
    }

    static std::string note_of(shown_value const& row)
    {
        std::string all = row.error;
        append(all, row.note);
        return all;
    }

    static std::string sentence_of(shown_value const& row)
    {
        std::string const note = note_of(row);
        return label_of({row.value->where, row.value->entry}) + ": " + shown(row.before) + " -> " + shown(row.after) +
               (note.empty() ? "" : " (" + note + ')');
    }

    /// A failure is a note for people; programs have a name for it besides.
    void put(shown_value const& it)
    {
        bool const is_table = chosen_.form == output_form::table;
        record row{{"unit", std::int64_t{unit_.unit.byte()}},
                   {"register", label_of({it.value->where, it.value->entry})},
                   {"before", cell_of(it.before, is_table and not it.is_only_read)},
                   {"after", cell_of(it.after, is_table and it.error != not_tried)},
                   {"note", note_of(it)}};
        if (chosen_.form == output_form::csv or (chosen_.form == output_form::json and not it.error.empty())) {
            row.add("error", it.error.empty() ? cell{} : cell{it.error});
        }
        results_.put(row, not it.error.empty());
    }

    /// People are told that something is not known; for programs there is nothing.
    static cell cell_of(held_text const& text, bool is_told)
    {
        return text ? cell{*text} : is_told ? cell{unknown} : cell{};
    }

    static void append(std::string& note, std::string const& more)
    {
        note += (note.empty() or more.empty() ? "" : "; ") + more;
    }

    /// Notes a write; what people have to know of it. Why it could not be noted is in `missed`, too.
    std::string logged(value_to_write const& value, held_text const& before, held_text const& after,
                       std::string& missed) const
    {
        unsigned const unit = unit_.unit.byte();
        std::string const why =
            log_write({chosen_.line.port, unit, label_of({value.where, value.entry}), shown(before), shown(after)});
        std::string note = why.empty() ? std::string{} : "not noted: " + why;
        append(missed, why);
        if (value.named != nullptr and value.named->is_stored) {
            append(note, "the unit stores it, and its memory bears a limited number of writes");
        }
        if (rules_.drive != nullptr and value.where.address == rules_.drive->layout.cmi) {
            append(note, why.empty() ? "saved to EEPROM " + std::to_string(count_saves(chosen_.line.port, unit)) +
                                           " times by this user"
                                     : "how often this user has saved to EEPROM is not known");
            append(note, "an EEPROM bears a limited number of writes");
        }
        return note;
    }

    choices const& chosen_;
    named_unit unit_;
    std::vector<value_to_write> given_;
    value_list then_read_{};
    write_rules rules_{};
    output results_;
};

} // namespace

exit_status write_values(choices const& chosen, open_line& line, std::vector<value_to_write> values)
{
    choices named = chosen;
    named.words.clear();
    for (value_to_write const& each : values) {
        named.words.push_back(each.where.name);
    }
    return writing{named, std::move(values)}.run(line);
}

exit_status run_write(choices const& chosen)
{
    if (not chosen.allowed.may_write) {
        refuse_for_safety("this program only reads; to write, say --write");
    }
    return writing{chosen}.run();
}

} // namespace tool

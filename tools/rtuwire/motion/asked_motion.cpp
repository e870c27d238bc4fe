// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/asked_motion.hpp"

#include <optional>
#include <string_view>
#include <vector>

#include "catalog/value_text.hpp"
#include "line/asked_registers.hpp"
#include "line/register_reader.hpp"
#include "words/amount_words.hpp"
#include "words/value_words.hpp"

namespace tool {

namespace {

struct typed_motion {
    std::string word; ///< as it was typed, for whoever is told that it is wrong
    std::string size; ///< without its sign
    bool is_speed;
    bool is_reverse;

    char const* option() const { return is_speed ? "--speed" : "--frequency"; }
};

typed_motion typed_in(motion_choices const& typed)
{
    bool const is_speed = not typed.speed.empty();
    std::string const& word = is_speed ? typed.speed : typed.frequency;
    bool const is_negative = word.starts_with('-');
    return {word, word.substr(is_negative ? 1 : 0), is_speed, is_negative or typed.is_reverse};
}

/// What a drive's register holds, where it has been read, as a count.
std::int64_t count_in(register_reader const& from, drive_catalog const& drive, std::string_view code)
{
    register_entry const* const entry = drive.by_code(code);
    if (entry == nullptr) {
        refuse_for_safety("an " + std::string{drive.name} + " has no " + std::string{code} +
                          ", which limits the motor");
    }
    auto const word = from.at(entry->address);
    if (not word) {
        throw ended{status_of(word.error()),
                    std::string{code} + ", which limits the motor, could not be read: " + from.why_not(entry->address)};
    }
    return entry->count_of(*word);
}

/// In 0.1 Hz, as the drive works it out of its motor's nameplate.
struct hertz_range {
    std::int64_t least; ///< rounded down
    std::int64_t most;  ///< rounded up
};

hertz_range tenths_of_hertz(std::int64_t speed, std::int64_t rated_tenths, std::int64_t rated_speed)
{
    if (rated_tenths <= 0 or rated_speed <= 0) {
        refuse_for_safety("the drive's nameplate of its motor (FRS, NSP) is empty: say --frequency");
    }
    std::int64_t const pole_pairs = (rated_tenths * 6 + rated_speed / 2) / rated_speed;
    return {speed * pole_pairs / 6, (speed * pole_pairs + 5) / 6};
}

std::string hertz_text(std::int64_t tenths) { return amount_text(tenths, {1, 10}, "Hz"); }

/// `ordered` says what takes the unit: "--frequency takes".
void refuse_no_number(typed_motion const& it, std::string const& said, std::string const& ordered)
{
    std::string_view const unit = it.is_speed ? "rpm" : "Hz";
    std::string_view const other = it.is_speed ? "Hz" : "rpm";
    bool const is_number = not it.size.empty() and it.size.front() >= '0' and it.size.front() <= '9';
    amount_fault const fault = is_number ? read_amount(it.size, unit).fault : amount_fault::not_a_number;
    if (fault == amount_fault::decimal_comma) {
        refuse_word(said + ": " + decimal_comma_text);
    }
    if (fault == amount_fault::wrong_unit and read_amount(it.size, other).fault == amount_fault::none) {
        refuse_word(said + ": " + ordered + ' ' + units_for(unit) + ", not " + units_for(other));
    }
    if (fault != amount_fault::none) {
        refuse_word(said + ": a number is needed, in " + units_for(unit));
    }
}

register_entry const& reference_of(typed_motion const& it, drive_catalog const& drive)
{
    return *drive.at(it.is_speed ? drive.speed_reference : drive.frequency_reference);
}

/// In steps of the reference; refuses what is no whole number of them.
std::int64_t count_of(typed_motion const& it, register_entry const& reference, std::string const& said)
{
    typed_amount const amount = read_amount(it.size, reference.unit);
    std::int64_t const count = amount.amount.counts_below(reference.step);
    if (amount.amount.counts_above(reference.step) != count) {
        refuse_word(said + ": not a whole number of steps of " + amount_text(1, reference.step, reference.unit));
    }
    return count;
}

asked_motion motion_of(typed_motion const& it, std::int64_t count, register_entry const& reference)
{
    std::string const text = amount_text(count, reference.step, reference.unit) + (it.is_reverse ? ", reverse" : "");
    return {static_cast<std::int16_t>(count), it.is_speed, it.is_reverse, text};
}

} // namespace

std::string words_of_least(asked_motion const& asked)
{
    return asked.count == 0 and asked.is_reverse
               ? " (0 has no direction: to keep this one it turns on, at the least reference, some 0.1 Hz)"
               : "";
}

void refuse_wrong_words(motion_choices const& typed)
{
    if (typed.speed.empty() == typed.frequency.empty()) {
        refuse_word("how fast? say --speed 1200rpm or --frequency 40Hz");
    }
    typed_motion const it = typed_in(typed);
    if (it.size != it.word and typed.is_reverse) {
        refuse_word(std::string{it.option()} + ' ' + it.word + " and --reverse: say the direction once");
    }
    refuse_no_number(it, std::string{it.option()} + ' ' + it.word,
                     it.is_speed ? "--frequency takes Hz; --speed takes" : "--speed takes rpm; --frequency takes");
}

asked_motion motion_asked(motion_choices const& typed, open_line& line, rtuwire::unit_id unit,
                          drive_catalog const& drive)
{
    typed_motion const it = typed_in(typed);
    if (it.is_speed and drive.by_code("NSP") == nullptr) {
        refuse_word("an " + std::string{drive.name} + " is kept running by a frequency: say --frequency 40Hz");
    }
    std::vector<chosen_register> limits;
    for (std::string_view const code : {"LSP", "HSP", "FRS", "NSP"}) {
        if (register_entry const* const entry = drive.by_code(code)) {
            limits.push_back({{entry->address}, entry});
        }
    }
    register_reader reader{limits, &drive};
    reader.read(line, unit);
    std::int64_t const lowest = count_in(reader, drive, "LSP");
    std::int64_t const highest = count_in(reader, drive, "HSP");

    register_entry const& reference = reference_of(it, drive);
    std::string const said = std::string{it.option()} + ' ' + it.word;
    std::int64_t const count = count_of(it, reference, said);
    bool const fits = count <= reference.highest_count();
    hertz_range const tenths =
        it.is_speed and fits ? tenths_of_hertz(count, count_in(reader, drive, "FRS"), count_in(reader, drive, "NSP"))
                             : hertz_range{count, count};
    if (not fits or tenths.least < lowest or tenths.most > highest) {
        refuse_word(said + (it.is_speed and fits ? " (" + hertz_text(tenths.most) + ")" : std::string{}) +
                    ": the drive is set to run from " + hertz_text(lowest) + " (LSP) to " + hertz_text(highest) +
                    " (HSP)");
    }
    return motion_of(it, count, reference);
}

asked_motion motion_typed(std::string const& word, asked_motion const& now, drive_catalog const& drive)
{
    if (word.starts_with('-')) {
        refuse_word(word + ": the direction is the one that was ordered; stop the motor to turn it the other way");
    }
    typed_motion const it{word, word, now.is_speed, now.is_reverse};
    refuse_no_number(it, word, "it was ordered, and is changed, in");
    register_entry const& reference = reference_of(it, drive);
    std::int64_t const count = count_of(it, reference, word);
    if (count > reference.highest_count()) {
        refuse_word(word + ": above HSP, which is no more than " +
                    amount_text(reference.highest_count(), reference.step, reference.unit));
    }
    return motion_of(it, count, reference);
}

} // namespace tool

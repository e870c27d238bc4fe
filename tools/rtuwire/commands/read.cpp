// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers once.
#include <algorithm>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/asked_units.hpp"
#include "line/reading.hpp"
#include "line/who_is_it.hpp"
#include "sunspec/sunspec_read.hpp"

namespace tool {

namespace {

record for_people(reading const& it, chosen_register const& which, unit_address unit, bool is_of_several)
{
    record row;
    if (is_of_several) {
        row.add("unit", std::int64_t{unit.byte()});
    }
    return row.add("register", it.label)
        .add("address", std::int64_t{which.where.address})
        .add("value", it.text)
        .add("name", which.entry == nullptr ? std::string{} : std::string{which.entry->name});
}

record for_programs(reading const& it, chosen_register const& which, unit_address unit)
{
    record line{
        {"unit", std::int64_t{unit.byte()}}, {"register", it.label}, {"address", std::int64_t{which.where.address}}};
    if (it.is_read) {
        line.add("raw", it.raw).add("value", it.value).add("measure", it.measure).add("text", it.text);
    } else {
        line.add("error", it.text);
    }
    return line;
}

/// One unit's registers.
exit_status read_unit(asked_registers const& asked, output_form form, open_line& line, output& results,
                      bool is_of_several)
{
    if (asked.failure) {
        return asked.failure->status;
    }
    register_reader reader{asked.registers, {asked.drive, asked.unit.names}};
    reader.read(line, asked.unit.unit);
    for (chosen_register const& each : asked.registers) {
        reading const it = reading_of(each, reader, asked.drive);
        results.put(form == output_form::table ? for_people(it, each, asked.unit.unit, is_of_several)
                                               : for_programs(it, each, asked.unit.unit));
    }
    tell_another_device(line, asked.unit);
    return status_of(reader.first_error());
}

} // namespace

exit_status run_read(choices const& chosen)
{
    bool const is_sunspec_asked = std::ranges::count(chosen.words, sunspec_word) != 0;
    if (is_sunspec_asked and (chosen.words.size() > 1 or chosen.sunspec.empty())) {
        refuse_word("@sunspec stands alone, and wants --sunspec FOLDER, where model_1.json and the like are");
    }
    if (is_sunspec_asked) {
        return read_sunspec(chosen);
    }
    std::vector<named_unit> const units = units_asked(chosen.line);
    open_line line{chosen.line};
    std::vector<asked_registers> const all = registers_asked(chosen.words, units, line);
    tell_left_out(all);
    output results{chosen.form, false};
    exit_status status = exit_status::done;
    for (asked_registers const& each : all) {
        exit_status const outcome = read_unit(each, chosen.form, line, results, all.size() > 1);
        status = status == exit_status::done ? outcome : status;
    }
    results.finish();
    return status;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers once.
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/reading.hpp"
#include "monitor/watched_units.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

record for_people(reading const& it, chosen_register const& which, rtuwire::unit_id unit, bool is_of_several)
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

record for_programs(reading const& it, chosen_register const& which, rtuwire::unit_id unit)
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
exit_status read_unit(choices const& chosen, open_line& line, output& results, bool is_of_several)
{
    asked_registers const asked = registers_asked(chosen, line);
    register_reader reader{asked.registers, {asked.drive, asked.unit.names}};
    reader.read(line, asked.unit.unit);
    for (chosen_register const& each : asked.registers) {
        reading const it = reading_of(each, reader, asked.drive);
        results.put(chosen.form == output_form::table ? for_people(it, each, asked.unit.unit, is_of_several)
                                                      : for_programs(it, each, asked.unit.unit));
    }
    return status_of(reader.first_error());
}

} // namespace

exit_status run_read(choices const& chosen)
{
    bool const is_list = chosen.line.unit.find_first_of(",-") != std::string::npos;
    std::vector<named_unit> const units =
        is_list ? units_watched(chosen.line) : std::vector<named_unit>{unit_in(chosen.line)};
    open_line line{chosen.line};
    output results{chosen.form, false};
    exit_status status = exit_status::done;
    for (named_unit const& each : units) {
        choices one = chosen;
        one.line.unit = each.name.empty() ? std::to_string(each.unit.byte()) : each.name;
        exit_status outcome = exit_status::done;
        try {
            outcome = read_unit(one, line, results, units.size() > 1);
        } catch (ended const& why) { // the others are read all the same
            if (units.size() == 1 or why.status == exit_status::usage or why.status == exit_status::port) {
                throw;
            }
            tell_error(why.what());
            outcome = why.status;
        }
        status = status == exit_status::done ? outcome : status;
    }
    results.finish();
    return status;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers once.
#include <string>

#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/reading.hpp"

namespace tool {

namespace {

record for_people(reading const& it, chosen_register const& which)
{
    return {{"register", it.label},
            {"address", std::int64_t{which.where.address}},
            {"value", it.text},
            {"name", which.entry == nullptr ? std::string{} : std::string{which.entry->name}}};
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

} // namespace

exit_status run_read(choices const& chosen)
{
    open_line line{chosen.line};
    asked_registers const asked = registers_asked(chosen, line);
    register_reader reader{asked.registers, asked.drive};
    reader.read(line, asked.unit.unit);
    output results{chosen.form, false};
    for (chosen_register const& each : asked.registers) {
        reading const it = reading_of(each, reader, asked.drive);
        results.put(chosen.form == output_form::table ? for_people(it, each) : for_programs(it, each, asked.unit.unit));
    }
    results.finish();
    return status_of(reader.first_error());
}

} // namespace tool

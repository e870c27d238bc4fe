// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/drive_settings.hpp"

#include <algorithm>
#include <optional>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/maintenance.hpp>

#include "../support/platform.hpp"
#include "catalog/value_text.hpp"
#include "line/time_text.hpp"
#include "line/who_is_it.hpp"
#include "output/progress.hpp"
#include "port/named_drives.hpp"

namespace tool {

namespace {

namespace altivar = rtuwire::altivar;

/// What a register says, in words, as part of the head.
void add_word(saved_settings& to, char const* name, std::string_view code)
{
    register_entry const* const entry = to.drive->by_code(code);
    auto const word = to.word_of(code);
    if (entry != nullptr and word) {
        to.head.emplace_back(name, text_of(*entry, *word));
    }
}

/// Reads a whole map, and keeps what is told of each row.
void read_all(open_line& line, rtuwire::unit_id unit, saved_settings& to)
{
    drive_catalog const& drive = *to.drive;
    // It takes seconds: worth a line that changes, not ten that stay.
    std::optional<progress> bar;
    if (is_terminal(STDERR_FILENO)) {
        bar.emplace(drive.map.size());
    }
    auto const keep = [&](altivar::parameter_group const&, altivar::parameter const& row,
                          rtuwire::result<std::uint16_t> const& word) {
        register_entry const* const entry = drive.at(row.address);
        if (entry == nullptr) {
            return; // of another revision of the drive
        }
        to.parameters.push_back({entry,
                                 word ? std::optional{*word} : std::nullopt,
                                 word ? std::string{} : line.words_of_failure(word.error()),
                                 {}});
        if (bar) {
            bar->show(to.parameters.size(), std::string{});
        }
    };
    rtuwire::result<void> outcome{};
    std::string const name{drive.name};
    with_drive(name, [&](auto device) {
        using type = typename decltype(device)::type;
        auto conversation = line.with(altivar::backup{station_at<type>(unit.byte(), name), drive.map, keep});
        outcome = line.run(conversation);
    });
    if (not outcome) {
        bool const is_port = status_of(outcome.error()) == exit_status::port;
        throw ended{status_of(outcome.error()), is_port
                                                    ? line.port().failure()
                                                    : "unit " + std::to_string(unit.byte()) + ": " +
                                                          line.words_of_failure(outcome.error()) + "; nothing is kept"};
    }
}

/// Settings of another drive's table would take the place of good ones, and say of a register that it is refused.
void refuse_another_drive(identity_words const& who, drive_catalog const& drive, rtuwire::unit_id unit)
{
    if (is_of_another_family(who, drive)) {
        std::string const it =
            not who.product.empty() ? '\'' + who.product + '\'' : "an " + (who.drive.empty() ? who.vendor : who.drive);
        refuse_word("unit " + std::to_string(unit.byte()) + " is " + it + ", and --drive or --name calls it " +
                    std::string{drive.name} + "; nothing is kept");
    }
}

void refuse_nothing_read(saved_settings const& settings, rtuwire::unit_id unit)
{
    if (std::ranges::none_of(settings.parameters, [](saved_parameter const& each) { return each.word.has_value(); })) {
        throw ended{exit_status::differs,
                    "unit " + std::to_string(unit.byte()) + " has told none of the parameters of an " +
                        std::string{settings.drive->name} + ": is --drive right? Nothing is kept"};
    }
}

} // namespace

std::string time_of_backup() { return second_text(unix_now()); }

saved_settings settings_of(open_line& line, named_unit const& unit, std::string const& port)
{
    saved_settings read;
    identity_words const who = who_is_it(line, unit.unit);
    read.drive = &(who.drive.empty() or not unit.drive.empty() ? catalog_of(line, unit.unit, unit.drive)
                                                               : catalog_chosen(who.drive));
    refuse_another_drive(who, *read.drive, unit.unit);
    read_all(line, unit.unit, read);
    refuse_nothing_read(read, unit.unit);
    read.head = {{"format", "rtuwire backup 1"},
                 {"made by", "rtuwire " RTUWIRE_TOOL_VERSION},
                 {"time", time_of_backup()},
                 {"port", port},
                 {"unit", std::to_string(unit.unit.byte())},
                 {"drive", std::string{read.drive->name}},
                 {"vendor", who.vendor},
                 {"product", who.product},
                 {"revision", who.revision}};
    add_word(read, "rating", "NCV");
    add_word(read, "mains", "VCAL");
    add_word(read, "rated current", "INV");
    add_word(read, "firmware", "VDP");
    add_word(read, "power firmware", "MPV");
    return read;
}

saved_settings factory_settings_of(drive_catalog const& drive)
{
    saved_settings all;
    all.drive = &drive;
    for (register_entry const& each : drive.registers) {
        if (each.factory) {
            all.parameters.push_back({&each, static_cast<std::uint16_t>(*each.factory), {}, {}});
        }
    }
    return all;
}

} // namespace tool

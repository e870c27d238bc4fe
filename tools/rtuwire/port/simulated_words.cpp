// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/simulated_words.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "device/device_folders.hpp"
#include "device/register_file.hpp"
#include "port/named_drives.hpp"
#include "port/simulated_device.hpp"

namespace tool {

namespace {

/// One word, and where it stands among the others.
struct drive_word {
    std::string_view all;
    std::size_t first;
    std::size_t size;

    std::string_view word() const { return all.substr(first, size); }

    /// All words with another one in its place.
    std::string with(std::string const& other) const
    {
        return std::string{all.substr(0, first)} + other + std::string{all.substr(first + size)};
    }
};

std::vector<std::string_view> names_of_drives()
{
    std::vector<std::string_view> names;
    rtuwire::altivar::all_drives::for_each(
        [&names]<typename Drive>() { names.emplace_back(static_cast<std::string_view>(Drive::name)); });
    return names;
}

/// The drive of that name, as the library spells it; a register file, checked whole.
std::optional<std::string> drive_named(std::string_view name)
{
    if (is_register_file(name)) {
        static_cast<void>(register_file_at(std::string{name}));
        return std::string{name};
    }
    for (std::string_view const each : names_of_drives()) {
        if (is_same_word(each, name)) {
            return std::string{each};
        }
    }
    return std::nullopt;
}

/// Why a drive cannot have an address; empty where it can.
std::string wrong_unit(std::string const& drive, std::uint32_t unit)
{
    std::string why;
    if (is_register_file(drive)) {
        return unit >= 1 and unit <= 247 ? why : "unit " + std::to_string(unit) + " is out of range: 1 to 247";
    }
    try {
        with_drive(drive,
                   [&](auto device) { static_cast<void>(station_at<typename decltype(device)::type>(unit, drive)); });
    } catch (usage_error const& error) {
        why = error.what();
    }
    return why;
}

/// The lowest address that none of the drives has.
std::uint32_t free_unit(std::vector<simulated_drive_choice> const& drives)
{
    std::uint32_t unit = 1;
    while (std::any_of(drives.begin(), drives.end(), [unit](auto const& each) { return each.unit == unit; })) {
        ++unit;
    }
    return unit;
}

/// Adds one drive; or says what is wrong with it.
void add(simulated_words& found, drive_word const& at)
{
    std::size_t const last = (std::min)(at.word().rfind(':'), at.size);
    bool const is_drive = at.word().find_first_of("/\\", last) != std::string_view::npos; // of a path: C:\meter.toml
    std::size_t const colon = is_drive ? at.size : last;
    std::string const name{at.word().substr(0, colon)};
    std::string const number{colon == at.size ? "1" : at.word().substr(colon + 1)};
    auto const drive = drive_named(name);
    if (not drive) {
        std::vector<std::string> const files = device_file_names();
        auto names = names_of_drives();
        names.insert(names.end(), files.begin(), files.end());
        std::string const nearest{nearest_word(name, names)};
        found.why = (name.empty() ? "a drive is missing, one of " : "there is no drive " + name + ", only ") +
                    drive_names() + ", or a register file: ";
        for (std::string const& each : files) {
            found.why += each + ", ";
        }
        found.why +=
            (files.empty() ? "a path such as meter.toml" : "or a path such as meter.toml") + words_of_missing_folder();
        found.nearest = nearest.empty() ? "" : at.with(nearest + std::string{at.word().substr(colon)});
        return;
    }
    auto const unit = number_in(number);
    std::string const free = *drive + ":" + std::to_string(free_unit(found.drives));
    if (not unit) {
        found.why = "the unit " + number + " of " + *drive + " is no number";
        found.nearest = at.with(free);
    } else if (auto why = wrong_unit(*drive, *unit); not why.empty()) {
        found.why = std::move(why);
        found.nearest = at.with(free);
    } else if (std::any_of(found.drives.begin(), found.drives.end(),
                           [&](auto const& each) { return each.unit == *unit; })) {
        found.why = "unit " + number + " is given twice";
        found.nearest = at.with(free);
    } else {
        found.drives.push_back({*drive, static_cast<std::uint8_t>(*unit)});
    }
}

} // namespace

simulated_words read_simulated_drives(std::string_view words)
{
    simulated_words found;
    std::size_t first = 0;
    while (found.why.empty()) {
        std::size_t const end = (std::min)(words.find(',', first), words.size());
        add(found, {words, first, end - first});
        if (end == words.size()) {
            break;
        }
        first = end + 1;
    }
    return found;
}

} // namespace tool

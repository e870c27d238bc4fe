// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of backups and restores shows: from one simulated drive to another.
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/maintenance.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::full_device> drive{unit_id{1}};
constexpr line_timing timing{19'200, character_format::even_8_1};

/// A client that commands, and a drive.
auto bench_of_a_drive() { return sim::bench{drive_client<1>{timing}, drive}; }

//! [backup]
/// The words of a drive, by mnemonics.
using configuration = std::map<std::string, std::uint16_t>;

template <typename Line> configuration read_all(Line& line)
{
    configuration all;
    backup conversation{drive, atv320::parameters,
                        [&](parameter_group const& group, parameter const& row, result<std::uint16_t> const& word) {
                            if (word) {
                                all[std::string(row.code)] = *word;
                            } else {
                                std::cerr << group.name << ' ' << row.code << ": " << word.error() << '\n';
                            }
                        }};
    auto const done = line.run(conversation);
    if (not done) {
        std::cerr << "the backup ended: " << done.error() << '\n';
    }
    return all;
}
//! [backup]

//! [wanted]
struct kept_words {
    configuration const* all;

    std::optional<std::uint16_t> operator()(parameter const& row) const
    {
        auto const found = all->find(std::string(row.code));
        return found == all->end() ? std::nullopt : std::optional{found->second};
    }
};
//! [wanted]

//! [compare]
template <typename Line> unsigned show_differences(Line& line, configuration const& wanted)
{
    unsigned differing = 0;
    backup conversation{drive, atv320::parameters,
                        compared_with{kept_words{&wanted}, [&](parameter_group const& group, parameter const& row,
                                                               comparison found, result<std::uint16_t> const& held) {
                                          if (found == comparison::differs) {
                                              ++differing;
                                              std::cout << group.name << ' ' << row.code << " is " << *held << '\n';
                                          }
                                      }}};
    return line.run(conversation) ? differing : ~0U;
}
//! [compare]

//! [restore]
template <typename Line> bool restore_all(Line& line, configuration const& wanted, restore_options const& options)
{
    auto const report = [](parameter_group const&, parameter const& row, restore_report const& what) {
        if (what.outcome == restore_outcome::written or what.outcome == restore_outcome::planned) {
            std::cout << row.code << ": " << name_of(what.outcome) << '\n';
        }
    };
    restore conversation{drive, atv320::parameters,
                         wanted_settings{drive_family::of(std::string{"ATV320U07M2C"}), kept_words{&wanted}}, report,
                         options};
    reason const how = line.run(conversation);
    std::cout << how << ": " << conversation.written() << " written, " << conversation.failed() << " not held\n";
    return how.kind == outcome_kind::succeeded;
}
//! [restore]

} // namespace

int main()
{
    auto old_drive = bench_of_a_drive();
    static_cast<void>(old_drive.run(write<atv320::parameter<"SP2">>(drive, 12.5_Hz)));
    configuration const saved = read_all(old_drive);

    auto new_drive = bench_of_a_drive();
    bool const differs = show_differences(new_drive, saved) > 0;
    //! [options]
    restore_options options{.dry_run = true, .with_inferred = true};
    bool const is_possible = restore_all(new_drive, saved, options); // says what it would write
    options.dry_run = false;
    options.save = true;
    bool const is_done = is_possible and restore_all(new_drive, saved, options);
    //! [options]
    return differs and is_done and show_differences(new_drive, saved) == 0 ? 0 : 1;
}

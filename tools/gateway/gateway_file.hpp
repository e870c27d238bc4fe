// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file of the gateway, as TOML: a broker, lines, the devices on them, and what is read of each how often. It is checked
// whole, with the register files that it names, before anything is opened. It never allows a write: --write is typed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "choices.hpp"
#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "words/register_words.hpp"

namespace tool::gateway {

inline constexpr std::size_t most_lines = 64;
inline constexpr std::size_t most_devices = 247; ///< of one line

/// Of the files only the paths, from where the program runs.
struct broker_choices {
    std::string host{"127.0.0.1"};
    unsigned port{1'883};
    std::string user{};
    std::string password_file{}; ///< empty: none
    std::string ca_file{};       ///< empty: without TLS
    std::string cert_file{};     ///< with its key, or neither
    std::string key_file{};
    std::string discovery{"homeassistant"}; ///< the prefix; empty: none
    bool is_old{false};                     ///< it is spoken to by MQTT 3.1.1 alone
};

/// What a value is for programs.
enum class value_kind : std::uint8_t { number, choice, flag, text };

/// What may be written to a setting.
struct setting_limits {
    std::optional<double> lowest{}; ///< in the unit; nothing: as far as its registers go, or another register says
    std::optional<double> highest{};
    std::optional<double> step{};       ///< of a number
    std::vector<std::string> choices{}; ///< all of them, where it has some
    bool is_stored{false};              ///< a write of it wears the device's memory
};

/// One value of a device that is read and published.
struct device_value {
    std::string name; ///< letters, digits, - and _ : a part of a topic
    chosen_register which;
    value_kind kind{value_kind::number};
    std::string unit{};                 ///< "V"; empty where it has none
    std::optional<unsigned> decimals{}; ///< digits behind the point of a number; nothing: nobody said
    double every{1.0};                  ///< seconds
    std::optional<setting_limits> setting{};
};

struct device_plan {
    std::string name;
    named_unit unit;    ///< of a drive its type stands there, of any other "none"
    std::string type{}; ///< as the file says it: "atv320", "sdm630.toml"
    drive_catalog const* drive{nullptr};
    std::shared_ptr<named_places const> names{}; ///< of a register file
    bool feeds_supervision{false};               ///< whoever wrote the file knows what reading does to a drive
    std::vector<device_value> values{};
};

struct line_plan {
    std::string name;
    line_choices choices{};
    std::optional<serve_choices> serve{}; ///< it answers clients, too
    std::vector<device_plan> devices{};
    /// All that the file and its register files say of the line but for its clients: equal texts are equal lines.
    std::string said{};
    std::string said_of_clients{}; ///< the same of `serve`
};

struct gateway_plan {
    std::string file;
    std::string site;
    std::string gateway;
    broker_choices broker{};
    std::string state_folder{"/var/lib/rtuwire"};
    std::vector<std::shared_ptr<line_plan const>> lines{};
    std::vector<std::string> notes{}; ///< what whoever runs it has to know, a sentence each
};

/// What a text of such a file says. Ends the command (`ended`, status 2) at the first thing that is wrong, with its line and
/// column.
gateway_plan read_gateway_file(std::string const& file, std::string const& text);

/// The same of a file, with all files that it names: that they are regular ones that can be read, and that not everybody reads
/// the password and the key.
gateway_plan gateway_file_at(std::string const& file);

/// The password of its file, without the end of its line; empty where there is none. Never shown, never logged.
std::string password_of(broker_choices const& broker);

/// Whether others than its owner and its group may read or change a file.
bool is_open_to_all(std::string const& file);

/// What --check prints: a row for each value.
void show_plan(gateway_plan const& plan, output_form form);

} // namespace tool::gateway

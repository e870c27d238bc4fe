// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "gateway_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <arpa/inet.h>

#include "../support/platform.hpp"
#include "catalog/value_text.hpp"
#include "device/device_folders.hpp"
#include "device/register_file.hpp"
#include "files/regular_file.hpp"
#include "files/toml_values.hpp"
#include "line/reading.hpp"
#include "line_options.hpp"
#include "motion/checked_values.hpp"
#include "motion/moving_registers.hpp"
#include "motion/unsafe_write.hpp"
#include "port/port_word.hpp"
#include "serve/serve_settings.hpp"
#include "words/place_value.hpp"
#include "words/suggestion.hpp"
#include "words/words.hpp"

namespace tool::gateway {

namespace {

constexpr double shortest_period = 0.02;
constexpr double longest_period = 86'400;
constexpr std::size_t longest_word = 64;

constexpr std::string_view line_options[]{"port",  "baud", "format", "timeout", "retries",
                                          "pause", "echo", "rs485",  "listen"};

/// What a device of a gateway may never be written, whatever is allowed: nobody watches. With its line and its unit for a command
/// that a message shows.
choices nobody_allows(line_choices const& line, unit_address unit)
{
    choices chosen{.line = line, .allowed = {.may_write = true, .knows_run = false}};
    chosen.line.typed.options = " -p " + quoted(line.port);
    chosen.line.typed.rate =
        line.is_rate_named ? " -b " + std::to_string(line.baud) + " -f " + line.format : std::string{};
    chosen.line.typed.unit = " -u " + std::to_string(unit.byte());
    return chosen;
}

bool is_topic_letter(char c)
{
    return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or (c >= '0' and c <= '9') or c == '-' or c == '_';
}

/// A name by its syntax, or an address. What has digits and points alone is an address, or nothing.
bool is_host(std::string const& text)
{
    std::array<unsigned char, sizeof(in6_addr)> address{};
    if (::inet_pton(AF_INET6, text.substr(0, text.find('%')).c_str(), address.data()) == 1 or
        ::inet_pton(AF_INET, text.c_str(), address.data()) == 1) {
        return true;
    }
    auto const is_label = [](std::string_view label) {
        return not label.empty() and label.size() <= 63 and label.front() != '-' and label.back() != '-' and
               std::ranges::all_of(label, is_topic_letter);
    };
    std::vector<std::string_view> const labels =
        tool::parts_of(std::string_view{text}.substr(0, text.size() - (text.ends_with('.') ? 1 : 0)), ".");
    bool const has_letter = text.find_first_not_of("0123456789.") != text.npos;
    return has_letter and text.size() <= 253 and std::ranges::all_of(labels, is_label);
}

/// What a label is as a part of a topic: "ETA.fault" is ETA_fault.
std::string topic_word(std::string text)
{
    std::ranges::replace_if(text, std::not_fn(is_topic_letter), '_');
    return text;
}

/// A value in a form in which equal ones are equal texts, and others are not.
void add_said(std::string& said, toml::node const& value)
{
    if (auto const* const table = value.as_table()) {
        said += '{';
        for (auto const& [key, each] : *table) {
            said += std::to_string(key.str().size()) + ':' + std::string{key.str()} + '=';
            add_said(said, each);
        }
        said += '}';
    } else if (auto const* const list = value.as_array()) {
        said += '[';
        for (toml::node const& each : *list) {
            add_said(said, each);
        }
        said += ']';
    } else if (auto const* const text = value.as_string()) {
        said += std::to_string(text->get().size()) + ':' + text->get();
    } else if (auto const* const flag = value.as_boolean()) {
        said += flag->get() ? "true;" : "false;";
    } else if (auto const* const whole = value.as_integer()) {
        said += std::to_string(whole->get()) + ';';
    } else if (auto const* const number = value.as_floating_point()) {
        said += std::to_string(number->get()) + "f;";
    }
}

std::size_t digits_of(std::int64_t denominator)
{
    std::size_t digits = 0;
    for (; denominator > 1; denominator /= 10) {
        ++digits;
    }
    return digits;
}

double amount_of(std::int32_t count, step_size step)
{
    return static_cast<double>(count * step.numerator) / static_cast<double>(step.denominator);
}

value_kind kind_of(chosen_register const& which)
{
    bool const is_bit = which.where.is_single_bit() or (which.where.bit >= 0 and which.where.last_bit < 0);
    bool const is_entry = which.entry != nullptr and which.where.form.said.empty();
    if (which.named != nullptr and not which.named->choices.empty()) {
        return value_kind::choice;
    }
    if (is_bit) {
        return value_kind::flag;
    }
    if (is_entry and which.where.bit < 0) {
        return which.entry->kind == register_kind::enumeration ? value_kind::choice : value_kind::number;
    }
    return which.where.form.type == value_type::text ? value_kind::text : value_kind::number;
}

std::optional<unsigned> decimals_of(chosen_register const& which)
{
    if (kind_of(which) != value_kind::number) {
        return std::nullopt;
    }
    if (which.entry != nullptr and which.where.form.said.empty()) {
        bool const is_fixed = which.entry->is_amount() and which.entry->steps_set_by.empty();
        return is_fixed ? std::optional{static_cast<unsigned>(digits_of(which.entry->step.denominator))} : std::nullopt;
    }
    value_form const& form = which.where.form;
    bool const is_whole = form.type != value_type::f32 and form.type != value_type::f64;
    return is_whole ? std::optional{unsigned{std::max(form.factor.places, form.offset.places)}} : std::nullopt;
}

setting_limits limits_of(chosen_register const& which)
{
    setting_limits limits;
    if (named_place const* const named = which.named) {
        limits.lowest = named->lowest;
        limits.highest = named->highest;
        limits.is_stored = named->is_stored;
        for (named_choice const& each : named->choices) {
            limits.choices.push_back(each.name);
        }
        value_form const& form = named->where.form;
        bool const is_whole = form.type != value_type::f32 and form.type != value_type::f64;
        if (is_whole and kind_of(which) == value_kind::number) {
            limits.step = form.factor.digits / std::pow(10.0, form.factor.places);
        }
    } else if (register_entry const* const entry = which.entry) {
        for (rtuwire::choice const& each : entry->values()) {
            limits.choices.emplace_back(std::string_view{each.mnemonic});
        }
        if (entry->is_amount() and entry->steps_set_by.empty()) {
            limits.lowest = amount_of(entry->lowest_count(), entry->step);
            limits.highest = amount_of(entry->highest_count(), entry->step);
            limits.step = amount_of(1, entry->step);
        }
    }
    return limits;
}

/// Why a register is never written by a gateway; empty where it may be one of its settings.
std::string why_no_setting(chosen_register const& which, drive_catalog const* drive, choices const& allowed)
{
    bool const is_named = which.named != nullptr or (which.entry != nullptr and which.where.form.said.empty());
    if (not is_named or (which.entry != nullptr and which.where.bit >= 0)) {
        return "a setting is a register by its name, all of it";
    }
    if (which.named != nullptr and not which.named->is_writable) {
        return "it has no access = \"write\" in its register file";
    }
    if (which.named != nullptr and which.named->moves) {
        return "it moves something, as its register file says in line " + std::to_string(which.named->line);
    }
    if (which.named == nullptr and not which.entry->is_writable()) {
        return "it is read only";
    }
    value_to_write value{.where = which.where, .entry = which.entry, .named = which.named};
    if (which.entry != nullptr) {
        value.needed = {which.entry}; // no value yet: that is judged when it comes
    }
    try {
        refuse_command(value, {.drive = drive, .says_it_is_none = drive == nullptr}, allowed);
        if (drive != nullptr) {
            refuse_unsafe_write(value, *drive, allowed);
        }
    } catch (ended const& why) {
        return why.what();
    }
    if (drive != nullptr) {
        if (std::string const why = why_it_runs_otherwise(*which.entry); not why.empty()) {
            return "it " + why + ": a motor that runs turns otherwise after it";
        }
        if (std::string const why = why_it_is_a_guard(*which.entry); not why.empty()) {
            return "it " + why + ": nobody is there who would see what comes of it";
        }
        if (takes_orders(*which.entry, *drive)) {
            return "it takes orders, and is no setting";
        }
    }
    return {};
}

class plan_reader : toml_values {
public:
    /// `looks_at_files`: at those of the broker, too.
    plan_reader(std::string const& file, std::string const& text, bool looks_at_files)
        : toml_values{file}, text_{text}, looks_at_files_{looks_at_files}
    {
        plan_.file = file;
        folder_ = std::filesystem::path{file}.parent_path();
    }

    gateway_plan run()
    {
        toml::table const all = plain_toml_in(file(), text_);
        for (std::string_view const each : {"write", "allow-write"}) {
            if (auto const found = all.find(each); found != all.end()) {
                refuse(found->first.source(), "'" + std::string{each} + "' is typed: no file allows it");
            }
        }
        check_keys(file(), all, {"site", "gateway", "state_folder", "broker", "line"});
        plan_.site = topic_part(all, "site");
        plan_.gateway = topic_part(all, "gateway");
        if (all.contains("state_folder")) {
            plan_.state_folder = path_in(all, "state_folder");
        }
        read_broker(all);
        toml::array const* const lines = tables_in(all, "line", most_lines);
        if (lines == nullptr) {
            refuse(all.source(), "it has no lines: each is a table that begins with [[line]]");
        }
        for (toml::node const& each : *lines) {
            add_line(*each.as_table());
        }
        return std::move(plan_);
    }

private:
    static toml::source_region place_of(toml::table const& from, std::string_view key)
    {
        toml::node const* const value = from.get(key);
        return (value != nullptr ? *value : static_cast<toml::node const&>(from)).source();
    }

    /// A name that has to be there.
    std::string topic_part(toml::table const& from, std::string_view key) const
    {
        auto const text = text_in(from, key);
        bool const is_right =
            text and not text->empty() and text->size() <= longest_word and std::ranges::all_of(*text, is_topic_letter);
        if (not is_right) {
            refuse(place_of(from, key), std::string{key} + (text ? "" : " is missing: it") +
                                            " is a part of topics, 1 to " + std::to_string(longest_word) +
                                            " letters, digits, - and _");
        }
        return *text;
    }

    /// A text that is not empty; nothing where there is none.
    std::optional<std::string> word_in(toml::table const& from, std::string_view key) const
    {
        auto text = text_in(from, key);
        if (text and (text->empty() or text->size() > 1'024)) {
            refuse(place_of(from, key), std::string{key} + " is empty, or longer than 1024 bytes");
        }
        return text;
    }

    /// Of a file beside this one; empty where a table has none.
    std::string path_in(toml::table const& from, std::string_view key) const
    {
        auto const text = word_in(from, key);
        return text ? (folder_ / *text).string() : std::string{};
    }

    void read_broker(toml::table const& all)
    {
        toml::table const* const broker = table_in(all, "broker");
        if (broker == nullptr) {
            return;
        }
        check_keys(
            file(), *broker,
            {"host", "port", "user", "password_file", "ca_file", "cert_file", "key_file", "discovery", "protocol"});
        broker_choices& to = plan_.broker;
        to.host = word_in(*broker, "host").value_or(to.host);
        if (not is_host(to.host)) {
            refuse(place_of(*broker, "host"), "host is a name or an address: \"broker.example.org\", \"192.0.2.7\", "
                                              "\"2001:db8::7\"; its port is a key of its own, and ca_file means TLS");
        }
        to.port = whole_in(*broker, "port", 1, 65'535).value_or(to.port);
        to.user = word_in(*broker, "user").value_or("");
        to.password_file = path_in(*broker, "password_file");
        to.ca_file = path_in(*broker, "ca_file");
        to.cert_file = path_in(*broker, "cert_file");
        to.key_file = path_in(*broker, "key_file");
        if (not to.password_file.empty() and to.user.empty()) {
            refuse(place_of(*broker, "password_file"), "a password goes with a user: say user = \"...\"");
        }
        if (to.cert_file.empty() != to.key_file.empty()) {
            refuse(broker->source(), "cert_file and key_file go together");
        }
        if (to.ca_file.empty() and not to.cert_file.empty()) {
            refuse(place_of(*broker, "cert_file"), "a certificate goes with TLS: say ca_file = \"...\"");
        }
        std::string const protocol = text_in(*broker, "protocol").value_or("5");
        if (protocol != "5" and protocol != "3.1.1") {
            refuse(place_of(*broker, "protocol"), "protocol is that of MQTT, \"5\" or \"3.1.1\"");
        }
        to.is_old = protocol == "3.1.1";
        if (looks_at_files_) {
            look_at_files(*broker);
        }
        to.discovery = text_in(*broker, "discovery").value_or(to.discovery);
        bool const is_prefix = to.discovery.size() <= longest_word and not to.discovery.starts_with('/') and
                               not to.discovery.ends_with('/') and not to.discovery.starts_with('$') and
                               std::ranges::all_of(to.discovery, [](char c) { return is_topic_letter(c) or c == '/'; });
        if (not is_prefix) {
            refuse(place_of(*broker, "discovery"),
                   "discovery is the prefix of topics, \"homeassistant\": letters, digits, -, _ and /; \"\" for none");
        }
        bool const is_near = to.host == "localhost" or to.host == "::1" or to.host.starts_with("127.");
        if (not to.password_file.empty() and to.ca_file.empty() and not is_near) {
            plan_.notes.push_back("the password passes the network to " + to.host +
                                  " as it is: ca_file = \"...\" hides it by TLS");
        }
    }

    void look_at_files(toml::table const& broker) const
    {
        broker_choices const& said = plan_.broker;
        auto const refuse_key = [&](std::string_view key, std::string const& why) {
            refuse(place_of(broker, key), std::string{key} + ": " + why);
        };
        try {
            static_cast<void>(password_of(said));
        } catch (ended const& why) {
            refuse_key("password_file", why.what());
        }
        std::pair<std::string_view, std::string const&> const files[]{
            {"ca_file", said.ca_file}, {"cert_file", said.cert_file}, {"key_file", said.key_file}};
        for (auto const& [key, path] : files) {
            if (std::string const why = path.empty() ? "" : text_of_file(path).failure; not why.empty()) {
                refuse_key(key, path + ": " + why);
            }
        }
        if (not said.key_file.empty() and is_open_to_all(said.key_file)) {
            refuse_key("key_file",
                       said.key_file + ": anybody may read or change this key; say chmod o= " + said.key_file);
        }
    }

    void add_line(toml::table const& from)
    {
        check_keys(file(), from,
                   {"name", "port", "baud", "format", "timeout", "retries", "pause", "echo", "rs485", "listen", "serve",
                    "device"});
        auto line = std::make_shared<line_plan>();
        line->name = topic_part(from, "name");
        refuse_twice(line_names_, line->name, place_of(from, "name"), "the line");
        if (line->name == "status") {
            refuse(place_of(from, "name"), "'status' is a topic of the gateway itself");
        }
        line->choices.typed.form = option_form::in_file;
        read_line_options(file(), text_, from, line_options, line->choices);
        line->choices.knows_registers = true;
        check_port(from, line->choices.port);
        set_timeout(line->choices);
        read_serve(from, *line);
        toml::array const* const devices = tables_in(from, "line.device", most_devices);
        if (devices == nullptr) {
            refuse(from.source(), "the line '" + line->name +
                                      "' has no devices: each is a table that begins with "
                                      "[[line.device]]");
        }
        toml::table own{from};
        own.erase("serve");
        add_said(line->said, own);
        names_of_line_.clear();
        units_of_line_.clear();
        for (toml::node const& each : *devices) {
            add_device(*each.as_table(), *line);
        }
        plan_.lines.push_back(std::move(line));
    }

    void check_port(toml::table const& from, std::string const& port)
    {
        if (port.empty()) {
            refuse(from.source(), "port is missing: port = \"/dev/serial/by-id/...\", \"tcp://host:4001\", "
                                  "\"mbap://host\" or \"sim:atv320:1\"");
        }
        refuse_twice(ports_, port, place_of(from, "port"), "the port");
        if (std::holds_alternative<capture_file>(read_port_word(port).port)) {
            refuse(place_of(from, "port"), port + " is a capture, in which nobody answers");
        }
        for (std::string_view const each : {"/dev/ttyUSB", "/dev/ttyACM"}) {
            if (port.starts_with(each)) {
                plan_.notes.push_back(port +
                                      " may be another adapter after the next start: /dev/serial/by-id/ has names "
                                      "that stay");
            }
        }
    }

    void read_serve(toml::table const& from, line_plan& line)
    {
        toml::table const* const said = table_in(from, "line.serve");
        if (said == nullptr) {
            return;
        }
        for (std::string_view const each : {"write", "allow-write"}) {
            if (said->contains(each)) {
                refuse(place_of(*said, each),
                       "clients of a gateway's line read: who writes is a setting of a device, or a "
                       "client of rtuwire serve");
            }
        }
        add_said(line.said_of_clients, *said);
        check_keys(file(), *said, {"listen", "units", "from"});
        serve_choices& to = line.serve.emplace();
        to.listen = {word_in(*said, "listen").value_or("mbap://127.0.0.1:1502")};
        to.units = word_in(*said, "units").value_or("");
        if (to.units.empty()) {
            refuse(said->source(), "units is missing: which of them clients may read, units = \"1-4,7\"; each request "
                                   "feeds a drive's supervision of the line");
        }
        auto const settings_of = [&](toml::source_region const& where, serve_choices const& part) {
            serve_settings settings;
            if (auto const why =
                    ended_by([&] { settings = serve_settings_in({.line = line.choices, .serve = part}); })) {
                refuse(where, why->what());
            }
            return settings;
        };
        static_cast<void>(settings_of(place_of(*said, "units"), {.units = to.units}));
        if (toml::node const* const ranges = said->get("from")) {
            toml::array const* const list = ranges->as_array();
            if (list == nullptr or list->empty() or not list->is_homogeneous<std::string>()) {
                refuse(ranges->source(), "from is a list of addresses, one at least: from = [\"192.168.1.0/24\"]");
            }
            for (toml::node const& each : *list) {
                to.from.push_back(each.as_string()->get());
                static_cast<void>(settings_of(each.source(), {.from = {to.from.back()}}));
            }
        }
        toml::source_region const at = place_of(*said, "listen");
        serve_settings const settings = settings_of(at, to);
        for (auto const& [key, why] : {std::pair{"listen", why_it_asks_itself(settings, line.choices)},
                                       std::pair{"from", why_nobody_comes(settings)}}) {
            if (not why.empty()) {
                refuse(place_of(*said, key), why);
            }
        }
        refuse_taken_place({line.name, line.choices.port, to.listen.front(), settings.listen.front().at}, at);
        refuse_ring(place_of(from, "port"));
        if (settings.is_for_anybody() and not is_loopback(settings.listen.front().at.host)) {
            plan_.notes.push_back(line.name + ": whoever reaches " + to.listen.front() +
                                  " may read there: say from = [\"192.168.1.0/24\"] with the clients that may");
        }
        plan_.notes.push_back(line.name + ": clients at " + to.listen.front() + " may read the units " + to.units +
                              ": where one of them is a drive, that feeds its supervision of the line");
    }

    /// Where a line listens, and whom it asks.
    struct served_place {
        std::string line;
        std::string port;
        std::string word;
        tcp_address at;
    };

    void refuse_taken_place(served_place place, toml::source_region const& where)
    {
        if (place.at.port == 0) {
            refuse(where, "listen: port 0 is any that is free, which no client knows: say which, 1502");
        }
        for (served_place const& each : served_places_) {
            if (each.at.port == place.at.port and are_one_place(each.at.host, place.at.host)) {
                refuse(where, "listen: " + place.word + " is taken: the line '" + each.line + "' listens at " +
                                  each.word + "; say another port");
            }
        }
        served_places_.push_back(std::move(place));
    }

    /// Lines that read through each other's clients, and so no device; the last one that was read makes them a ring.
    void refuse_ring(toml::source_region const& where) const
    {
        std::vector<std::pair<served_place const*, std::string>> asked{{&served_places_.back(), ""}}; ///< and by whom
        for (std::size_t i = 0; i < asked.size(); ++i) {
            auto const [one, told] = asked[i];
            for (served_place const& each : served_places_) {
                if (not is_asked_at(one->port, each.at)) {
                    continue;
                }
                std::string const so_far =
                    told + "'" + one->line + "' asks " + one->port + ", where '" + each.line + "' listens";
                if (&each == asked.front().first) {
                    refuse(where, "port: these lines ask each other, and none of them a device: " + so_far +
                                      "; name the port of a device in one of them");
                }
                if (std::ranges::none_of(asked, [&each](auto const& known) { return known.first == &each; })) {
                    asked.emplace_back(&each, so_far + ", ");
                }
            }
        }
    }

    /// So short on a wire that who falls silent is told within 3 s; over a network a request may wait behind others.
    static void set_timeout(line_choices& line)
    {
        auto const which = read_port_word(line.port).port;
        bool const is_network =
            std::holds_alternative<tcp_address>(which) or std::holds_alternative<mbap_address>(which);
        line.response_timeout = line.response_timeout.value_or(is_network ? 1.0 : 0.5);
    }

    void refuse_twice(std::map<std::string, unsigned, std::less<>>& before, std::string const& word,
                      toml::source_region const& where, std::string const& what) const
    {
        auto const [found, is_new] = before.try_emplace(word, static_cast<unsigned>(where.begin.line));
        if (not is_new) {
            refuse(where, what + " '" + word + "' stands in line " + std::to_string(found->second) + ", too");
        }
    }

    void add_device(toml::table const& from, line_plan& line)
    {
        check_keys(file(), from,
                   {"name", "unit", "file", "drive", "every", "groups", "registers", "settings", "feeds_supervision"});
        device_plan device{.name = topic_part(from, "name"), .unit = {.unit = unit_in(from)}};
        refuse_twice(names_of_line_, device.name, place_of(from, "name"), "the device");
        for (std::string_view const each : {"status", "availability"}) {
            if (device.name == each) {
                refuse(place_of(from, "name"), "'" + device.name + "' is a topic of the line itself");
            }
        }
        refuse_twice(units_of_line_, std::to_string(device.unit.unit.byte()), place_of(from, "unit"), "unit");
        device.unit.name = device.name;
        device.feeds_supervision = flag_in(from, "feeds_supervision");
        read_type(from, device, line);
        read_values(from, device);
        read_settings(from, device, line.choices);
        line.devices.push_back(std::move(device));
    }

    rtuwire::unit_id unit_in(toml::table const& from) const
    {
        auto const unit = whole_in(from, "unit", 1, 247);
        if (not unit) {
            refuse(from.source(), "unit is missing: the address of the device, 1 to 247");
        }
        return *rtuwire::unit_id::checked(*unit);
    }

    void read_type(toml::table const& from, device_plan& device, line_plan& line)
    {
        auto const drive = word_in(from, "drive");
        auto const registers = word_in(from, "file");
        if (drive.has_value() == registers.has_value()) {
            refuse(from.source(),
                   "the device '" + device.name +
                       "' has either a register file, file = \"sdm630\", or is a drive, drive = \"atv320\"");
        }
        device.type = drive ? *drive : *registers;
        if (registers) {
            device.names = register_file(*registers, place_of(from, "file"), line);
            device.unit.names = device.names.get();
            device.unit.drive = std::string{no_drive};
            return;
        }
        device.drive = catalog_named(*drive);
        if (device.drive == nullptr) {
            std::vector<std::string_view> known;
            for (drive_catalog const* const each : all_catalogs()) {
                known.push_back(each->name);
            }
            refuse(place_of(from, "drive"), "'" + *drive + "' is no drive" + suggestion(*drive, known));
        }
        device.unit.drive = std::string{device.drive->name};
        if (not device.drive->units.contains(device.unit.unit.byte())) {
            refuse(place_of(from, "unit"),
                   "an " + device.unit.drive + " has no address " + std::to_string(device.unit.unit.byte()));
        }
        if (not device.feeds_supervision) {
            refuse(
                place_of(from, "drive"),
                "reading '" + device.name +
                    "' feeds the drive's supervision of its line: idle, it begins it, and shows the fault SLF at its "
                    "next start once nobody reads; and a motor whose controller has gone runs on while it is read. "
                    "Where that is wanted, say feeds_supervision = true");
        }
        plan_.notes.push_back(line.name + ": " + device.name +
                              " is a drive, and reading it feeds its supervision of "
                              "the line: a motor whose controller has gone runs on while it is read");
    }

    std::shared_ptr<named_places const> register_file(std::string const& word, toml::source_region const& where,
                                                      line_plan& line)
    {
        bool const is_path = word.find_first_of("./") != word.npos;
        std::string path;
        try {
            path = is_path ? (folder_ / word).string() : path_of_device(word);
        } catch (ended const& why) {
            refuse(where, why.what());
        }
        auto& [text, names] = register_files_[path];
        if (names == nullptr) {
            file_text found = text_of_file(path);
            if (not found.failure.empty()) {
                refuse(where, path + ": " + found.failure);
            }
            text = std::move(found.text);
            names = std::make_shared<named_places const>(read_register_file(path, text));
        }
        line.said += std::to_string(text.size()) + ':' + text;
        line.choices.pause = std::max(line.choices.pause, names->pause.value_or(0));
        return names;
    }

    /// The registers of the words of a list, and where each word stands.
    std::vector<std::pair<chosen_register, toml::source_region>>
    registers_in(toml::table const& from, std::string_view key, device_plan const& device) const
    {
        std::vector<std::pair<chosen_register, toml::source_region>> all;
        toml::node const* const value = from.get(key);
        if (value == nullptr) {
            return all;
        }
        toml::array const* const list = value->as_array();
        if (list == nullptr or list->empty() or not list->is_homogeneous<std::string>()) {
            refuse(value->source(),
                   std::string{key} + " is a list of names, one at least: " + std::string{key} + " = [\"...\"]");
        }
        for (toml::node const& each : *list) {
            std::string const& word = each.as_string()->get();
            std::string_view const one[]{word};
            register_selection const found = select_registers(one, {device.drive, device.names.get()});
            if (found.refused) {
                refuse(each.source(), found.refused->sentence);
            }
            for (chosen_register const& which : found.registers) {
                all.emplace_back(which, each.source());
            }
        }
        return all;
    }

    double period_in(toml::table const& from, double otherwise) const
    {
        auto const every = number_in(from, "every");
        if (every and not(*every >= shortest_period and *every <= longest_period)) {
            refuse(place_of(from, "every"), "every is a number of seconds, 0.02 to 86400");
        }
        return every.value_or(otherwise);
    }

    /// What the register file says of its group, where nobody said otherwise.
    double period_of(toml::table const& from, device_plan const& device, chosen_register const& which) const
    {
        named_group const* const group =
            which.named == nullptr ? nullptr : device.names->group_named(which.named->group);
        return period_in(from, group == nullptr ? 1.0 : std::clamp(group->period, shortest_period, longest_period));
    }

    device_value& add_value(device_plan& device, chosen_register const& which, double every,
                            toml::source_region const& where) const
    {
        auto const before = std::ranges::find(device.values, which, &device_value::which);
        if (before != device.values.end()) {
            return *before;
        }
        device_value one{.name = topic_word(label_of(which)), .which = which, .kind = kind_of(which), .every = every};
        bool const is_entry = which.entry != nullptr and which.where.form.said.empty();
        one.unit = not is_entry                                       ? which.where.form.unit
                   : which.where.bit < 0 and which.entry->is_amount() ? std::string{which.entry->unit}
                                                                      : std::string{};
        one.decimals = decimals_of(which);
        auto const same = std::ranges::find(device.values, one.name, &device_value::name);
        if (same != device.values.end()) {
            refuse(where, "'" + label_of(which) + "' and '" + label_of(same->which) + "' are both " + one.name +
                              " in a topic");
        }
        return device.values.emplace_back(std::move(one));
    }

    void read_values(toml::table const& from, device_plan& device) const
    {
        for (auto const& [which, where] : registers_in(from, "registers", device)) {
            add_value(device, which, period_of(from, device, which), where);
        }
        if (not from.contains("registers")) {
            std::string_view const all[]{device.drive != nullptr ? "@monitor" : "*"};
            for (chosen_register const& which : select_registers(all, {device.drive, device.names.get()}).registers) {
                add_value(device, which, period_of(from, device, which), from.source());
            }
        }
        toml::node const* const groups = from.get("groups");
        if (groups == nullptr) {
            return;
        }
        toml::array const* const list = groups->as_array();
        if (list == nullptr or list->empty() or not list->is_homogeneous<toml::table>()) {
            refuse(groups->source(),
                   "groups is a list of tables, one at least: groups = [{ registers = [\"...\"], every = 60.0 }]");
        }
        std::vector<chosen_register> grouped;
        for (toml::node const& each : *list) {
            toml::table const& group = *each.as_table();
            check_keys(file(), group, {"registers", "every"});
            if (not group.contains("registers") or not group.contains("every")) {
                refuse(group.source(), "a group has registers and a period: { registers = [\"...\"], every = 60.0 }");
            }
            double const every = period_in(group, 1.0);
            for (auto const& [which, where] : registers_in(group, "registers", device)) {
                if (std::ranges::count(grouped, which) != 0) {
                    refuse(where, label_of(which) + " is in two groups");
                }
                grouped.push_back(which);
                add_value(device, which, every, where).every = every;
            }
        }
    }

    void read_settings(toml::table const& from, device_plan& device, line_choices const& line) const
    {
        choices const allowed = nobody_allows(line, device.unit.unit);
        for (auto const& [which, where] : registers_in(from, "settings", device)) {
            if (std::string const why = why_no_setting(which, device.drive, allowed); not why.empty()) {
                refuse(where, label_of(which) + " cannot be a setting: " + why);
            }
            add_value(device, which, period_of(from, device, which), where).setting = limits_of(which);
        }
    }

    std::string const& text_;
    bool looks_at_files_;
    gateway_plan plan_{};
    std::filesystem::path folder_{};
    std::map<std::string, unsigned, std::less<>> line_names_{};
    std::map<std::string, unsigned, std::less<>> ports_{};
    std::vector<served_place> served_places_{};
    std::map<std::string, unsigned, std::less<>> names_of_line_{};
    std::map<std::string, unsigned, std::less<>> units_of_line_{};
    std::map<std::string, std::pair<std::string, std::shared_ptr<named_places const>>> register_files_{};
};

} // namespace

gateway_plan read_gateway_file(std::string const& file, std::string const& text)
{
    return plan_reader{file, text, false}.run();
}

gateway_plan gateway_file_at(std::string const& file)
{
    file_text const found = text_of_file(file);
    if (not found.failure.empty()) {
        refuse_word(file + ": " + found.failure);
    }
    return plan_reader{file, found.text, true}.run();
}

void show_plan(gateway_plan const& plan, output_form form)
{
    output results{form, false};
    for (auto const& line : plan.lines) {
        for (device_plan const& device : line->devices) {
            for (device_value const& value : device.values) {
                results.put({{"line", line->name},
                             {"port", line->choices.port},
                             {"device", device.name},
                             {"unit", std::int64_t{device.unit.unit.byte()}},
                             {"type", device.type},
                             {"value", value.name},
                             {"measure", value.unit},
                             {"every", value.every},
                             {"set", value.setting.has_value()},
                             {"topic", "rtuwire/" + plan.site + '/' + plan.gateway + '/' + line->name + '/' +
                                           device.name + "/state"}});
            }
        }
    }
    results.finish();
}

} // namespace tool::gateway

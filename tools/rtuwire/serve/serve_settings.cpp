// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/serve_settings.hpp"

#include <set>
#include <variant>

#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "words/option_words.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

listen_place place_to_listen(std::string const& word, option_form form)
{
    port_choice const which = read_listen_word(word);
    if (which.refused) {
        refuse_word(option_words(form, line_option::listen) + ": " + which.refused->sentence);
    }
    if (auto const* const numbered = std::get_if<mbap_address>(&which.port)) {
        return {client_protocol::mbap, {numbered->host, numbered->port}};
    }
    return {client_protocol::rtu, std::get<tcp_address>(which.port)};
}

std::set<std::uint8_t> functions_in(std::string const& word)
{
    constexpr std::uint16_t last = 0x7F;
    std::set<std::uint8_t> all;
    for (std::string_view const part : parts_of(word)) {
        auto const number = word_number(part);
        if (not number or *number == 0 or *number > last) {
            refuse_word("--functions: '" + std::string{part} + "' in '" + word +
                        "' is no function: they are typed in decimal, 3,4,16, or 0x10; there are 1 to 127");
        }
        all.insert(static_cast<std::uint8_t>(*number));
    }
    return all;
}

std::string place_of(listen_place const& which)
{
    bool const is_six = which.at.host.find(':') != std::string::npos;
    return std::string{name_of(which.protocol)} + "://" + (is_six ? '[' + which.at.host + ']' : which.at.host) + ':' +
           std::to_string(which.at.port);
}

tcp_address place_of_metrics(std::string const& word)
{
    port_choice const which = read_listen_word("tcp://" + word);
    if (which.refused) {
        refuse_word("--metrics " + word + ": " + "it is an address of this machine and a port, such as 127.0.0.1:9502");
    }
    return std::get<tcp_address>(which.port);
}

void refuse_what_is_no_option_here(choices const& chosen)
{
    if (chosen.allowed.may_run) {
        refuse_word("serve: --allow-run is not for serve: nothing passes here by which a motor may turn; the command "
                    "start runs a motor, and stops it on every way out");
    }
    if (chosen.serve.may_broadcast and not chosen.allowed.may_write) {
        refuse_word("--allow-broadcast: what all units are sent is a write; say --write besides");
    }
    if (chosen.form == output_form::csv) {
        refuse_word("serve: what happens is told as it comes, or with --json as one object a line; not as --csv");
    }
    for (named_unit const& each : names_in(chosen.line)) {
        if (chosen.allowed.may_write and is_register_file(each.drive)) {
            refuse_word("serve: --write knows nothing of the limits in " + each.drive +
                        ", nor of what moves by its registers: leave " + "--write, or --name " + each.name + " out");
        }
    }
    if (not chosen.line.typed.unit.empty()) {
        refuse_word("serve:" + chosen.line.typed.unit +
                    " is for commands that ask one unit; which units clients may ask says --units behind serve: "
                    "serve --units " +
                    std::to_string(unit_in(chosen.line).unit.byte()));
    }
    if (not chosen.line.drive.empty()) {
        refuse_word("serve: --drive is of one unit: say --name fan=7:" + chosen.line.drive);
    }
}

} // namespace

serve_settings serve_settings_in(choices const& chosen)
{
    refuse_what_is_no_option_here(chosen);
    option_form const form = chosen.line.typed.form;
    serve_settings settings;
    settings.gate.form = form;
    for (std::string const& each : chosen.serve.listen) {
        settings.listen.push_back(place_to_listen(each, form));
    }
    if (settings.listen.empty()) {
        settings.listen.push_back(place_to_listen("mbap://127.0.0.1:1502", form));
    }
    if (not chosen.serve.units.empty()) {
        std::vector<std::uint8_t> units;
        if (auto const why = ended_by([&] { units = units_in(chosen.serve.units); })) {
            refuse_word(option_words(form, line_option::units) + ": " + why->what());
        }
        settings.gate.units.emplace(units.begin(), units.end());
    }
    if (not chosen.serve.functions.empty()) {
        settings.gate.functions = functions_in(chosen.serve.functions);
    }
    settings.gate.may_write = chosen.allowed.may_write;
    settings.gate.may_broadcast = chosen.serve.may_broadcast;
    for (std::string const& each : chosen.serve.from) {
        auto const range = client_range::of(each);
        if (not range) {
            refuse_word(option_words(form, line_option::from) + " " + each +
                        ": it is an address, 10.0.0.7, or those that begin alike, 192.168.1.0/24 or "
                        "fd00::/8: a length in decimal, without a zero in front, behind which all bits are 0");
        }
        settings.from.push_back(*range);
    }
    if (not chosen.serve.metrics.empty()) {
        settings.metrics = place_of_metrics(chosen.serve.metrics);
    }
    if (chosen.serve.idle) {
        settings.longest_idle = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            std::chrono::duration<double>{*chosen.serve.idle});
    }
    settings.last = chosen.last;
    return settings;
}

bool is_asked_at(std::string const& word, tcp_address const& at)
{
    port_description const port = read_port_word(word).port;
    auto const* const numbered = std::get_if<mbap_address>(&port);
    auto const* const plain = std::get_if<tcp_address>(&port);
    tcp_address asked = numbered != nullptr ? tcp_address{numbered->host, numbered->port}
                        : plain != nullptr  ? *plain
                                            : tcp_address{};
    asked.host = plain_host(asked.host);
    bool const is_name = is_same_word(asked.host, "localhost");
    bool const is_here = is_name or is_all_here(asked.host) or is_loopback(asked.host);
    // Who listens at all addresses has none of other machines.
    auto const has = [&at, is_here](std::string const& host) {
        return are_one_place(at.host, host) and (is_here or not is_all_here(at.host));
    };
    return at.port == asked.port and (is_name ? has("127.0.0.1") or has("::1") : has(asked.host));
}

std::string why_it_asks_itself(serve_settings const& settings, line_choices const& line)
{
    for (listen_place const& each : settings.listen) {
        if (is_asked_at(line.port, each.at)) {
            return option_words(settings.gate.form, line_option::listen) + ": " + place_of(each) +
                   " is the line's own port, " + line.port +
                   ": it would ask itself; say another port to listen at, or the one of the server to ask";
        }
    }
    return {};
}

std::string why_nobody_comes(serve_settings const& settings)
{
    for (listen_place const& each : settings.listen) {
        auto const can_reach = [&each](client_range const& one) { return one.can_reach(each.at.host); };
        if (not settings.from.empty() and std::ranges::none_of(settings.from, can_reach)) {
            bool const is_four = client_range::of("0.0.0.0/0")->has(each.at.host);
            std::string const kind = is_four ? "IPv4" : "IPv6";
            return option_words(settings.gate.form, line_option::from) + ": nobody could connect to " + place_of(each) +
                   (is_loopback(each.at.host)
                        ? " from there: this machine alone reaches it, by " + each.at.host +
                              "; name that, or listen at " + (is_four ? "0.0.0.0" : "[::]") +
                              ", or at an address of this machine that they reach"
                        : ", which is of " + kind + ", from addresses of " + (is_four ? "IPv6" : "IPv4") +
                              " alone: name some of " + kind + ", or listen at [::], which is of both");
        }
    }
    return {};
}

} // namespace tool

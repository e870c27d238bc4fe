// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Prints what the site shows of the headers' tables, and of the tables that the tests hold, as lines of fields between
// tabulators: the drives and their registers, and the state machines. The first field says what a line is.
#include <cstdint>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/frames.hpp>

#include "catalog/catalog.hpp"
#include "catalog/value_text.hpp"
#include "client/line/phase_table.hpp"
#include "rtu/framer_table.hpp"
#include "server/phase_table.hpp"

namespace {

template <typename T> auto const& shown(T const& value) { return value; }
std::string_view shown(rtuwire::literal text) { return text; }
unsigned shown(std::uint8_t number) { return number; }

template <typename First, typename... More> void row(First const& first, More const&... more)
{
    std::cout << first;
    ((std::cout << '\t' << shown(more)), ...);
    std::cout << '\n';
}

std::string number_or_nothing(std::optional<std::int32_t> number) { return number ? std::to_string(*number) : ""; }

/// A limit in counts and, where it is a number, as an amount.
std::string amount_of(rtuwire::bound const& limit, tool::register_entry const& entry)
{
    bool const has_amount =
        limit.is_number() and entry.steps_set_by.empty() and
        (entry.kind == tool::register_kind::number or entry.kind == tool::register_kind::signed_number);
    return has_amount ? tool::amount_text(limit.raw(), entry.step, entry.unit) : tool::text_of_bound(limit);
}

std::string step_of(tool::register_entry const& entry)
{
    bool const is_number =
        entry.kind == tool::register_kind::number or entry.kind == tool::register_kind::signed_number;
    if (not entry.steps_set_by.empty()) {
        return "set by " + std::string{entry.steps_set_by};
    }
    return is_number ? tool::amount_text(1, entry.step, entry.unit) : std::string{};
}

void print_meanings(std::string_view drive, tool::register_entry const& entry)
{
    for (std::size_t bit = 0; bit < entry.bits.size(); ++bit) {
        if (not entry.bits[bit].empty()) {
            row("bit", drive, entry.code, bit, entry.bits[bit]);
        }
    }
    for (rtuwire::choice const& each : entry.values()) {
        row("value", drive, entry.code, each.word, tool::text_of(entry, each.word));
    }
}

void print_registers(tool::drive_catalog const& drive)
{
    for (tool::register_entry const& each : drive.registers) {
        row("register", drive.name, each.code, each.address, each.name, tool::text_of(each.mode),
            tool::text_of(each.kind), step_of(each), amount_of(each.min, each), amount_of(each.max, each),
            each.factory ? tool::text_of(each, static_cast<std::uint16_t>(*each.factory)) : std::string{},
            number_or_nothing(each.factory), tool::text_of(each.source), each.is_for_driving ? "base" : "parameter");
        print_meanings(drive.name, each);
    }
}

void print_drive(tool::drive_catalog const& drive)
{
    std::ostringstream functions;
    for (unsigned code = 1; code < 128; ++code) {
        if (drive.functions.contains(static_cast<rtuwire::function_code>(code))) {
            functions << (functions.tellp() > 0 ? ", " : "") << code;
        }
    }
    rtuwire::altivar::drive_layout const& layout = drive.layout;
    row("drive", drive.name, drive.reference, drive.units.first, drive.units.last, functions.str(), drive.limits.read,
        drive.limits.write, drive.limits.exchange_read, drive.limits.exchange_write, layout.safeguards.sll,
        layout.safeguards.tto, layout.safeguards.chcf, layout.longest_silence.microseconds / 1'000'000,
        drive.registers.size());
}

void print_profile()
{
    namespace cia402 = rtuwire::cia402;
    for (auto const& each : cia402::transition_rules) {
        row("profile", cia402::name_of(each.number), cia402::name_of(each.from), cia402::name_of(each.cause),
            cia402::name_of(each.to));
    }
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        for (auto const& each : cia402::transition_rules) {
            if (cia402::step(each.from, each.cause, drive->layout.state_machine).number == each.number) {
                row("transition", drive->name, cia402::name_of(each.number), cia402::name_of(each.from),
                    cia402::name_of(each.cause), cia402::name_of(each.to));
            }
        }
    }
}

template <typename Table, typename States, typename Inputs>
void print_table(char const* machine, Table const& next, States const& states, Inputs const& inputs)
{
    for (std::size_t from = 0; from < states.size(); ++from) {
        for (std::size_t what = 0; what < inputs.size(); ++what) {
            row("step", machine, states[from], inputs[what], states[static_cast<std::size_t>(next[from][what])]);
        }
    }
}

void print_client(char const* machine, char const* table)
{
    std::istringstream words{table};
    for (std::string from; words >> from;) {
        for (char const* input : rtuwire::test::client_table::input_names) {
            std::string to;
            words >> to;
            row("step", machine, from, input, to == "." ? from : to);
        }
    }
}

} // namespace

int main()
{
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        print_drive(*drive);
        print_registers(*drive);
    }
    print_profile();
    print_table("framer", rtuwire::test::framer_table::next, rtuwire::test::framer_table::state_names,
                rtuwire::test::framer_table::input_names);
    print_table("server", rtuwire::test::server_table::next, rtuwire::test::server_table::phase_names,
                rtuwire::test::server_table::event_names);
    print_client("client", rtuwire::test::client_table::of_several_sendings);
    print_client("client without repetitions", rtuwire::test::client_table::of_one_sending);
    print_client("client with a broadcast", rtuwire::test::client_table::of_a_broadcast);
    return std::cout.good() ? 0 : 1;
}

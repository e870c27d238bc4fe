// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What passes from a client to a unit: against lists that were made by hand from the specification and the manuals.
#include "serve/write_gate.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "exit_status.hpp"
#include "line/open_line.hpp"
#include "line/raw_request.hpp"
#include "line/who_is_it.hpp"
#include "motion/raw_effect.hpp"
#include "support/catch.hpp"

using rtuwire::errc;

namespace {

using numbers = std::vector<std::uint8_t>; // bytes
using bytes = std::vector<std::byte>;

bytes raw(numbers const& all)
{
    bytes made;
    for (std::uint8_t const each : all) {
        made.push_back(std::byte{each});
    }
    return made;
}

std::uint8_t high(unsigned word) { return static_cast<std::uint8_t>(word >> 8U); }
std::uint8_t low(unsigned word) { return static_cast<std::uint8_t>(word & 0xFFU); }

/// A request of each public function, as the specification has it.
std::map<unsigned, numbers> const requests{
    {1, {1, 0, 0, 0, 8}},
    {2, {2, 0, 0, 0, 8}},
    {3, {3, 0, 0, 0, 2}},
    {4, {4, 0, 0, 0, 2}},
    {5, {5, 0, 3, 0xFF, 0}},
    {6, {6, 0, 3, 0, 9}},
    {7, {7}},
    {8, {8, 0, 0, 1, 2}},
    {11, {11}},
    {12, {12}},
    {15, {15, 0, 0, 0, 8, 1, 0xFF}},
    {16, {16, 0, 0, 0, 1, 2, 0, 9}},
    {17, {17}},
    {20, {20, 7, 6, 0, 1, 0, 0, 0, 1}},
    {21, {21, 9, 6, 0, 1, 0, 0, 0, 1, 0, 9}},
    {22, {22, 0, 4, 0, 0xF2, 0, 0x25}},
    {23, {23, 0, 3, 0, 6, 0, 14, 0, 1, 2, 0, 0xFF}},
    {24, {24, 4, 0xDE}},
    {43, {43, 14, 1, 0}},
};

/// By hand: those of them by which a unit is only read.
constexpr unsigned reading[]{1, 2, 3, 4, 7, 8, 11, 12, 17, 20, 24, 43};

/// And those by which places are written. What others do, nobody knows.
constexpr unsigned writing[]{5, 6, 15, 16, 21, 22, 23};

numbers request_of(unsigned function)
{
    auto const known = requests.find(function);
    return known != requests.end() ? known->second : numbers{static_cast<std::uint8_t>(function), 1, 2, 3};
}

tool::gate_verdict verdict(tool::gate_rules const& rules, unsigned unit, numbers const& pdu)
{
    return tool::judge_request(rules, static_cast<std::uint8_t>(unit), raw(pdu));
}

} // namespace

TEST_CASE("serve: of all functions those pass that only read, and with --write others are judged further")
{
    for (unsigned function = 0; function <= 255; ++function) {
        INFO(function);
        bool const reads = std::ranges::count(reading, function) > 0;
        auto const closed = verdict({}, 7, request_of(function));
        CHECK(closed.refused == (reads ? errc::none : errc::illegal_function));
        CHECK(closed.only_reads == reads);
        bool const writes = std::ranges::count(writing, function) > 0;
        auto const open = verdict({.may_write = true}, 7, request_of(function));
        CHECK(open.refused == (reads or writes ? errc::none : errc::illegal_function));
        CHECK(open.only_reads == reads);
    }
}

TEST_CASE("serve: a part of a function that does more than read is a write")
{
    for (unsigned sub = 1; sub <= 30; ++sub) { // 08 but for 00
        INFO(sub);
        auto const found = verdict({}, 7, {8, 0, static_cast<std::uint8_t>(sub), 0, 0});
        CHECK(found.refused != errc::none);
        CHECK_FALSE(verdict({.may_write = true}, 7, {8, 0, static_cast<std::uint8_t>(sub), 0, 0}).only_reads);
    }
    CHECK(verdict({}, 7, {43, 13, 1, 0}).refused == errc::illegal_function); // CANopen's general reference
    CHECK(verdict({}, 7, {43}).refused != errc::none);
    CHECK(verdict({}, 7, {8}).refused != errc::none);
}

TEST_CASE("serve: what is not as the specification has it is answered, and leaves no frame")
{
    for (numbers const& wrong : {numbers{3, 0, 0, 0, 126}, numbers{3, 0, 0, 0, 0}, numbers{3, 0, 0},
                                 numbers{1, 0, 0, 8, 0}, numbers{3, 0, 0, 0, 1, 0}, numbers{43, 14, 9, 0}}) {
        CHECK(verdict({}, 7, wrong).refused == errc::illegal_data_value);
    }
    tool::gate_rules const open{.may_write = true};
    CHECK(verdict(open, 7, {6, 0, 3, 0}).refused == errc::illegal_data_value);
    CHECK(verdict(open, 7, {5, 0, 3, 1, 0}).refused == errc::illegal_data_value);
    CHECK(verdict(open, 7, {16, 0, 0, 0, 2, 2, 0, 9}).refused == errc::illegal_data_value);
    CHECK(verdict({}, 7, {16, 0, 0, 0, 2, 2, 0, 9}).refused == errc::illegal_function);        // it is a write first
    CHECK(verdict(open, 7, {15, 255, 255, 0, 2, 1, 2}).refused == errc::illegal_data_address); // beyond 65535
    CHECK(verdict(open, 7, {16, 255, 255, 0, 2, 4, 0, 9, 0, 9}).refused == errc::illegal_data_address);
    CHECK(verdict(open, 7, {15, 255, 254, 0, 2, 1, 2}).refused == errc::none);
    CHECK(verdict(open, 7, {16, 255, 255, 0, 1, 2, 0, 9}).refused == errc::none);
}

TEST_CASE("serve: units and functions that nobody named are not served")
{
    tool::gate_rules const some{.units = std::set<std::uint8_t>{3, 7}, .functions = std::set<std::uint8_t>{3, 16}};
    for (unsigned unit = 1; unit <= 255; ++unit) {
        INFO(unit);
        bool const is_named = unit == 3 or unit == 7;
        CHECK(verdict(some, unit, request_of(3)).refused == (is_named ? errc::none : errc::gateway_path_unavailable));
        CHECK(verdict({}, unit, request_of(3)).refused == (unit <= 247 ? errc::none : errc::gateway_path_unavailable));
    }
    CHECK(verdict(some, 7, request_of(4)).refused == errc::illegal_function);
    CHECK(verdict(some, 7, request_of(16)).refused == errc::illegal_function); // named, and a write
}

TEST_CASE("serve: unit 0 is reached by writes alone, and where that was said")
{
    for (unsigned function = 1; function <= 127; ++function) {
        INFO(function);
        CHECK(verdict({.may_write = true}, 0, request_of(function)).refused != errc::none);
        auto const open = verdict({.may_write = true, .may_broadcast = true}, 0, request_of(function));
        CHECK((open.refused == errc::none) == (std::ranges::count(writing, function) > 0));
        CHECK_FALSE(open.only_reads);
    }
}

namespace {

/// A line with simulated drives, as `serve` has it.
struct sim_line {
    tool::choices chosen = [] {
        tool::choices made;
        made.line.port = "sim:atv320:7,atv28:8";
        made.line.must_not_listen = true;
        made.allowed.may_write = true;
        return made;
    }();
    tool::open_line line{chosen.line};

    tool::named_unit unit(unsigned number) const { return {rtuwire::unit_id{*rtuwire::unit_id::checked(number)}}; }

    /// Whether it would go to the unit.
    bool passes(unsigned number, tool::write_rules const& rules, numbers const& pdu)
    {
        return not tool::ended_by([&] { tool::refuse_for_client(raw(pdu), line, unit(number), rules, chosen); });
    }
};

/// By hand, from the manuals: commands, references, the extended command, and who commands.
constexpr unsigned of_drives[]{400, 401, 8501, 8502, 8503, 8504, 8601, 8602, 8401, 8413, 8423};

numbers write_one(unsigned address, unsigned value)
{
    return {6, high(address), low(address), high(value), low(value)};
}

/// Function 16 of `count` registers.
numbers write_block(unsigned first, unsigned count)
{
    numbers pdu{16, high(first), low(first), 0, static_cast<std::uint8_t>(count), static_cast<std::uint8_t>(2 * count)};
    pdu.resize(pdu.size() + 2U * count, 1);
    return pdu;
}

numbers write_and_read(unsigned first, unsigned count)
{
    numbers pdu{23,
                0,
                1,
                0,
                1,
                high(first),
                low(first),
                0,
                static_cast<std::uint8_t>(count),
                static_cast<std::uint8_t>(2 * count)};
    pdu.resize(pdu.size() + 2U * count, 1);
    return pdu;
}

numbers mask(unsigned address) { return {22, high(address), low(address), 0, 0, 0, 1}; }

} // namespace

TEST_CASE(
    "serve: no register of a drive's command is written where nobody knows the unit, nor by a block that covers it")
{
    sim_line at;
    tool::write_rules const nobody{};
    CHECK(at.passes(9, nobody, write_one(30'000, 5)));
    CHECK(at.passes(9, nobody, write_block(30'000, 20)));
    for (unsigned const address : of_drives) {
        INFO(address);
        for (unsigned const value : {0U, 1U, 2U, 6U, 7U, 15U, 128U, 65'535U}) {
            INFO(value);
            CHECK_FALSE(at.passes(9, nobody, write_one(address, value)));
        }
        for (unsigned count = 1; count <= 120; count += count < 4 ? 1 : 29) {
            for (unsigned before = 0; before < count; ++before) {
                INFO(count << " from " << address - before);
                CHECK_FALSE(at.passes(9, nobody, write_block(address - before, count)));
                CHECK_FALSE(at.passes(9, nobody, write_and_read(address - before, count)));
            }
        }
        CHECK_FALSE(at.passes(9, nobody, mask(address)));
    }
    // What else than a write of places goes only to a unit that says what it is.
    for (numbers const& other : {numbers{8, 0, 1, 0, 0}, numbers{0x41, 1, 2}, request_of(21), numbers{43, 13, 1, 2}}) {
        CHECK_FALSE(at.passes(9, nobody, other));
    }
}

namespace {

/// Whether a request writes 0000, disable voltage, to a command, and nothing else; that of an ATV28, whom nobody can know, is at 400.
bool is_stop(numbers const& pdu, unsigned command)
{
    bool const is_one = pdu.size() == 5 and pdu[0] == 6;
    bool const is_block = pdu.size() == 8 and pdu[0] == 16 and pdu[3] == 0 and pdu[4] == 1 and pdu[5] == 2;
    return command != 400 and (is_one or is_block) and pdu[1] == high(command) and pdu[2] == low(command) and
           pdu[pdu.size() - 2] == 0 and pdu.back() == 0;
}

} // namespace

TEST_CASE("serve: a recognised drive takes settings and what stops it, and nothing by which its motor may turn")
{
    sim_line at;
    for (unsigned const number : {7U, 8U}) {
        INFO(number);
        auto const rules = tool::rules_of_whoever(at.line, at.unit(number), at.chosen.allowed);
        REQUIRE(rules.drive != nullptr);
        CHECK(rules.drive->name == (number == 7 ? "atv320" : "atv28"));
        // All values that command, at each address of its own or another's command.
        for (unsigned const address : {400U, 401U, 8501U, 8502U, 8601U, 8602U}) {
            INFO(address);
            for (unsigned value = 0; value <= 0xFFFF; value += value < 0x20 ? 1 : 331) {
                REQUIRE(at.passes(number, rules, write_one(address, value)) ==
                        (number == 7 and address == 8501 and value == 0));
            }
            CHECK_FALSE(at.passes(number, rules, mask(address)));
        }
        for (numbers const& other :
             {numbers{8, 0, 1, 0, 0}, numbers{0x41, 1, 2}, request_of(21), numbers{43, 13, 1, 2}}) {
            CHECK_FALSE(at.passes(number, rules, other));
        }
        CHECK_FALSE(at.passes(number, rules, write_one(60'000, 1))); // a register that nobody knows
    }
    auto const rules = tool::rules_of_whoever(at.line, at.unit(7), at.chosen.allowed);
    CHECK(at.passes(7, rules, write_one(9001, 20)));             // ACC: its motor is without power
    CHECK(at.passes(7, rules, write_one(8504, 2)));              // saves
    for (unsigned const value : {0U, 1U, 3U, 4U, 8U, 0x8002U}) { // CMI: factory settings, recall
        CHECK_FALSE(at.passes(7, rules, write_one(8504, value)));
    }
    for (unsigned const channel : {8401U, 8413U, 8423U}) {
        CHECK_FALSE(at.passes(7, rules, write_one(channel, 1)));
    }
    CHECK_FALSE(at.passes(7, rules, write_one(7010, 0))); // SLL: the motor would run on without its link
    // A block with one register that is refused is refused whole.
    CHECK(at.passes(7, rules, {16, high(9001), low(9001), 0, 2, 4, 0, 20, 0, 20}));
    CHECK(at.passes(7, rules, {16, high(8501), low(8501), 0, 1, 2, 0, 0}));
    CHECK_FALSE(at.passes(7, rules, {16, high(8501), low(8501), 0, 2, 4, 0, 0, 0, 0}));
    CHECK_FALSE(at.passes(7, rules, {16, high(8501), low(8501), 0, 1, 2, 0, 6}));
    CHECK_FALSE(at.passes(7, rules, write_block(8501 - 60, 100)));
}

namespace {

/// Any request, oftener than not near what commands a drive, with values that would.
numbers drawn_request(std::mt19937& random, tool::drive_catalog const& drive)
{
    auto const below = [&random](unsigned limit) { return static_cast<unsigned>(random() % limit); };
    constexpr unsigned words[]{0, 1, 2, 6, 7, 15, 0x80, 0x86, 0x800F, 0x880A, 50, 500, 1'000};
    unsigned const near_one = of_drives[below(std::size(of_drives))] + below(7) - 3;
    auto const& any = drive.registers[below(static_cast<unsigned>(drive.registers.size()))];
    // One that is asked at another address, or at another bit rate, does not answer any more.
    bool const is_of_link = any.code == "ADD" or any.code == "TBR" or any.code == "TFO" or any.code == "BDR";
    unsigned const address = below(2) == 0 or is_of_link ? near_one : any.address;
    auto const word = [&] { return below(3) == 0 ? below(0x10000) : words[below(std::size(words))]; };
    unsigned const count = 1 + below(12);
    numbers pdu;
    switch (below(8)) {
    case 0: pdu = write_block(address - below(count), count); break;
    case 1: pdu = write_and_read(address - below(count), count); break;
    case 2:
        return {22,
                high(address),
                low(address),
                static_cast<std::uint8_t>(random()),
                static_cast<std::uint8_t>(random()),
                static_cast<std::uint8_t>(random()),
                static_cast<std::uint8_t>(random())};
    case 3:
        pdu = {static_cast<std::uint8_t>(1 + below(127))};
        for (unsigned i = below(12); i > 0; --i) {
            pdu.push_back(static_cast<std::uint8_t>(random()));
        }
        return pdu;
    default: return write_one(address, word());
    }
    for (std::size_t at = pdu.size() - 2U * count; at < pdu.size(); at += 2) {
        unsigned const value = word();
        pdu[at] = high(value);
        pdu[at + 1] = low(value);
    }
    return pdu;
}

} // namespace

TEST_CASE("serve: of 6000 drawn requests those that pass and stop nothing change nothing of a drive's command")
{
    sim_line at;
    struct of_unit {
        unsigned number;
        std::vector<std::uint16_t> commands;
    };
    std::mt19937 random{8501};
    for (of_unit const& each : {of_unit{7, {8501, 8502, 8602}}, of_unit{8, {400, 401}}}) {
        auto const unit = at.unit(each.number);
        auto const rules = tool::rules_of_whoever(at.line, unit, at.chosen.allowed);
        REQUIRE(rules.drive != nullptr);
        auto const held = [&] {
            numbers all;
            for (std::uint16_t const address : each.commands) {
                auto const read = [&] {
                    auto const once = [&] {
                        return at.line.ask(unit.unit, rtuwire::read_holding_registers{.start = address, .count = 1});
                    };
                    auto found = once();
                    for (unsigned i = 0; not found and i < 10; ++i) { // one that saves is silent for up to 2 s
                        found = once();
                    }
                    return found;
                }();
                REQUIRE(read);
                all.push_back(high(read->registers[0]));
                all.push_back(low(read->registers[0]));
            }
            return all;
        };
        numbers const before = held();
        unsigned passed = 0;
        for (unsigned i = 0; i < 3'000; ++i) {
            numbers const pdu = drawn_request(random, *rules.drive);
            auto const first =
                tool::judge_request({.may_write = true}, static_cast<std::uint8_t>(each.number), raw(pdu));
            bool const may_change_it = is_stop(pdu, each.commands[0]);
            if (first.refused != errc::none or first.only_reads or may_change_it or
                not at.passes(each.number, rules, pdu)) {
                continue;
            }
            ++passed;
            bytes const sent = raw(pdu);
            auto request = at.line.with(tool::sent_once{rtuwire::unit_id{unit.unit},
                                                        tool::raw_request{{static_cast<rtuwire::function_code>(sent[0]),
                                                                           rtuwire::byte_view{sent}.subspan(1)}}});
            static_cast<void>(at.line.run(request));
            std::string text;
            for (std::uint8_t const one : pdu) {
                text += std::to_string(one) + ' ';
            }
            INFO(text);
            REQUIRE(held() == before);
        }
        CHECK(passed > 10); // else this shows nothing
    }
}

TEST_CASE("serve: a type that somebody said is no proof, and keeps another from being taken for it")
{
    sim_line at;
    tool::named_unit wrong = at.unit(7);
    wrong.drive = "atv28";
    CHECK(tool::ended_by([&] { static_cast<void>(tool::rules_of_whoever(at.line, wrong, at.chosen.allowed)); }));
    tool::named_unit right = at.unit(7);
    right.drive = "atv320";
    CHECK(tool::rules_of_whoever(at.line, right, at.chosen.allowed).drive->name == "atv320");
    // Said to be none, it is a drive all the same, with its own table.
    right.drive = "none";
    CHECK(tool::rules_of_whoever(at.line, right, at.chosen.allowed).drive->name == "atv320");
}

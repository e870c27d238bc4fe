// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests on which other stacks failed, each whole, byte by byte, and glued to a good one.
#include <rtuwire/server/server.hpp>

#include "support/byte_list.hpp"
#include "support/catch.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using test::byte_list;
using test::bytes_of;
using test::glued;

namespace {

constexpr device_object objects[] = {{vendor_name, "vendor"}, {1, "code"}, {2, "0100"}};
constexpr server_profile profile{.identity = identity_of<objects>};

/// Every address there is, and how often one was written.
struct watched_bank {
    std::vector<std::uint16_t> words = std::vector<std::uint16_t>(65'536);
    unsigned writes{0};

    static errc check_read(std::uint16_t, std::size_t) { return errc::none; }
    static errc check_write(std::uint16_t, register_view) { return errc::none; }
    errc read(std::uint16_t start, std::size_t count, byte_writer& out) const
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(words[start + i]);
        }
        return errc::none;
    }
    errc write(std::uint16_t start, register_view values)
    {
        ++writes;
        for (std::size_t i = 0; i < values.size(); ++i) {
            words[start + i] = values[i];
        }
        return errc::none;
    }
};

/// What has to come of a request: an exception, a normal response, or nothing.
constexpr int silence = -1;
constexpr int response = 0;

struct row {
    char const* id;
    char const* frame;
    int expected;
    unsigned writes{0};
};

// Of functions that this server does not have it answers 01, where one that has them answers 03.
constexpr row rows[] = {
    {"S01", "01 03 00 00 00 00 45 CA", 3},
    {"S02", "01 03 00 00 00 7E C5 EA", 3},
    {"S03", "01 03 00 01 FF FF 15 BA", 3},
    {"S04", "01 01 00 00 07 D1 FE 66", 1},
    {"S06", "01 03 FF FF 00 01 84 2E", response},
    {"S07", "01 10 00 00 00 7B 06 00 01 00 02 00 03 3C 03", 3},
    {"S09", "01 0F 00 00 07 B0 06 FF FF FF FF FF FF 5F B5", 1},
    {"S10", "01 0F 00 00 00 08 02 FF FF E5 30", 1},
    {"S11", "01 10 00 00 00 7B FF 5A*255 EB 56", silence},
    {"S13", "01 10 00 00 00 01 02 00 05 AA BB 55 4E", 3},
    {"S14", "01 10 00 00 00 01 03 00 05 00 D2 D6", 3},
    {"S16", "01 17 00 00 00 01 00 00 00 7A F4 5A*244 BA E0", silence},
    {"S17", "01 17 00 00 00 01 00 00 00 01 02 33 D7", 3},
    {"S19", "01 06 00 01 00 03 00 0A AA", 3},
    {"S20", "01 05 00 01 12 34 91 7D", 1},
    {"S21", "01 16 00 04 00 F2 00 4D 66", 1},
    {"S22", "01 11 C0 2C", 1},
    {"S23", "01 03 40 21", 3},
    {"S26", "01 42 00 00 00 00 79 C5", 1},
    {"S27", "01 83 02 C0 F1", silence},
    {"S28", "01 14 0E 06 00 01 00 00 00 7C 06 00 01 00 00 00 7C 06 7E", 1},
    {"S29", "01 14 07 06 00 01 00 00 80 00 A5 24", 1},
    {"S30", "02 03 00 01 FF FF 15 89", silence},
    {"S32", "00 03 00 00 00 01 85 DB", silence},
    {"S33", "00 06 00 01 00 03 99 DA", silence, 1},
    {"S34", "FF 03 00 00 00 01 91 D4", silence},
    {"S37", "01 41 5A*252 C9 57", 1},
    {"S39", "01 2B 0E 04 07 32 E5", 2},
};

constexpr auto good = "01 03 00 00 00 01 84 0A"_hex;
constexpr auto good_response = "01 03 02 00 00 B8 44"_hex;

struct unit_1 : test::server_on_a_line<server, watched_bank> {
    unit_1() : server_on_a_line{test::usual_line, profile} {}

    /// What it answers to bytes that come in lumps of a size.
    byte_list response_to(byte_view heard, std::size_t lump)
    {
        byte_list said;
        for (; not heard.empty(); heard = heard.subspan(lump < heard.size() ? lump : heard.size())) {
            byte_view const some = heard.first(lump < heard.size() ? lump : heard.size());
            hear(some);
        }
        for (unsigned i = 0; i < 8; ++i) {
            pass(line.t3_5());
            byte_view const frame = node.poll_transmit();
            said.insert(said.end(), frame.begin(), frame.end());
            node.sent(now);
        }
        return said;
    }
};

bool is_expected(byte_list const& said, row const& of)
{
    if (of.expected == silence) {
        return said.empty();
    }
    if (of.expected == response) {
        return said.size() > 5 and to_u8(said[1]) < 0x80;
    }
    return said.size() == 5 and to_u8(said[1]) >= 0x80 and to_u8(said[2]) == of.expected;
}

} // namespace

TEST_CASE("every malformed request gets its response, whole and byte by byte")
{
    for (row const& each : rows) {
        byte_list const frame = bytes_of(each.frame);
        for (std::size_t const lump : {std::size_t{300}, std::size_t{1}}) {
            INFO(each.id << " in lumps of " << lump);
            unit_1 unit;
            CHECK(is_expected(unit.response_to(frame, lump), each));
            CHECK(unit.bank.writes == each.writes);
            CHECK(unit.response_to(good, lump).size() == good_response.size());
        }
    }
}

TEST_CASE("glued to a good request it does no harm, and the next one is answered")
{
    for (row const& each : rows) {
        byte_list const frame = bytes_of(each.frame);
        INFO(each.id);
        unit_1 behind;
        byte_list const said = behind.response_to(glued(frame, good), 300);
        CHECK((said.empty() or is_expected(said, each) or same_bytes(said, good_response)));
        CHECK(behind.bank.writes <= each.writes);
        CHECK(behind.response_to(good, 300).size() == good_response.size());

        unit_1 before;
        byte_list good_one{good.begin(), good.end()};
        // The request that came last is the one that counts.
        CHECK(is_expected(before.response_to(glued(good_one, frame), 300), each));
        CHECK(before.bank.writes == each.writes);
        CHECK(before.response_to(good, 300).size() == good_response.size());
    }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests on which other stacks failed, and ten and more for each function that a server has beside those of holding
// registers: each whole, byte by byte, in growing chunks, and glued to a good one.
#include <rtuwire/server/server.hpp>

#include "scenario/requests_of_functions.hpp"
#include "support/byte_list.hpp"
#include "support/catch.hpp"
#include "support/feeding.hpp"
#include "support/server_on_a_line.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::byte_list;
using test::bytes_of;
using test::feeding;
using test::glued;
using test::request_row;
using test::silence;

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
    unsigned all_writes() const { return writes; }
};

constexpr errc response = errc::none;

// Of functions that this server does not have it answers 01, where one that has them answers 03.
constexpr request_row rows[] = {
    {"S01", "01 03 00 00 00 00 45 CA", errc::illegal_data_value},
    {"S02", "01 03 00 00 00 7E C5 EA", errc::illegal_data_value},
    {"S03", "01 03 00 01 FF FF 15 BA", errc::illegal_data_value},
    {"S04", "01 01 00 00 07 D1 FE 66", errc::illegal_function},
    {"S06", "01 03 FF FF 00 01 84 2E", response},
    {"S07", "01 10 00 00 00 7B 06 00 01 00 02 00 03 3C 03", errc::illegal_data_value},
    {"S09", "01 0F 00 00 07 B0 06 FF FF FF FF FF FF 5F B5", errc::illegal_function},
    {"S10", "01 0F 00 00 00 08 02 FF FF E5 30", errc::illegal_function},
    {"S11", "01 10 00 00 00 7B FF 5A*255 EB 56", silence},
    {"S13", "01 10 00 00 00 01 02 00 05 AA BB 55 4E", errc::illegal_data_value},
    {"S14", "01 10 00 00 00 01 03 00 05 00 D2 D6", errc::illegal_data_value},
    {"S16", "01 17 00 00 00 01 00 00 00 7A F4 5A*244 BA E0", silence},
    {"S17", "01 17 00 00 00 01 00 00 00 01 02 33 D7", errc::illegal_data_value},
    {"S19", "01 06 00 01 00 03 00 0A AA", errc::illegal_data_value},
    {"S20", "01 05 00 01 12 34 91 7D", errc::illegal_function},
    {"S21", "01 16 00 04 00 F2 00 4D 66", errc::illegal_function},
    {"S22", "01 11 C0 2C", errc::illegal_function},
    {"S23", "01 03 40 21", errc::illegal_data_value},
    {"S26", "01 42 00 00 00 00 79 C5", errc::illegal_function},
    {"S27", "01 83 02 C0 F1", silence},
    {"S28", "01 14 0E 06 00 01 00 00 00 7C 06 00 01 00 00 00 7C 06 7E", errc::illegal_function},
    {"S29", "01 14 07 06 00 01 00 00 80 00 A5 24", errc::illegal_function},
    {"S30", "02 03 00 01 FF FF 15 89", silence},
    {"S32", "00 03 00 00 00 01 85 DB", silence},
    {"S33", "00 06 00 01 00 03 99 DA", silence, "sent to all", 1},
    {"S34", "FF 03 00 00 00 01 91 D4", silence},
    {"S37", "01 41 5A*252 C9 57", errc::illegal_function},
    {"S39", "01 2B 0E 04 07 32 E5", errc::illegal_data_address},
};

constexpr auto good = "01 03 00 00 00 01 84 0A"_hex;
constexpr auto good_response = "01 03 02 00 00 B8 44"_hex;

template <typename Server, typename Bank> struct unit_1 : test::server_on_a_line<Server, Bank> {
    unit_1() : test::server_on_a_line<Server, Bank>{test::usual_line, profile} {}

    /// What it answers to bytes that come so.
    byte_list response_to(byte_view heard, feeding how)
    {
        byte_list said;
        test::feed(heard, how, [this](byte_view some) { this->hear(some); });
        for (unsigned i = 0; i < 8; ++i) {
            this->pass(this->line.t3_5());
            byte_view const frame = this->node.poll_transmit();
            said.insert(said.end(), frame.begin(), frame.end());
            this->node.sent(this->now);
        }
        return said;
    }
};

using unit_of_registers = unit_1<server, watched_bank>;
using unit_of_all_functions = unit_1<basic_server<serial_diagnostics, public_functions>, test::whole_bank>;

bool is_expected(byte_list const& said, request_row const& of, byte_list const& asked)
{
    if (of.expected == silence) {
        return said.empty();
    }
    if (of.expected == response) {
        return said.size() > 5 and to_u8(said[1]) < 0x80;
    }
    return said.size() == 5 and said[0] == asked[0] and said[1] == (asked[1] | std::byte{0x80}) and
           said[2] == static_cast<std::byte>(of.expected) and crc16(said) == 0;
}

template <typename Unit, typename Rows> void check_alone(Rows const& all)
{
    for (request_row const& each : all) {
        byte_list const frame = bytes_of(each.frame);
        for (feeding const how : test::feedings) {
            INFO(each.id << ", " << each.why << ", in chunks: " << static_cast<int>(how));
            Unit unit;
            CHECK(is_expected(unit.response_to(frame, how), each, frame));
            CHECK(unit.bank.all_writes() == each.writes);
            CHECK(same_bytes(unit.response_to(good, how), good_response));
        }
    }
}

template <typename Unit, typename Rows> void check_glued(Rows const& all)
{
    for (request_row const& each : all) {
        byte_list const frame = bytes_of(each.frame);
        INFO(each.id << ", " << each.why);
        Unit behind;
        byte_list const said = behind.response_to(glued(frame, good), feeding::whole);
        CHECK((said.empty() or is_expected(said, each, frame) or same_bytes(said, good_response)));
        CHECK(behind.bank.all_writes() <= each.writes);
        CHECK(same_bytes(behind.response_to(good, feeding::whole), good_response));

        Unit before;
        byte_list good_one{good.begin(), good.end()};
        // The request that came last is the one that counts.
        CHECK(is_expected(before.response_to(glued(good_one, frame), feeding::whole), each, frame));
        CHECK(before.bank.all_writes() == each.writes);
        CHECK(same_bytes(before.response_to(good, feeding::whole), good_response));
    }
}

} // namespace

TEST_CASE("every malformed request gets its response, whole, byte by byte and in growing chunks")
{
    check_alone<unit_of_registers>(rows);
    check_alone<unit_of_all_functions>(test::requests_of_functions);
}

TEST_CASE("glued to a good request it does no harm, and the next one is answered")
{
    check_glued<unit_of_registers>(rows);
    check_glued<unit_of_all_functions>(test::requests_of_functions);
}

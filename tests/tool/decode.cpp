// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes explained. Their CRCs are made here bit by bit, as the specification describes it, and all of what is said
// stands here as a person wrote it.
#include "frame/decode.hpp"

#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

#include "device/register_file.hpp"
#include "exit_status.hpp"
#include "frame/function_text.hpp"
#include "frame/hex_lines.hpp"
#include "frame/hex_text.hpp"
#include "frame/names_by_file.hpp"

namespace {

using bytes = std::vector<std::byte>;

bytes raw(std::initializer_list<unsigned> numbers)
{
    bytes made;
    for (unsigned const each : numbers) {
        made.push_back(static_cast<std::byte>(each));
    }
    return made;
}

bytes framed(std::initializer_list<unsigned> numbers)
{
    unsigned crc = 0xFFFF;
    for (unsigned const each : numbers) {
        crc ^= each;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U;
        }
    }
    bytes made = raw(numbers);
    made.push_back(static_cast<std::byte>(crc & 0xFFU));
    made.push_back(static_cast<std::byte>(crc >> 8U));
    return made;
}

bytes operator+(bytes left, bytes const& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

std::vector<tool::decoded_frame> decoded(bytes const& run, std::string_view drive = "")
{
    if (drive.empty()) {
        return tool::frame_decoder{nullptr}.decode(run);
    }
    tool::names_by_drive const names{*tool::catalog_named(drive)};
    return tool::frame_decoder{&names}.decode(run);
}

/// "offset+length name: value; ..." of the fields between unit and CRC.
std::string told(tool::frame_reading const& reading)
{
    std::string text = reading.as;
    for (auto const& each : reading.fields) {
        if (each.name != "unit" and each.name != "CRC" and each.name != "function") {
            text += "; " + std::to_string(each.offset) + '+' + std::to_string(each.length) + ' ' + each.name + ": " +
                    each.value;
        }
    }
    return text + (reading.flaw.empty() ? "" : "; flaw: " + reading.flaw);
}

std::string told(bytes const& frame, std::string_view drive = "")
{
    auto const frames = decoded(frame, drive);
    REQUIRE(frames.size() == 1);
    REQUIRE(frames[0].readings.size() == 1);
    CHECK(frames[0].is_good());
    return told(frames[0].readings[0]);
}

std::string value_of(tool::frame_reading const& reading, std::string_view name)
{
    for (auto const& each : reading.fields) {
        if (each.name == name) {
            return each.value;
        }
    }
    return "(none)";
}

/// All runs of a text, as hexadecimal digits; or why there is one that is none.
std::string runs_in(std::string const& text)
{
    std::istringstream from{text};
    tool::hex_lines lines{from};
    tool::byte_run run;
    std::string found;
    try {
        while (lines.next(run)) {
            found += (found.empty() ? "" : "/") + tool::hex_of(run.bytes) + (run.is_decimal ? " decimal" : "");
            found += run.or_decimal.empty() ? "" : " or " + tool::hex_of(run.or_decimal) + " decimal";
        }
    } catch (tool::ended const& why) {
        CHECK(why.status == tool::exit_status::usage);
        return why.what();
    }
    return found;
}

} // namespace

TEST_CASE("each field of a frame is told")
{
    CHECK(told(framed({7, 3, 0x0C, 0x82, 0, 2})) == "request; 2+2 first register: 3202; 4+2 quantity: 2");
    CHECK(told(framed({7, 3, 0x0C, 0x82, 0, 2}), "atv320") ==
          "request; 2+2 first register: 3202 (RFR); 4+2 quantity: 2");
    CHECK(told(framed({7, 6, 0x21, 0x35, 0, 6})) == "request or response; 2+2 register: 8501; 4+2 register 8501: 6");
    CHECK(told(framed({7, 5, 0, 9, 0xFF, 0})) == "request or response; 2+2 coil: 9; 4+2 value: on");
    CHECK(
        told(framed({7, 16, 0x21, 0x36, 0, 1, 2, 0x01, 0xF4}), "atv320") ==
        "request; 2+2 first register: 8502 (LFR); 4+2 quantity: 1; 6+1 byte count: 2; 7+2 register 8502 LFR: 50.0 Hz");
    CHECK(told(framed({0, 15, 0, 4, 0, 10, 2, 0x0D, 0x03})) ==
          "request; 2+2 first coil: 4; 4+2 quantity: 10; 6+1 byte count: 2; 7+1 coils 4 to 11: 1 0 1 1 0 0 0 0; "
          "8+1 coils 12 to 13: 1 1");
    CHECK(told(framed({7, 8, 0, 0, 0xA5, 0x37})) ==
          "request or response; 2+2 sub-function: return query data; 4+2 data: 42295");
    CHECK(told(framed({7, 22, 0, 4, 0, 0xF2, 0, 0x25})) ==
          "request or response; 2+2 register: 4; 4+2 AND mask: 242; 6+2 OR mask: 37");
    CHECK(told(framed({7, 23, 0, 3, 0, 6, 0, 14, 0, 1, 2, 0, 255})) ==
          "request; 2+2 first register to read: 3; 4+2 quantity to read: 6; 6+2 first register to write: 14; "
          "8+2 quantity to write: 1; 10+1 byte count: 2; 11+2 register 14: 255");
    CHECK(told(framed({7, 24, 0, 6, 0, 2, 0x01, 0xB8, 0x12, 0x84})) ==
          "response; 2+2 byte count: 6; 4+2 registers in the queue: 2; 6+2 register no. 1 of 2: 440; "
          "8+2 register no. 2 of 2: 4740");
    CHECK(told(framed({7, 43, 14, 1, 1, 0, 0, 1, 0, 2, 'S', 'E'})) ==
          "response; 2+1 type: read device identification; 3+1 access: basic; 4+1 conformity: 1; 5+1 more follows: no; "
          "6+1 next object: 0; 7+1 objects: 1; 8+1 object: 0: vendor name; 9+1 length: 2; 10+2 object 0: \"SE\"");
    CHECK(told(framed({7, 65, 1, 2})) == "request or response; 2+2 data: 01 02");
    CHECK(told(framed({7, 3, 0, 0, 1, 0})) ==
          "request; 2+2 first register: 0; 4+2 quantity: 256; flaw: quantity outside the function's limits");
}

TEST_CASE("unit, function and exception are told in words")
{
    auto const frame = decoded(framed({7, 0x83, 2}))[0];
    CHECK(value_of(frame.readings[0], "function") == "read holding registers, refused");
    CHECK(value_of(frame.readings[0], "exception") == "illegal data address");
    CHECK(value_of(decoded(framed({7, 0x83, 0}))[0].readings[0], "exception") == "an exception with an unlisted code");
    CHECK(value_of(decoded(framed({0, 6, 0, 1, 0, 2}))[0].readings[0], "unit") == "0, broadcast");
    CHECK(value_of(decoded(framed({248, 6, 0, 1, 0, 2}))[0].readings[0], "unit") == "248, reserved");
    CHECK(tool::function_text(static_cast<rtuwire::function_code>(65)) == "function 65 (0x41)");
}

TEST_CASE("what may be a request and a response is told as both, but for the response that follows its request")
{
    bytes const either = framed({1, 1, 3, 0, 0, 20});
    auto const alone = decoded(either);
    REQUIRE(alone.size() == 1);
    REQUIRE(alone[0].readings.size() == 2);
    CHECK(told(alone[0].readings[0]) == "request; 2+2 first coil: 768; 4+2 quantity: 20");
    CHECK(alone[0].readings[1].as == "response");

    auto const pair = decoded(framed({1, 1, 0, 30, 0, 20}) + either);
    REQUIRE(pair.size() == 2);
    REQUIRE(pair[1].readings.size() == 1);
    CHECK(value_of(pair[1].readings[0], "coils 46 to 49") == "0 0 1 0"); // the other bits fill the byte
}

TEST_CASE("a register file names what passed, by the request of a response, and shows no part of a value as one")
{
    tool::named_places const file = tool::read_register_file("t.toml", R"([[register]]
name = "count"
address = 100
type = "u64"
order = "cdab"
[[register]]
name = "label"
space = "input"
address = 7
type = "text6"
[[register]]
name = "door"
space = "discrete"
address = 9
choices = { shut = 0, ajar = 1 }
)");
    tool::names_by_file const names{file};
    tool::frame_decoder decoder{&names};
    auto const told_of = [&](bytes const& run) { return told(decoder.decode(run).back().readings.back()); };
    bytes const asked = framed({61, 3, 0, 100, 0, 4});
    bytes const count = framed({61, 3, 8, 0, 4, 0, 3, 0, 2, 0, 1});
    CHECK(told_of(asked) == "request; 2+2 first register: 100 (count); 4+2 quantity: 4");
    CHECK(told_of(count) == "response; 2+1 byte count: 8; 3+8 registers 100 to 103 count: 281483566841860");
    CHECK(told_of(framed({61, 3, 0, 101, 0, 2}) + framed({61, 3, 4, 0, 3, 0, 2})) ==
          "response; 2+1 byte count: 4; 3+4 registers 101 to 102 count: no value: 0x00030002 is registers 2 to 3 of "
          "its 4");
    CHECK(told_of(framed({61, 3, 0, 103, 0, 2}) + framed({61, 3, 4, 0, 1, 0, 9})) ==
          "response; 2+1 byte count: 4; 3+2 register 103 count: no value: 0x0001 is register 4 of its 4; 5+2 register "
          "104: 9");
    CHECK(told_of(framed({61, 3, 0, 99, 0, 2}) + framed({61, 3, 4, 0, 9, 0, 4})) ==
          "response; 2+1 byte count: 4; 3+2 register 99: 9; 5+2 register 100 count: no value: 0x0004 is register 1 of "
          "its 4");
    CHECK(told_of(framed({61, 4, 0, 7, 0, 3}) + framed({61, 4, 6, 'A', 'b', 'c', 0, 0, 0})) ==
          "response; 2+1 byte count: 6; 3+6 registers 7 to 9 label: Abc");
    CHECK(told_of(framed({61, 2, 0, 8, 0, 2}) + framed({61, 2, 1, 0xFE})) ==
          "response; 2+1 byte count: 1; 3+1 discrete inputs 8 to 9: 0 1; 3+1 discrete input 9 door: ajar (1)");
    CHECK(told_of(framed({61, 16, 0, 100, 0, 2, 4, 0, 4, 0, 3})) ==
          "request; 2+2 first register: 100 (count); 4+2 quantity: 2; 6+1 byte count: 4; "
          "7+4 registers 100 to 101 count: no value: 0x00040003 is registers 1 to 2 of its 4");

    std::string const unnamed = "response; 2+1 byte count: 8; 3+2 register no. 1 of 4: 4; 5+2 register no. 2 of 4: 3; "
                                "7+2 register no. 3 of 4: 2; "
                                "9+2 register no. 4 of 4: 1";
    CHECK(told_of(count) == unnamed);
    CHECK(told_of(asked + framed({61, 3, 4, 0, 4, 0, 3})) ==
          "response; 2+1 byte count: 4; 3+2 register no. 1 of 2: 4; 5+2 register no. 2 of 2: 3"); // another count
    CHECK(told_of(framed({60, 3, 0, 100, 0, 4}) + count) == unnamed);

    // Of a capture it is known which request was answered, be it late and behind another.
    static_cast<void>(decoder.decode(framed({61, 3, 0, 200, 0, 4})));
    decoder.expect_answer_to(asked);
    CHECK(told_of(count) == "response; 2+1 byte count: 8; 3+8 registers 100 to 103 count: 281483566841860");
    static_cast<void>(decoder.decode(asked));
    decoder.expect_answer_to({});
    CHECK(told_of(count) == unnamed);
}

TEST_CASE("registers of a response have the addresses of its request")
{
    bytes const answer = framed({7, 3, 4, 0x01, 0xF4, 0xFF, 0xFB});
    auto const pair = decoded(framed({7, 3, 0x0C, 0x81, 0, 2}) + answer, "atv320");
    REQUIRE(pair.size() == 2);
    CHECK(pair[1].offset == 8);
    CHECK(value_of(pair[1].readings[0], "register 3202 RFR") == "-0.5 Hz");
    for (bytes const& other : {framed({8, 3, 0x0C, 0x81, 0, 2}), framed({7, 3, 0x0C, 0x81, 0, 3}),
                               framed({7, 4, 0x0C, 0x81, 0, 2}), framed({7, 3, 0x0C, 0x81, 0, 2}) + framed({7, 7})}) {
        CHECK(value_of(decoded(other + answer, "atv320").back().readings[0], "register no. 2 of 2") == "65531");
    }
    auto const input = decoded(framed({7, 4, 0x0C, 0x81, 0, 2}) + framed({7, 4, 4, 1, 0xF4, 0, 0}), "atv320");
    CHECK(value_of(input[1].readings[0], "register 3201") == "500"); // an input register has no drive's name
}

TEST_CASE("a wrong CRC is told with the right one")
{
    bytes frame = framed({7, 3, 0x0C, 0x82, 0, 2});
    std::string const right = tool::hex_of(rtuwire::byte_view{frame}.last(2));
    std::swap(frame[6], frame[7]);
    auto found = decoded(frame);
    REQUIRE(found.size() == 1);
    CHECK((not found[0].has_right_crc and found[0].is_whole));
    CHECK(value_of(found[0].readings[0], "CRC") == "wrong, right is " + right + " (swapped)");
    frame[7] = std::byte{0};
    CHECK(value_of(decoded(frame)[0].readings[0], "CRC") == "wrong, right is " + right);
}

TEST_CASE("frames one after the other are parted, with what is between them")
{
    bytes const one = framed({7, 3, 0x0C, 0x82, 0, 2});
    bytes const two = framed({7, 3, 4, 0x01, 0xF4, 0, 0});
    bytes const not_public = framed({9, 65, 1, 2, 3});
    bytes const too_many = framed({7, 3, 0, 0, 1, 0});
    bytes damaged = one;
    damaged[3] ^= std::byte{1};
    auto const found = decoded(one + two + not_public + too_many + damaged + raw({0}) + one + raw({7, 3, 12}));
    std::vector<std::size_t> sizes;
    std::vector<bool> are_good;
    for (auto const& each : found) {
        sizes.push_back(each.bytes.size());
        are_good.push_back(each.is_good());
    }
    CHECK(sizes == std::vector<std::size_t>{8, 9, 7, 8, 9, 8, 3});
    CHECK(are_good == std::vector<bool>{true, true, true, true, false, true, false});
    CHECK(found.back().readings[0].flaw == "3 bytes, where its fields say at least 6");
    CHECK(found.back().readings[1].flaw == "3 bytes, where its fields say at least 7");
    CHECK(decoded(raw({255}))[0].readings[0].flaw == "1 byte, where its fields say at least 4");
    CHECK(decoded({}).empty());
}

TEST_CASE("each frame that is cut short, and any bytes at all, are explained as far as they go")
{
    for (bytes const& whole :
         {framed({7, 43, 14, 1, 1, 0, 0, 1, 0, 2, 'S', 'E'}), framed({7, 21, 9, 6, 0, 4, 0, 7, 0, 1, 6, 0xAF}),
          framed({7, 20, 6, 5, 6, 0x0D, 0xFE, 0, 0x20}), framed({7, 12, 8, 0, 0, 1, 8, 1, 0x21, 0x20, 0}),
          framed({7, 16, 0, 1, 0, 2, 4, 0, 10, 1, 2}), bytes(300, std::byte{3}), bytes(256, std::byte{20})}) {
        for (std::size_t size = 1; size <= whole.size(); ++size) {
            bytes const part{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)};
            std::size_t next = 0;
            for (auto const& frame : decoded(part)) {
                CHECK(frame.offset == next);
                CHECK_FALSE(frame.readings.empty());
                for (auto const& reading : frame.readings) {
                    for (auto const& each : reading.fields) {
                        CHECK(each.offset + each.length <= frame.bytes.size());
                    }
                }
                next += frame.bytes.size();
            }
            CHECK(next == size);
        }
    }
}

TEST_CASE("a register file explains any bytes as far as they go")
{
    std::string text;
    for (char const* const space : {"holding", "input", "coil", "discrete"}) {
        for (int address = 0; address < 32; ++address) {
            bool const is_bit = space[0] == 'c' or space[0] == 'd';
            bool const is_wide = not is_bit and address % 4 == 0;
            if (is_bit or is_wide or address % 4 == 3) {
                text += std::string{"[[register]]\nname = \""} + space[0] + "_" + std::to_string(address) +
                        "\"\nspace = \"" + space + "\"\naddress = " + std::to_string(address) + '\n' +
                        (is_wide  ? "type = \"text5\"\n"
                         : is_bit ? ""
                                  : "bits = \"3-15\"\n");
            }
        }
    }
    tool::named_places const file = tool::read_register_file("t.toml", text);
    tool::names_by_file const names{file};
    tool::frame_decoder decoder{&names};
    unsigned drawn = 1;
    auto const draw = [&drawn](unsigned below) { return (drawn = drawn * 1'103'515'245U + 12'345U) / 65'536U % below; };
    constexpr unsigned functions[] = {1, 2, 3, 4, 5, 6, 15, 16, 22, 23};
    std::size_t named = 0;
    for (int i = 0; i < 3'000; ++i) {
        unsigned const function = functions[draw(10)];
        bytes run = framed({61, function, draw(9) == 0 ? 255U : 0U, draw(40), 0, draw(20), draw(20), draw(4)});
        unsigned const count = 1 + draw(20);
        if (function < 5 and draw(4) != 0) {
            run = framed({61, function, 0, draw(40), 0, count});
            bytes body = raw({61, function, function < 3 ? (count + 7) / 8 : 2 * count});
            for (unsigned k = std::to_integer<unsigned>(body[2]) + 2; k > 0; --k) {
                body.push_back(static_cast<std::byte>(draw(256)));
            }
            unsigned const crc = rtuwire::crc16(rtuwire::byte_view{body}.first(body.size() - 2));
            body[body.size() - 2] = static_cast<std::byte>(crc & 0xFFU);
            body[body.size() - 1] = static_cast<std::byte>(crc >> 8U);
            run = run + body;
        }
        run.resize(run.size() - (draw(4) == 0 ? draw(static_cast<unsigned>(run.size())) : 0));
        for (auto const& frame : decoder.decode(run)) {
            for (auto const& reading : frame.readings) {
                for (auto const& each : reading.fields) {
                    REQUIRE(each.offset + each.length <= frame.bytes.size());
                    named += each.label.empty() ? 0U : 1U;
                }
            }
        }
    }
    CHECK(named > 3'000);
}

TEST_CASE("bytes are written in many ways")
{
    for (char const* const text :
         {"01 AB 0c", "01AB0C", "0x01,0xAB,0x0C", "\\x01\\xab\\x0c", "01:ab:0C", "[01][AB][0C]", "<01><AB><0C>",
          "{ 0X01, 0XAB, 0X0C };", "1 AB C", "0x01AB 0C", "\t01-AB-0C\r\n\n"}) {
        INFO(text);
        CHECK(runs_in(text) == "01 AB 0C");
    }
    CHECK(runs_in("01 02\n\n03\n") == "01 02/03");
    CHECK(runs_in("") == "");
}

TEST_CASE("lines of a dump are one run, without their offsets and characters")
{
    std::string const first = "00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F";
    for (char const* const text :
         {"00000000  00 01 02 03 04 05 06 07  08 09 0a 0b 0c 0d 0e 0f  |abcd 12|\n00000010  10 11   |ab|\n00000012\n",
          "00000000: 0001 0203 0405 0607 0809 0a0b 0c0d 0e0f  ab cd 01\n00000010: 1011  ab\n",
          "0000000 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f\n0000020 10 11\n0000022\n",
          "0000  00 01 02 03 04 05 06 07  08 09 0a 0b 0c 0d 0e 0f   ........ ab\n0010  10 11   ab\n"}) {
        INFO(text);
        CHECK(runs_in(text) == first + " 10 11");
    }
    CHECK(runs_in("00000000  01 02\n00000000  03 04\n") == "01 02/03 04"); // two dumps
    CHECK(runs_in("0103 00 02") == "01 03 00 02");                         // no offset
}

TEST_CASE("a date or a time in front of a line is no part of its bytes")
{
    for (char const* const time : {"2026-11-25 07:03:01 ", "2026-11-25T07:03:01Z ", "2026-11-25T07:03:01.123+0100 ",
                                   "2026/11/25 07:03:01,5 ", "[2026-11-25 07:03:01.123456] ", "07:03:01 ",
                                   "  07:03:01.999  ", "(23:59:60) ", "2026-11-25 ", "2026-11-25T07:03:01+01:00\t"}) {
        INFO(time);
        CHECK(runs_in(time + std::string{"07 03 0C 82"}) == "07 03 0C 82");
        CHECK(runs_in(time + std::string{"07 03\n"} + time + "07 04") == "07 03/07 04");
    }
    CHECK(runs_in("2026-11-25 07:03:01\n") == "");
    CHECK(runs_in("2026-11-25 07:03:01 0000  01 02\n2026-11-25 07:03:01 0002  03") == "01 02 03"); // a dump
    CHECK(runs_in("07:03:01") == "07 03 01");
    CHECK(runs_in("07:03:01:0C:82") == "07 03 01 0C 82");
    CHECK(runs_in("07:03:01 0C:82") == "07 03 01 0C 82");
    CHECK(runs_in("24:03:01 0C") == "24 03 01 0C");
    CHECK(runs_in("20-26-11-25 07") == "20 26 11 25 07");
    CHECK(runs_in("2026-11-25 07:03:01 TX 01") == "01");
}

TEST_CASE("what is no hexadecimal number is refused with its place")
{
    CHECK(runs_in("01 03\n  01 0G") == "line 2, character 6: '0G' is no hexadecimal number");
    CHECK(runs_in("01 123") == "line 1, character 4: '123' has 3 digits: a byte has two");
    CHECK(runs_in("0x") == "line 1, character 1: '0x' is no hexadecimal number");
    CHECK(runs_in("x01") == "line 1, character 1: 'x01' is no hexadecimal number");
    CHECK(runs_in("12.5") == "line 1, character 1: '12.5' is no hexadecimal number");
}

namespace {

// The request and the response of one exchange, which logs below show in their ways.
constexpr auto asked = "01 03 00 00 00 01 84 0A", told_07 = "01 03 02 00 07 F9 86";

} // namespace

TEST_CASE("defect: D38 bytes are found in the lines of logs")
{
    struct row {
        char const* line;
        std::string_view run;
    };
    row const rows[] = {
        // A literal of a script: its b is no byte.
        {R"(b'\x01\x03\x02\x12\x34\xb5\x33')", "01 03 02 12 34 B5 33"},
        {R"(bytearray(b'\x01\x03\x02\x12\x34\xb5\x33'))", "01 03 02 12 34 B5 33"},
        {R"(b"\x01\x03\x00\x00\x00\x01\x84\n")", asked},
        {R"(b'0103000000018 40A')", "line 1, character 3: '0103000000018' has 13 digits: a byte has two"},
        {"b'010300000001840a'", asked},
        // Names of roles in front, words of one or two digits.
        {"SEND: 0x2 0x3 0x0 0x18 0x0 0x9 0x5 0xf8", "02 03 00 18 00 09 05 F8"},
        {"DEBUG:pymodbus.logging:RECV: 0x1 0x3 0x2 0x0 0x7 0xf9 0x86", told_07},
        {"2024-01-05 10:11:12,345 DEBUG transaction:297 RECV: 0x1 0x3 0x2 0x0 0x7 0xf9 0x86", told_07},
        {"TX -> 01 03 00 00 00 01 84 0A", asked},
        {"Received: [01] [03] [02] [00] [07] [f9] [86]", told_07},
        // Points, and colons, between the bytes.
        {"F7.03.50.0A.00.05.A0.5D", "F7 03 50 0A 00 05 A0 5D"},
        {"[12:34:56][V][modbus:199]: Modbus write: 01.03.00.00.00.01.84.0A (8)", asked},
        {"[12:34:56][D][uart_debug:114]: >>> 01:03:00:00:00:01:84:0A", asked},
        {"[10:20:30][D][uart_debug:114]: <<< 01:03:02:00:07:F9:87", "01 03 02 00 07 F9 87"},
        // A counter.
        {"Tx:000011-01 01 01 00 51 88", "01 01 01 00 51 88"},
        {"Rx:000012-01 03 02 00 07 F9 87", "01 03 02 00 07 F9 87"},
        // Times and dates in all places.
        {"[RTU]>Tx > 10:11:12:345 - 01  03  00  00  00  01  84  0A", asked},
        {"02/03/2024 12:01:02.345 [TX] - 01 03 00 00 00 01 84 0B", "01 03 00 00 00 01 84 0B"},
        {"port 3 05.01.2024 07:03:01 Rx: 01 03 02 00 07 F9 86", told_07},
        // What follows the bytes.
        {"Will write to instrument (expecting 7 bytes back): 01 03 00 00 00 01 84 0A (8 bytes)", asked},
        {"Will write to instrument (expecting 7 bytes back): 01 03 00 00 00 01 84 0B (8 bytes)",
         "01 03 00 00 00 01 84 0B"},
        {"Response from instrument: 01 03 02 00 07 F9 86 (7 bytes), roundtrip time: 0.1 ms.", told_07},
        {R"(write to instrument: '\x01\x03\x00\x00\x00\x01\x84\n' (01 03 00 00 00 01 84 0A))", asked},
        {R"(write(3, "\1\3\0\0\0\1\204\n", 8) = 8)", asked},
        {"data: '<Buffer 01 03 02 00 07 f9 86>'", told_07},
        {"01 03 00 00 00 01 (84 0A)", asked},
        {"01h 03h 00h 00h 00h 01h 84h 0Ah", asked},
        {"uint8_t request[8] = {0x01, 0x03, 0x00, 0x00, 0x00, 0x01, 0x84, 0x0A};", asked},
        // Both ways in one line.
        {"req 01 03 00 00 00 01 84 0A rsp 01 03 02 00 07 F9 86", "01 03 00 00 00 01 84 0A 01 03 02 00 07 F9 86"},
    };
    for (row const& each : rows) {
        CAPTURE(each.line);
        CHECK(runs_in(each.line) == each.run);
        CHECK(runs_in(each.line + std::string{"\r\n"}) == each.run);
    }
}

TEST_CASE("defect: D38 decimal dumps are read as that, or as both where nothing tells")
{
    CHECK(runs_in("-> 1-3-0-13-0-1-21-201") == "01 03 00 0D 00 01 15 C9 decimal");
    CHECK(runs_in("[1, 3, 0, 0, 0, 1, 132, 10]") == "01 03 00 00 00 01 84 0A decimal");
    CHECK(runs_in("[1 3 2 0 7 249 134]") == "01 03 02 00 07 F9 86 decimal");
    CHECK(runs_in("001 003 000 000 000 001 132 010") == "01 03 00 00 00 01 84 0A decimal");
    CHECK(runs_in("1-3-0-13-0-1-21-202") == "01 03 00 0D 00 01 15 CA decimal"); // no hexadecimal number, 202
    // Register 13 or 19: nobody knows.
    CHECK(runs_in("1-3-0-13-0-1-21-99") == "01 03 00 13 00 01 21 99 or 01 03 00 0D 00 01 15 63 decimal");
    // 01 has a zero as hexadecimal numbers have it, and a right CRC tells.
    CHECK(runs_in("01 03 00 13 00 01 21 99") == "01 03 00 13 00 01 21 99");
    CHECK(runs_in("1 3 0 13 0 1 75 CF") == "01 03 00 13 00 01 75 CF");
    CHECK(runs_in("2 3 0 18 0 9 5 F8") == "02 03 00 18 00 09 05 F8");
}

TEST_CASE("defect: D38 a line of text is passed over, and what may be bytes is not guessed at")
{
    CHECK(runs_in("Running transaction 1\nSEND: 0x2 0x3 0x0 0x18 0x0 0x9 0x5 0xf8\nResetting frame\n") ==
          "02 03 00 18 00 09 05 F8");
    CHECK(runs_in("> 2024/01/05 10:11:12.345678  length=8 from=0 to=7\n 01 03 00 00 00 01 84 0a\n") == asked);
    CHECK(runs_in("Waiting for a confirmation...\nconnected to COM3 at 19200\n") == "");
    CHECK(runs_in("01 03 zz 00 00 00 01") ==
          "line 1, character 7: 'zz' stands between bytes, and the CRC of neither is right");
    CHECK(runs_in("TX 12G 01 03 00") == "line 1, character 4: '12G' is no hexadecimal number");
    CHECK(runs_in("192.168.1.10") == "line 1, character 1: '192.168.1.10' is no hexadecimal number");
}

TEST_CASE("defect: D38 bytes that stand one on a line are one run")
{
    CHECK(runs_in("0x01\n0x03\n0x00\n0x00\n0x00\n0x01\n0x84\n0x0A\n") == asked);
    CHECK(runs_in("rx 01\nrx 03\nrx 02\nrx 00\nrx 07\nrx F9\nrx 86\n") == told_07);
    CHECK(runs_in("01\n03\n\n02 03\n04") == "01 03/02 03/04");
}

TEST_CASE("defect: D38 a request without a body is told to be too short")
{
    auto const found = decoded(framed({1, 3}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].has_right_crc);
    CHECK_FALSE(found[0].is_good());
    REQUIRE(found[0].readings.size() == 2);
    CHECK(told(found[0].readings[0]) == "request; flaw: 4 bytes, where its fields say at least 8");
    CHECK(value_of(found[0].readings[0], "CRC") == "right");
    CHECK(told(found[0].readings[1]) == "response; flaw: 4 bytes, where its fields say at least 5");
}

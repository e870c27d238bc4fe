// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Places of any device as they are typed, and the values of their registers.
#include "words/place.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

#include "words/place_value.hpp"

namespace {

/// "input:40:f32, input:42:f32"; or the sentence of the refusal.
std::string read(std::string_view word)
{
    tool::places_typed const typed = tool::read_places(word);
    if (typed.refused) {
        CHECK(typed.places.empty());
        CHECK(typed.refused->sentence.starts_with(std::string{word} + ": "));
        return typed.refused->sentence;
    }
    std::string text;
    for (tool::place const& each : typed.places) {
        text += (text.empty() ? "" : ", ") + tool::text_of(each);
    }
    return text;
}

using words = std::vector<std::uint16_t>;

tool::formed_value formed(std::string_view word, words const& held)
{
    tool::places_typed const typed = tool::read_places(word);
    REQUIRE(typed.places.size() == 1);
    CHECK((typed.places[0].is_single_bit() or typed.places[0].form.registers() == held.size()));
    return tool::value_of(typed.places[0], held);
}

std::string text(std::string_view word, words const& held) { return formed(word, held).text; }

double amount(std::string_view word, words const& held) { return std::get<double>(formed(word, held).value); }

} // namespace

TEST_CASE("places that are taken, and what each means")
{
    struct row {
        std::string_view typed, means;
    };
    constexpr row rows[]{
        {"40:u16", "40:u16"},
        {"0x28:hex", "40:hex"},
        {"holding:40", "holding:40"},
        {"h:40-42", "holding:40, holding:41, holding:42"},
        {"INPUT:40", "input:40"},
        {"i:65535", "input:65535"},
        {"coil:3", "coil:3"},
        {"c:0-2", "coil:0, coil:1, coil:2"},
        {"d:7", "discrete:7"},
        {"40.4-7", "40.4-7"},
        {"input:40.3", "input:40.3"},
        {"holding:705.0", "holding:705.0"},
        {"40-43:f32", "40:f32, 42:f32"},
        {"40-43:u64", "40:u64"},
        {"input:40:f32:cdab", "input:40:f32:cdab"},
        {"40:cdab:f32", "40:cdab:f32"},
        {"40:Float32:CDAB:0.1V", "40:float32:cdab:0.1V"},
        {"40:badc", "40:badc"},
        {"40:u64:ghefcdab", "40:u64:ghefcdab"},
        {"40:text20", "40:text20"},
        {"40-59:text20:badc", "40:text20:badc, 50:text20:badc"},
        {"40:0.1", "40:0.1"},
        {"40:0.1degC-50", "40:0.1degC-50"},
        {"40:1-40", "40:1-40"},
        {"40:i32:0.01m3/h", "40:i32:0.01m3/h"},
        {"40:0.1%", "40:0.1%"},
        {"40:1min-1.0", "40:1min-1.0"},
        {"65534:f32", "65534:f32"},
        {"list:40001", "holding:0"},
        {"list:40001:f32", "holding:0:f32"},
        {"list:49999", "holding:9998"},
        {"list:30001-30002", "input:0, input:1"},
        {"list:10001", "discrete:0"},
        {"list:1", "coil:0"},
        {"list:00001", "coil:0"},
        {"list:400001", "holding:0"},
        {"list:465536", "holding:65535"},
    };
    for (row const& each : rows) {
        INFO(each.typed);
        CHECK(tool::is_place_word(each.typed));
        CHECK(read(each.typed) == each.means);
    }
    for (std::string_view const word : {"40", "40-43", "40.3", "RFR", "705.0", "ETA.fault", "DP*", "@monitor", "3-4"}) {
        CHECK(not tool::is_place_word(word));
    }
}

TEST_CASE("places that are refused, and what each refusal says")
{
    struct row {
        std::string_view typed, says;
    };
    constexpr row rows[]{
        {"inputs:40",
         "'inputs' is no space: say holding, input, coil, discrete (h, i, c, d) or list; did you mean input?"},
        {"f32:40", "f32 is a type, which stands behind the address: 40:f32"},
        {":40", "'' is no space"},
        {"h:", "'' is no address, which is a number from 0 to 65535"},
        {"65536:u16", "'65536' is no address"},
        {"h:RFR", "'RFR' is no address"},
        {"h:43-40", "a range begins with its lower address"},
        {"h:40-41.3", "bits are those of one register: 40.4-7"},
        {"40.7-4", "'.7-4' is no bit"},
        {"40.4-16", "'.4-16' is no bit, which has a number from 0 to 15"},
        {"coil:3.1", "a coil is one bit: leave out '.1'"},
        {"coil:3:u16", "a coil has no type, order or scale: leave out ':u16'"},
        {"40.3:u16", "bits have no type, order or scale: leave out ':u16'"},
        {"40:", "nothing stands behind a colon"},
        {"40::f32", "nothing stands behind a colon"},
        {"40:f33", "'f33' is no type (u16 i16 u32"},
        {"40:f33", "did you mean f32?"},
        {"40:cdba:u32", "'cdba' is no order: say abcd, cdab, badc or dcba"},
        {"40:f32:i32", "its type is said twice: f32 and i32"},
        {"40:f32:abcd:cdab", "its order is said twice: abcd and cdab"},
        {"40:0.1:0.2", "its scale is said twice: 0.1 and 0.2"},
        {"40:cdab", "say abcd, or badc where they are swapped; of two registers say a type, such as u32"},
        {"40:text4:cdab", "each of its values is bytes of one register"},
        {"40:u32:ghefcdab", "an order of eight letters is of 64 bits"},
        {"40:u64:ghefcdaa", "'ghefcdaa' is no order"},
        {"40-42:f32", "3 registers are no whole number of values of 2 each; end the range at 43"},
        {"40-40:f32", "1 registers are no whole number of values of 2 each; end the range at 41"},
        {"65535:f32", "a value of 2 registers would end behind 65535"},
        {"40:text", "a text has its number of characters behind it, 1 to 250: text20"},
        {"40:text0", "a text has its number of characters behind it"},
        {"40:text251", "a text has its number of characters behind it"},
        {"40:text8:0.1V", "text8 is no number and has no scale: leave out ':0.1V'"},
        {"40:hex:0.1", "hex is no number and has no scale"},
        {"40:0", "'0': a scale is a number above 0"},
        {"40:1234567890", "at most nine digits"},
        {"40:-1", "'-1': a scale begins with a digit: 0.1V, 1-40"},
        {"40:.1V", "'.1V': a scale begins with a digit"},
        {"40:0.1V-", "behind the unit stands what is added"},
        {"40:0.1V-x", "behind the unit stands what is added"},
        {"40:1min-1", "'1min-1' may mean a power or a difference: say 1/min for a unit, or -1.0 for what is added"},
        {"40:0.1=x", "'=x' is no unit"},
        {"40:0.1{{x", "'{{x' is no unit"},
        {"40:0.1a2345678901234567", "is no unit, which has at most 16 letters"},
        {"40:0.1.2", "'.2' is no unit"},
        {"40:1/3", "'/3' is no unit"},
        {"40:1e3V", "'1e3V': a scale is written without a power of ten: 1000V, 0.001V"},
        {"40:1E-3V", "without a power of ten"},
        {"40:2e+1", "without a power of ten"},
        {"list:0", "'0' is no number of a list: 1 to 9999 are coils"},
        {"list:20001", "'20001' is no number of a list"},
        {"list:40000", "'40000' is no number of a list"},
        {"list:0x9C41", "'0x9C41' is no number of a list"},
        {"list:9999-10001", "both are of one space"},
    };
    for (row const& each : rows) {
        INFO(each.typed);
        CHECK_THAT(read(each.typed), Catch::Matchers::Contains(std::string{each.says}));
    }
}

TEST_CASE("registers are a value by type and order")
{
    // 230.1 as IEEE 754 has it is 43 66 19 9A.
    CHECK(text("40:f32", {0x4366, 0x199A}) == "230.1");
    CHECK(text("40:f32:abcd", {0x4366, 0x199A}) == "230.1");
    CHECK(text("40:f32:cdab", {0x199A, 0x4366}) == "230.1");
    CHECK(text("40:f32:badc", {0x6643, 0x9A19}) == "230.1");
    CHECK(text("40:f32:dcba", {0x9A19, 0x6643}) == "230.1");
    CHECK(amount("40:f32", {0x4366, 0x199A}) == 230.1);
    CHECK(text("40:f64", {0x3FF8, 0, 0, 0}) == "1.5");
    CHECK(text("40:f64:cdab", {0, 0, 0, 0x3FF8}) == "1.5");
    CHECK(text("40:u16", {0xFFFE}) == "65534");
    CHECK(text("40:i16", {0xFFFE}) == "-2");
    CHECK(text("40:badc", {0x0102}) == "513 (0x0201)");
    CHECK(text("40:u32", {0x0001, 0x0002}) == "65538");
    CHECK(text("40:u32:cdab", {0x0001, 0x0002}) == "131073");
    CHECK(text("40:i32", {0xFFFF, 0xFFFE}) == "-2");
    CHECK(text("40:u64", {0x0102, 0x0304, 0x0506, 0x0708}) == "72623859790382856");
    CHECK(text("40:u64:cdab", {0x0708, 0x0506, 0x0304, 0x0102}) == "72623859790382856");
    CHECK(text("40:u64:badc", {0x0201, 0x0403, 0x0605, 0x0807}) == "72623859790382856");
    CHECK(text("40:u64:dcba", {0x0807, 0x0605, 0x0403, 0x0201}) == "72623859790382856");
    CHECK(text("40:u64:cdabghef", {0x0304, 0x0102, 0x0708, 0x0506}) == "72623859790382856");
    CHECK(text("40:u64", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}) == "18446744073709551615");
    CHECK(std::get<std::uint64_t>(formed("40:u64", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}).value) == 0xFFFF'FFFF'FFFF'FFFF);
    CHECK(text("40:i64", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFE}) == "-2");
    CHECK(text("40:bcd16", {0x1234}) == "1234");
    CHECK(text("40:bcd32", {0x1234, 0x5678}) == "12345678");
    CHECK(text("40:bcd32:cdab", {0x5678, 0x1234}) == "12345678");
    CHECK(text("40:text5", {0x4142, 0x4344, 0x4546}) == "ABCDE");
    CHECK(text("40:text6:badc", {0x4241, 0x2043, 0x0000}) == "ABC");
    CHECK(text("40:bits", {0x0013}) == "0x0013 (0, 1, 4)");
    CHECK(text("40:bits", {0}) == "0x0000 (none)");
    CHECK(text("40:hex", {0x00AF}) == "0x00AF");
    CHECK(text("40.4-7", {0x0A5F}) == "5");
    CHECK(text("40.0-15", {0xFFFF}) == "65535");
    CHECK(text("h:40.15", {0x8000}) == "1");
    CHECK(text("coil:40", {1}) == "1");
}

TEST_CASE("what is no number has no value")
{
    for (words const& held : {words{0x7FC0, 0}, words{0x7F80, 0}, words{0xFF80, 0}}) {
        CHECK(std::holds_alternative<std::monostate>(formed("40:f32", held).value));
    }
    CHECK(text("40:f32:0.1V", {0x7FC0, 0}) == "not a number");
    CHECK(text("40:f32", {0xFF80, 0}) == "below any number");
    CHECK(text("40:bcd16", {0x12A4}) == "0x12A4, which is no BCD");
    CHECK(text("40:bcd32:cdab", {0x5678, 0x12A4}) == "0x12A45678, which is no BCD");
    CHECK(std::holds_alternative<std::monostate>(formed("40:bcd16", {0xF000}).value));
}

TEST_CASE("a scale is exact, with a unit and what is added")
{
    CHECK(text("40:0.1V", {2301}) == "230.1 V");
    CHECK(amount("40:0.1V", {2301}) == 230.1);
    CHECK(text("40:i16:0.01", {0xFFFF}) == "-0.01");
    CHECK(text("40:0.1degC-50", {0}) == "-50.0 degC");
    CHECK(text("40:0.1degC-50", {723}) == "22.3 degC");
    CHECK(text("40:1+0.25", {3}) == "3.25");
    CHECK(text("40:10W", {12}) == "120 W");
    CHECK(text("40:u64:0.001kWh", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}) == "18446744073709551.615 kWh");
    CHECK(text("40:u64:0.00000001+0.00000001", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}) == "184467440737.09551616");
    CHECK(text("40:bcd16:0.1", {0x0123}) == "12.3");
    CHECK(text("40:f32:0.001kV", {0x4366, 0x199A}) == "0.2301 kV");
    CHECK(text("40:f64:0.1V", {0x4008, 0, 0, 0}) == "0.3 V");
}

TEST_CASE("a value that is typed is the registers that show it")
{
    struct row {
        std::string_view where, typed, shown;
        words held;
    };
    row const rows[]{
        {"40:f32", "230.1", "230.1", {0x4366, 0x199A}},
        {"40:f32:cdab", "230.1", "230.1", {0x199A, 0x4366}},
        {"40:f32:badc", "+230.1", "230.1", {0x6643, 0x9A19}},
        {"40:f32:dcba", "230.1", "230.1", {0x9A19, 0x6643}},
        {"40:f32:0.001kV", "0.2301kV", "0.2301 kV", {0x4366, 0x199A}},
        {"40:f32", "0x4366199A", "230.1", {0x4366, 0x199A}},
        {"40:f32", "2.301e2", "230.1", {0x4366, 0x199A}},
        {"40:f32:0.001kV", "2301E-4 kV", "0.2301 kV", {0x4366, 0x199A}},
        {"40:f32", "16777216", "16777216", {0x4B80, 0}},
        {"40:f32", "-0.10", "-0.1", {0xBDCC, 0xCCCD}},
        {"40:f32", "0.100000001490116", "0.1", {0x3DCC, 0xCCCD}},
        {"40:f32", "1e-45", "1e-45", {0, 1}},
        {"40:f32", "3.4028235e38", "3.4028235e+38", {0x7F7F, 0xFFFF}},
        {"40:f32", "-3.40282347e38", "-3.4028235e+38", {0xFF7F, 0xFFFF}},
        {"40:f64", "0.1", "0.1", {0x3FB9, 0x9999, 0x9999, 0x999A}},
        {"40:f64", "1.7976931348623157e308", "1.7976931348623157e+308", {0x7FEF, 0xFFFF, 0xFFFF, 0xFFFF}},
        {"40:f64", "0", "0", {0, 0, 0, 0}},
        {"40:f64", "-1.5", "-1.5", {0xBFF8, 0, 0, 0}},
        {"40:f64:0.1", "0.3", "0.3", {0x4008, 0, 0, 0}},
        {"40:f64:0.0002V", "-903.56V", "-903.56 V", {0xC151, 0x3BEA, 0, 0}},
        {"40:f64:0.0001+0.5", "530.06", "530.06", {0x4154, 0x337C, 0, 0}},
        {"40:f64:cdab:0.0025kWh", "-262.65", "-262.65 kWh", {0, 0, 0xA640, 0xC0F9}},
        {"40:u16", "65535", "65535", {0xFFFF}},
        {"40:i16", "-2", "-2", {0xFFFE}},
        {"40:u32:cdab", "131073", "131073", {0x0001, 0x0002}},
        {"40:u64", "18446744073709551615", "18446744073709551615", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}},
        {"40:i64", "-2", "-2", {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFE}},
        {"40:u64:dcba", "72623859790382856", "72623859790382856", {0x0807, 0x0605, 0x0403, 0x0201}},
        {"40:bcd16", "1234", "1234", {0x1234}},
        {"40:bcd32:cdab", "12345678", "12345678", {0x5678, 0x1234}},
        {"40:0.1V", "230.1 V", "230.1 V", {2301}},
        {"40:0.1V", "#2301", "230.1 V", {2301}},
        {"40:0.1V", "0x08FD", "230.1 V", {2301}},
        {"40:0.1degC-50", "-50", "-50.0 degC", {0}},
        {"40:0.1degC-50", "22.3", "22.3 degC", {723}},
        {"40:10W", "120", "120 W", {12}},
        {"40:text5", "ABC", "ABC", {0x4142, 0x4300, 0x0000}},
        {"40:text3:badc", "ABC", "ABC", {0x4241, 0x0043}},
        {"40:hex", "0xAF", "0x00AF", {0x00AF}},
        {"40:bits", "19", "0x0013 (0, 1, 4)", {0x0013}},
        {"coil:3", "on", "1", {1}},
        {"coil:3", "OFF", "0", {0}},
    };
    for (row const& each : rows) {
        INFO(each.where << "=" << each.typed);
        tool::place const where = tool::read_places(each.where).places.at(0);
        tool::words_typed const typed = tool::words_for(where, each.typed);
        CHECK(typed.wrong == "");
        CHECK(typed.words == each.held);
        CHECK(tool::value_of(where, typed.words).text == each.shown);
    }
}

TEST_CASE("a value that is none is refused, with what would be one")
{
    struct row {
        std::string_view where, typed, says;
    };
    constexpr row rows[]{
        {"40:u16", "65536", "it takes 0 to 65535"},
        {"40:u16", "-1", "it takes 0 to 65535"},
        {"40:0.1V", "-1V", "it takes 0.0 V to 6553.5 V; of a number that may be below 0 say the type: 40:0.1V:i16"},
        {"40:0.1V", "#-1", "say the type: 40:0.1V:i16"},
        {"holding:40", "-1", "say the type: holding:40:i16"},
        {"40:i16", "-32769", "it takes -32768 to 32767"},
        {"40:u16:0.1V", "6553.6", "it takes 0.0 V to 6553.5 V"},
        {"40:i32", "2147483648", "it takes -2147483648 to 2147483647"},
        {"40:u64", "18446744073709551616", "it takes 0 to 18446744073709551615"},
        {"40:u64", "184467440737095516160", "more than 20 digits"},
        {"40:bcd16", "10000", "it takes 0 to 9999"},
        {"40:bcd16", "0x00AF", "these registers are no number of its type"},
        {"40:0.1V", "230.15", "no whole number of its steps: say 230.1 V or 230.2 V"},
        {"40:i16:0.1V", "-0.05", "say -0.1 V or 0.0 V"},
        {"40:u16", "1.5", "say 1 or 2"},
        {"40:0.1V", "230,1V", "a number is written with a point"},
        {"40:0.1V", "230.1kV", "it is in V, not in kV"},
        {"40:u16", "5V", "leave it out, or say the scale"},
        {"40:u16", "", "it takes a number"},
        {"40:u16", "nan", "it takes a number"},
        {"40:f32", "nan", "it takes a number"},
        {"40:f32", "inf", "it takes a number"},
        {"40:u16", "1e5", "'e5' is none"},
        {"40:u16", "FF", "say 0xFF if it is hexadecimal"},
        {"40:u16", "1F", "say 0x1F if it is hexadecimal"},
        {"40:0.1V", "1F", "it is in V, not in F; say 0x1F if it is hexadecimal"},
        {"40:f32", "1e", "'e' is none"},
        {"40:f32", "3.40282357e38", "more than its type holds"},
        {"40:f32", "1e39", "more than its type holds"},
        {"40:f64", "1e309", "more than its type holds"},
        {"40:f64", "1e99999999999", "more than its type holds"},
        {"40:f64", "1e-99999999999", "its type has no such number: the nearest is 0"},
        {"40:f32", "16777217", "its type has no such number: the nearest is 16777216"},
        {"40:f32", "230.1000001", "the nearest is 230.1"},
        {"40:f32", "1e-46", "the nearest is 0"},
        {"40:f32:0.1V", "1677721.7", "the nearest is 1677722 V"},
        {"40:f64", "9007199254740993", "the nearest is 9007199254740992"},
        {"40:f32", "400000000000000000000000000000000000000", "more than its type holds"},
        {"40:f32:0.000001", "99999999999999999999", "its type has no such number"},
        {"40:f32", "0.0000000000000000000000001", ""},
        {"40:f32", "0x7FC00000", "these registers are no number of its type"},
        {"40:f32", "#5", "has no count"},
        {"40:f32:cdab", "0x199A4366", "its bytes come as cdab, so 0x may mean two numbers"},
        {"40:u16", "0x10000", "at most 4 hexadecimal digits"},
        {"40:u16", "0x", "at most 4 hexadecimal digits"},
        {"40:u16", "#1.5", "behind # stands a whole number"},
        {"40:u16", "#70000", "it takes 0 to 65535"},
        {"40:text3", "ABCD", "a text of at most 3 bytes"},
        {"40:text3", "A\n", "without control characters"},
        {"40:text3", "A\x7F", "without control characters"},
        {"40:text3", "A\xC2\x9B", "without control characters"},
        {"40:text3", "A\x9B", "in UTF-8"},
        {"coil:3", "2", "a coil is on or off"},
    };
    for (row const& each : rows) {
        INFO(each.where << "=" << each.typed);
        tool::words_typed const typed = tool::words_for(tool::read_places(each.where).places.at(0), each.typed);
        CHECK(typed.words.empty() == not each.says.empty());
        CHECK_THAT(typed.wrong, Catch::Matchers::Contains(std::string{each.says}));
    }
}

TEST_CASE("a number of five digits may be from a list")
{
    CHECK(tool::list_hint(40'001) == "list:40001 is holding:0");
    CHECK(tool::list_hint(30'010) == "list:30010 is input:9");
    CHECK(tool::list_hint(10'001) == "list:10001 is discrete:0");
    for (std::uint16_t const none : words{0, 1, 9'999, 10'000, 20'001, 40'000, 50'001, 65'535}) {
        CHECK(tool::list_hint(none).empty());
    }
}

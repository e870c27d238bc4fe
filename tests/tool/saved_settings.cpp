// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Files of parameters: what is written is read again, what people make of it in a spreadsheet is understood, and what is
// wrong is refused with its place.
#include "backup/saved_settings.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "support/random.hpp"

#include "backup/backup_text.hpp"

namespace {

using tool::settings_reading;

settings_reading read_json(std::string_view text, std::string_view drive = {})
{
    return tool::settings_in(tool::read_json_rows(text), drive);
}

settings_reading read_csv(std::string_view text, std::string_view drive = "atv320")
{
    return tool::settings_in(tool::read_csv_rows(text), drive);
}

std::string json_of(std::string const& rows)
{
    return "{\"format\":\"rtuwire backup 1\",\n\"drive\":\"atv320\",\n\"parameters\":[\n" + rows + "\n]}";
}

/// Where something is wrong, as "3:7"; with the sentence where it lacks what it should say.
std::string fault_of(settings_reading const& read, std::string_view says)
{
    if (not read.fault) {
        return "nothing";
    }
    std::string const place = std::to_string(read.fault->place.line) + ":" + std::to_string(read.fault->place.column);
    return read.fault->sentence.find(says) != std::string::npos ? place : place + " " + read.fault->sentence;
}

std::uint16_t word(settings_reading const& read, std::string_view code)
{
    INFO(code << ' ' << (read.fault ? read.fault->sentence : ""));
    REQUIRE_FALSE(read.fault);
    auto const found = read.settings.word_of(code);
    REQUIRE(found);
    return *found;
}

/// Every parameter of a drive, with words that differ, some of them refused.
tool::saved_settings whole_drive(std::string_view name)
{
    tool::saved_settings all;
    all.drive = tool::catalog_named(name);
    all.head = {
        {"format", "rtuwire backup 1"}, {"drive", std::string{name}}, {"vendor", "some, \"quoted\" and \x01 odd"}};
    std::uint16_t number = 1;
    for (tool::register_entry const& each : all.drive->registers) {
        number = static_cast<std::uint16_t>(number * 31 + 7);
        bool const is_step = each.code == "INR";
        if (number % 17 == 0 and not is_step) {
            all.parameters.push_back({&each, {}, "illegal data address (exception 0x02)", {}});
        } else {
            all.parameters.push_back({&each, is_step ? std::uint16_t{1} : number, {}, {}});
        }
    }
    return all;
}

} // namespace

TEST_CASE("what is written is read again, of each drive, in both forms")
{
    for (tool::drive_catalog const* const drive : tool::all_catalogs()) {
        INFO(drive->name);
        tool::saved_settings const all = whole_drive(drive->name);
        for (settings_reading const& read :
             {read_json(tool::json_text_of(tool::rows_of(all))), read_csv(tool::csv_text_of(tool::rows_of(all)), {})}) {
            INFO((read.fault ? read.fault->sentence : ""));
            REQUIRE_FALSE(read.fault);
            CHECK(read.settings.drive == drive);
            REQUIRE(read.settings.parameters.size() == all.parameters.size());
            for (std::size_t i = 0; i < all.parameters.size(); ++i) {
                INFO(all.parameters[i].entry->code);
                CHECK(read.settings.parameters[i].entry == all.parameters[i].entry);
                CHECK(read.settings.parameters[i].word == all.parameters[i].word);
                CHECK(read.settings.parameters[i].error == all.parameters[i].error);
            }
        }
    }
}

TEST_CASE("a register that an earlier version knew is left out and named, a wrong name is refused")
{
    auto const read = read_json(json_of(R"({"register":"AI1I","address":5222,"raw":7},
{"register":"ACC","address":9001,"raw":30},
{"register":"INR","address":9020,"raw":1})"));
    REQUIRE_FALSE(read.fault);
    CHECK((read.settings.parameters.size() == 2 and word(read, "ACC") == 30));
    REQUIRE(read.left_out.size() == 1);
    CHECK(read.left_out[0].place.line == 4);
    CHECK(read.left_out[0].sentence == "AI1I, register 5222, is none that is known of an atv320: it is left out");
    for (auto const* const wrong :
         {R"({"register":"ACCC","address":9001,"raw":30})", R"({"register":"ACCC","raw":30})",
          R"({"register":"ACC","address":5222,"raw":30})", R"({"register":"ACCC","address":"x","raw":30})"}) {
        INFO(wrong);
        auto const refused = read_json(json_of(wrong));
        CHECK(refused.fault.has_value());
        CHECK(refused.left_out.empty());
    }
}

TEST_CASE("a value without its raw count is read by its step, its names and its bits")
{
    auto const read = read_json(json_of(R"({"register":"INR","value":"001"},
{"register":"ACC","value":12.5},
{"register":"HSP","value":"45,5","unit":"Hz"},
{"register":"LSP","value":"10 Hz"},
{"register":"CHCF","value":"SEP: separate"},
{"register":"ETA","value":"0x0237"},
{"register":"LFRD","value":-50})"));
    // INR 0 makes a step of ACC 0.01 s; it stands there by the name that the display has for it.
    CHECK((word(read, "ACC") == 1'250 and word(read, "INR") == 0));
    CHECK((word(read, "HSP") == 455 and word(read, "LSP") == 100 and word(read, "CHCF") == 2));
    CHECK((word(read, "ETA") == 0x0237 and word(read, "LFRD") == 0xFFCE));
    CHECK(word(read_json(json_of(R"({"register":"hsp","raw":"0x01F4"})")), "HSP") == 500);
}

TEST_CASE("a table that a spreadsheet saved is understood")
{
    std::string const text = "\xEF\xBB\xBF"
                             "register;value;unit;name\r\n"
                             "HSP;45,5;Hz;\"High; \"\"speed\"\"\"\r\n"
                             "\r\n"
                             "CHCF;SEP;;\r\n"
                             "SP2; 12,0 ;Hz;";
    auto const read = read_csv(text);
    CHECK((word(read, "HSP") == 455 and word(read, "CHCF") == 2 and word(read, "SP2") == 120));
    CHECK(word(read_csv("register\traw\nHSP\t455"), "HSP") == 455);
    CHECK(word(read_csv("raw,register\n-50,LFRD\n"), "LFRD") == 0xFFCE);
    CHECK(word(read_csv("group,register,value\nbackup,drive,atv310\n,701,7\n", {}), "ADD") == 7);
}

TEST_CASE("what is wrong in a table is refused with line and column")
{
    CHECK(fault_of(read_csv(""), "nothing in it") == "0:0");
    CHECK(fault_of(read_csv("register,raw\n"), "no parameters") == "0:0");
    CHECK(fault_of(read_csv("register,raww\nHSP,1"), "'raww'") == "1:10");
    CHECK(fault_of(read_csv("raw,value\n1,2"), "'register'") == "1:1");
    CHECK(fault_of(read_csv("register,raw,raw\nHSP,1,2"), "second time") == "1:14");
    CHECK(fault_of(read_csv("register,raw\nHSP,1\nHSQX,2"), "'HSQX'") == "3:1");
    CHECK(fault_of(read_csv("register,raw\nHSP,1\nLSP,2\nHSP,3"), "second time") == "4:1");
    CHECK(fault_of(read_csv("register,raw\nHSP,1,2"), "3 fields") == "2:1");
    CHECK(fault_of(read_csv("register,raw\nHSP"), "1 fields") == "2:1");
    CHECK(fault_of(read_csv("register,raw,value\nHSP,500,40"), "50.0 Hz") == "2:9");
    CHECK(fault_of(read_csv("register,raw,address\nHSP,500,3105"), "3104") == "2:9");
    CHECK(fault_of(read_csv("register,value\nHSP,50.05"), "steps of 0.1 Hz") == "2:5");
    CHECK(fault_of(read_csv("register,value\nHSP,5 s"), "is not in Hz") == "2:5");
    CHECK(fault_of(read_csv("register,value\nCHCF,NOPE"), "none of its values") == "2:6");
    CHECK(fault_of(read_csv("register,value\nACC,1.5"), "INR") == "2:5");
    CHECK(fault_of(read_csv("register,raw\nHSP,\"1\nLSP,2"), "quote") == "2:5");
    CHECK(fault_of(read_csv("register,raw\nHSP,5\"0\"\n"), "quote") == "2:6");
    CHECK(fault_of(read_csv("register,raw\n\"HSP\",\n"), "no value") == "2:1");
    for (std::string_view const wrong :
         {"1e3", "NaN", "inf", "5.0", "70000", "-40000", "0x1F4G", "5O0", "1 000", "--5", "+"}) {
        INFO(wrong);
        CHECK(fault_of(read_csv("register,raw\nHSP," + std::string{wrong}), "raw count") == "2:5");
        bool const is_number = wrong == "5.0";
        CHECK((fault_of(read_csv("register,value\nHSP," + std::string{wrong}), "") == "2:5") == not is_number);
    }
    CHECK(fault_of(read_csv("register,value\nHSP,\"1.000,5\""), "HSP") == "2:5"); // neither thousand nor one
    CHECK(fault_of(read_csv("register,raw\nHSP,1", {}), "--drive") == "0:0");
    CHECK(fault_of(read_csv("register,raw\nHSP,1", "atv99"), "atv99") == "0:0");
}

TEST_CASE("what is wrong in JSON is refused with line and column")
{
    CHECK(fault_of(read_json(""), "JSON") == "1:1");
    CHECK(fault_of(read_json("["), "list") == "1:1");
    CHECK(fault_of(read_json("{\"drive\":\"atv320\""), "JSON") == "1:17");
    CHECK(fault_of(read_json("{\"drive\":\"atv320\",\n\"drive\":\"atv12\"}"), "second time") == "2:7");
    CHECK(fault_of(read_json("{\"drive\":\"atv99\",\"parameters\":[]}"), "atv99") == "1:16");
    CHECK(fault_of(read_json("{\"format\":\"other\",\"drive\":\"atv320\"}"), "no format") == "1:17");
    CHECK(fault_of(read_json(json_of("")), "no parameters") == "0:0");
    CHECK(fault_of(read_json(json_of("5")), "object") == "4:2");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":true}")), "true or false") == "4:28");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":[1]}")), "list") == "4:25");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raww\":1}")), "'raww'") == "4:24");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":1,\"raw\":2}")), "second time") == "4:31");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":NaN}")), "JSON").starts_with("4:"));
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":1e3}")), "raw count").starts_with("4:"));
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"value\":1e2}")), "digits").starts_with("4:"));
    CHECK(fault_of(read_json(json_of("{\"raw\":1}")), "no 'register'") == "4:1");
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":500,\"value\":45}")), "50.0 Hz").starts_with("4:"));
    CHECK(fault_of(read_json(json_of("{\"register\":\"HSP\",\"raw\":1,\"error\":\"x\"}")), "both").starts_with("4:"));
    CHECK(fault_of(read_json(std::string(100'000, '[')), "list") == "1:1");
    CHECK(fault_of(read_json(json_of(std::string(100'000, '{'))), "JSON").starts_with("4:"));
    CHECK(fault_of(read_json(std::string_view{"\0\0\0\0", 4}), "JSON") == "1:1");
}

TEST_CASE("a file that was damaged is read or refused, never believed where it contradicts itself")
{
    tool::saved_settings const all = whole_drive("atv310");
    std::string const texts[]{tool::json_text_of(tool::rows_of(all)), tool::csv_text_of(tool::rows_of(all))};
    rtuwire::test::random random{2026};
    std::size_t refused = 0;
    for (int i = 0; i < 2'000; ++i) {
        std::string text = texts[i % 2];
        for (unsigned changes = 1 + random.below(3); changes > 0; --changes) {
            std::size_t const at = random.below(static_cast<unsigned>(text.size()));
            switch (random.below(4)) {
            case 0: text[at] = static_cast<char>(random.below(256)); break;
            case 1: text.erase(at, 1 + random.below(20)); break;
            case 2: text.insert(at, 1, "\",;{}[]\n0159-.eN"[random.below(17)]); break;
            default: text.insert(at, text.substr(random.below(static_cast<unsigned>(text.size())), 30)); break;
            }
        }
        settings_reading const read = i % 2 == 0 ? read_json(text) : tool::settings_in(tool::read_csv_rows(text), {});
        if (read.fault) {
            ++refused;
            CHECK_FALSE(read.fault->sentence.empty());
            bool const is_of_the_whole = read.fault->sentence.find("drive") != std::string::npos or
                                         read.fault->sentence.find("nothing") != std::string::npos;
            CHECK((read.fault->place.line > 0 or is_of_the_whole));
        }
    }
    CHECK(refused > 1'000);
}

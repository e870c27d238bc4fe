// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers as they are typed on the tool's command line.
#include "words/register_words.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

namespace {

using words = std::vector<std::string_view>;

tool::drive_catalog const* atv320() { return tool::catalog_named("atv320"); }

/// What was selected, as one text: "3201 ETA, 3201.3 ETA, 3210"; or the kind of the refusal.
std::string selected(words const& typed, tool::drive_catalog const* drive = atv320())
{
    tool::register_selection const found = tool::select_registers(typed, drive);
    if (found.refused) {
        CHECK(found.registers.empty());
        return found.refused->kind;
    }
    std::string text;
    for (tool::chosen_register const& each : found.registers) {
        text += (text.empty() ? "" : ", ") + tool::text_of(each.where);
        text += each.entry != nullptr ? " " + std::string{each.entry->code} : "";
    }
    return text;
}

tool::refusal refused(std::string_view typed)
{
    auto const found = tool::select_registers(words{typed}, atv320());
    REQUIRE(found.refused);
    CHECK(found.refused->sentence.find(typed) != std::string::npos);
    return *found.refused;
}

} // namespace

TEST_CASE("registers are named by mnemonics, numbers, ranges, patterns, groups and bits")
{
    CHECK(selected({"RFR"}) == "3202 RFR");
    CHECK(selected({"rfr", "Lcr"}) == "3202 RFR, 3204 LCR");
    CHECK(selected({"3202", "0x0C84", "0XC80", "12345"}) == "3202 RFR, 3204 LCR, 3200, 12345");
    CHECK(selected({"3201-3204"}) == "3201 ETA, 3202 RFR, 3203 FRH, 3204 LCR");
    CHECK(selected({"0x0C81-3202"}) == "3201 ETA, 3202 RFR");
    CHECK(selected({"65535"}) == "65535");
    CHECK(selected({"dp?"}).starts_with("7200 DP0, 7201 DP1, "));
    CHECK(selected({"*D"}).find("8602 LFRD") != std::string::npos);
    CHECK(selected({"ETA.fault", "eta.3", "ETA.switch-on-disabled", "3201.0"}) == "3201.3 ETA, 3201.6 ETA, 3201.0 ETA");
    CHECK(selected({"@thermal"}) == "3209 THD, 9630 THR");
    CHECK(selected({"group:thermal"}) == "3209 THD, 9630 THR");
    CHECK(selected({"GROUP:Thermal"}) == "3209 THD, 9630 THR");
    CHECK(refused("group:motor_contrl").nearest == "group:motor_control");
    CHECK(selected({"group:monitor"}, nullptr) == "no_drive");
    CHECK(selected({"@Ramps"}) == "9020 INR, 9001 ACC, 9002 DEC, 9012 AC2, 9013 DE2");
}

TEST_CASE("a group of the menu is a group, and each drive has its own")
{
    CHECK(selected({"@functions_ramp"}).find("9012 AC2") != std::string::npos);
    CHECK(selected({"@Motor_Control"}).find("9601 UNS") != std::string::npos);
    CHECK(selected({"@functions_traverse"}, tool::catalog_named("atv12")) == "unknown_group");
    CHECK(selected({"@command"}, tool::catalog_named("atv28")) == "400 CMD, 402 CMI");
    tool::refusal const wrong = refused("@motor_contrl");
    CHECK(wrong.nearest == "@motor_control");
    CHECK(wrong.sentence.find("functions_brake") != std::string::npos);
}

TEST_CASE("an ATV310 takes the numbers of its menu; another drive has addresses and bits there")
{
    tool::drive_catalog const* const old = tool::catalog_named("atv310");
    CHECK(selected({"701", "705.0", "512.2"}, old) == "6001 ADD, 12701 NMA1, 3104 HSP");
    CHECK(selected({"705.4", "0x01F4", "702.1"}, old) == "705.4, 500, 702.1");
    CHECK(selected({"705.4"}, tool::catalog_named("atv310_2026")) == "12705 NMA5");
    CHECK(selected({"701", "705.0"}) == "701, 705.0");
}

TEST_CASE("a number of some drive's menu is known as one, whoever is asked")
{
    CHECK(tool::first_menu_number(words{"3202", "100-800", "611"}) == "611");
    CHECK(tool::first_menu_number(words{"RFR,705.7", "611"}) == "705.7");
    CHECK(tool::first_menu_number(words{"3201.3", "0x0263", "705", "705.9", "RFR", ""}).empty());
    CHECK(tool::ambiguity_of("611").find("an address: say --drive, or 0x0263") != std::string::npos);
    CHECK(tool::ambiguity_of("705.0").find("a bit: say --drive, or 0x02C1.0") != std::string::npos);
    CHECK(selected({"0x0263", "0x02C1.0"}, tool::catalog_named("atv310")) == "611, 705.0");
}

TEST_CASE("registers come in the order in which they were typed, each once")
{
    CHECK(selected({"LCR", "3202", "RFR", "ETA,LCR,FRH"}) == "3204 LCR, 3202 RFR, 3201 ETA, 3203 FRH");
    CHECK(selected({"ETA.3", "ETA"}) == "3201.3 ETA, 3201 ETA");
}

TEST_CASE("without a drive there are only numbers")
{
    CHECK(selected({"3202", "10-12", "7.3"}, nullptr) == "3202, 10, 11, 12, 7.3");
    CHECK(selected({"RFR"}, nullptr) == "no_drive");
    CHECK(selected({"@monitor"}, nullptr) == "no_drive");
    CHECK(selected({"7.fault"}, nullptr) == "unknown_bit");
    for (std::string_view const wrong : {"32O1.3", "0x1g.2", "4a.3", "7-9.3", "99999.1", "3."}) {
        INFO(wrong);
        CHECK(selected({wrong}, nullptr) == (wrong == "3." ? "unknown_bit" : "wrong_address"));
    }
}

TEST_CASE("a place needs no drive, and a drive's words mean what they meant")
{
    CHECK(selected({"input:40:f32,coil:3", "40:u32", "40.4-7"}, nullptr) == "input:40:f32, coil:3, 40:u32, 40.4-7");
    CHECK(selected({"holding:3202", "RFR", "3202"}) == "holding:3202 RFR");
    CHECK(selected({"RFR", "3202:i16", "input:3202"}) == "3202 RFR, 3202:i16 RFR, input:3202");
    CHECK(selected({"holding:705.0", "705.0"}, tool::catalog_named("atv310")) == "holding:705.0, 12701 NMA1");
    CHECK(tool::first_menu_number(words{"holding:705.0", "611:u16", "40.4-7"}).empty());
    CHECK(selected({"RFR:f32"}) == "wrong_place");
    CHECK(selected({"RFR", "40:f33"}, nullptr) == "no_drive");
}

TEST_CASE("each group has registers of each drive, or says that it has none")
{
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        for (tool::register_group const& group : tool::register_groups()) {
            INFO(drive->name << " @" << group.name);
            std::string const word = "@" + std::string{group.name};
            std::string const found = selected({word}, drive);
            bool const is_missing = found == "unknown_group";
            CHECK((not found.empty() and (not is_missing or group.name != "monitor")));
        }
    }
}

TEST_CASE("a wrong word is named with the nearest right one")
{
    CHECK(refused("RFQ").nearest.size() == 3);
    CHECK(refused("ETAA").nearest == "ETA");
    CHECK(refused("CHFC").nearest == "CHCF"); // two letters changed places
    CHECK(refused("XYZWQ").nearest.empty());
    CHECK(refused("@moniter").nearest == "@monitor");
    CHECK(refused("ETA.falt").nearest == "ETA.fault");
    CHECK(refused("ETA.16").kind == "unknown_bit");
    CHECK(refused("RFR.fault").kind == "unknown_bit");
    CHECK(refused("XX*").kind == "unknown_register");
    CHECK(selected({"RFR", "nonsense", "alsowrong"}) == "unknown_register");
    for (std::string_view const wrong : {"65536", "3205-3201", "3201-", "-3201x", "12x", "0x", "0x10000", "1--2", ""}) {
        INFO(wrong);
        CHECK(tool::select_registers(words{wrong}, atv320()).refused);
    }
    CHECK(selected({"RFR,,LCR"}) == "wrong_address");
}

TEST_CASE("a search finds mnemonics, names, values and bits")
{
    auto const codes = [](std::string_view word) {
        std::string text;
        for (tool::register_entry const* each : tool::search_registers(*atv320(), word)) {
            text += std::string{each->code} + " ";
        }
        return text;
    };
    CHECK(codes("acceleration ramp").starts_with("ACC "));
    CHECK(codes("ramp").find("ACC ") < codes("ramp").find("LFL3 ")); // one of whose values is a ramp stop
    CHECK(codes("overcurrent").find("LFT") != std::string::npos);
    CHECK(codes("switch on disabled").find("ETA") != std::string::npos);
    CHECK(codes("no such thing").empty());
    CHECK(tool::search_registers(*tool::catalog_named("atv310"), "512.2").front()->code == "HSP");
}

TEST_CASE("patterns and distances")
{
    CHECK((tool::matches("a*b*c", "AxxBxbC") and not tool::matches("a*b*c", "AxxBxbCd")));
    CHECK((tool::matches("*", "") and tool::matches("**", "x") and not tool::matches("?", "")));
    CHECK((tool::matches("D?", "dp") and not tool::matches("D?", "dp1") and not tool::matches("", "a")));
    CHECK(tool::edit_distance("kitten", "sitting") == 3);
    CHECK(tool::edit_distance("", "abc") == 3);
    CHECK(tool::edit_distance("CHFC", "chcf") == 1);
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values as they are typed on the tool's command line: what is written, and what is refused before a frame leaves.
#include "words/value_words.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/one_in.hpp"

#include "catalog/value_text.hpp"
#include "words/time_words.hpp"

namespace {

using registers = std::map<std::string_view, std::uint16_t>;

tool::value_to_write checked(std::string_view drive, std::string_view word, registers const& known = {})
{
    tool::drive_catalog const* const catalog = drive.empty() ? nullptr : tool::catalog_named(drive);
    REQUIRE((drive.empty() or catalog != nullptr));
    return tool::check_value(word, catalog, [&](std::string_view code) {
        auto const found = known.find(code);
        return found != known.end() ? std::optional{found->second} : std::nullopt;
    });
}

/// What comes of a word: "13 = 1.3 s", "needs INR", or the kind of its refusal.
std::string outcome(std::string_view drive, std::string_view word, registers const& known = {})
{
    tool::value_to_write const found = checked(drive, word, known);
    if (found.refused) {
        CHECK(found.refused->sentence.starts_with(word.substr(0, word.find('='))));
        return found.refused->kind;
    }
    if (not found.needed.empty()) {
        std::string text = "needs";
        for (tool::register_entry const* each : found.needed) {
            text += " " + std::string{each->code};
        }
        return text;
    }
    CHECK(found.is_ready());
    return std::to_string(found.words.at(0)) + " = " + found.text;
}

/// The sentence of a refusal.
std::string sentence(std::string_view drive, std::string_view word, registers const& known = {})
{
    tool::value_to_write const found = checked(drive, word, known);
    REQUIRE(found.refused);
    return found.refused->sentence;
}

bool holds(std::string const& text, std::string_view part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a time has one sign, and is rounded to a tenth of a millisecond")
{
    using tool::ms_text;
    using us = std::chrono::microseconds;
    CHECK(ms_text(us{1'540}) == "1.5 ms");
    CHECK(ms_text(us{1'550}) == "1.6 ms");
    CHECK(ms_text(us{-1'540}) == "-1.5 ms");
    CHECK(ms_text(us{-300}) == "-0.3 ms");
    CHECK(ms_text(us{-49}) == "0.0 ms");
    CHECK(ms_text(us{0}) == "0.0 ms");
}

TEST_CASE("amounts are typed with their unit, prefixed or not, or with none")
{
    CHECK(outcome("atv12", "ACC=1.3s") == "13 = 1.3 s");
    CHECK(outcome("atv12", "acc=1300ms") == "13 = 1.3 s");
    CHECK(outcome("atv12", "ACC=1.3 s") == "13 = 1.3 s");
    CHECK(outcome("atv12", "ACC=1min") == "600 = 60.0 s");
    CHECK(outcome("atv12", "9001=1.300s") == "13 = 1.3 s");
    CHECK(outcome("atv12", "9001=1.300") == "unit_missing");
    CHECK(holds(sentence("atv12", "9001=25"), "9001 is ACC"));
    CHECK(holds(sentence("atv12", "9001=25"), "9001=25s, or a raw count, 9001=#25 or 9001=0x0019"));
    CHECK(outcome("atv12", "9001=#25") == "25 = 2.5 s");
    CHECK(outcome("atv12", "8401=2") == "2 = SEP");
    CHECK(outcome("atv12", "HSP=0.06kHz") == "600 = 60.0 Hz");
    CHECK(outcome("atv12", "3104=60Hz") == "600 = 60.0 Hz");
    CHECK(outcome("atv12", "HSP=60") == "600 = 60.0 Hz");
    CHECK(outcome("atv12", "ITH=1500mA") == "15 = 1.5 A");
    CHECK(outcome("atv12", "SFR=12kHz") == "120 = 12000 Hz");
    CHECK(outcome("atv12", "LFRD=-1500rpm") == "64036 = -1500 rpm");
    CHECK(outcome("atv12", "LFR=-50") == "65036 = -50.0 Hz");
    CHECK(outcome("atv12", "COS=0.95") == "95 = 0.95");
    CHECK(outcome("atv12", "PISP=50%") == "500 = 50.0 %");
    CHECK(outcome("atv12", "NPR=+7") == "7 = 7");
}

TEST_CASE("raw counts are typed in hexadecimal or with a mark")
{
    CHECK(outcome("atv12", "HSP=0x01F4") == "500 = 50.0 Hz");
    CHECK(outcome("atv12", "HSP=#500") == "500 = 50.0 Hz");
    CHECK(outcome("atv12", "LFR=0xFFFF") == "65535 = -0.1 Hz");
    CHECK(outcome("atv12", "LFR=#-1") == "65535 = -0.1 Hz");
    CHECK(outcome("atv12", "HSP=0xFFFF") == "value_too_high");
    CHECK(outcome("atv12", "HSP=#-1") == "value_too_low");
    CHECK(outcome("atv12", "HSP=#1.5") == "not_a_number");
    CHECK(outcome("atv12", "HSP=0x10000") == "not_a_number");
}

TEST_CASE("values have names, and bits too")
{
    CHECK(outcome("atv12", "CHCF=SEP") == "2 = SEP");
    CHECK(outcome("atv12", "chcf=sep") == "2 = SEP");
    CHECK(outcome("atv12", "CHCF=2") == "2 = SEP");
    CHECK(outcome("atv12", "CHCF=0x0002") == "2 = SEP");
    CHECK(outcome("atv12", "TBR=19200") == "32 = 19200");
    CHECK(outcome("atv12", "CHCF=3") == "value_without_meaning");
    CHECK(checked("atv12", "CHCF=SEPP").refused->nearest == "SEP");
    CHECK(holds(sentence("atv12", "CHCF=ten"), "SIM (1), SEP (2)"));
    CHECK(outcome("atv12", "CMI=save_to_eeprom") == "2 = 0x0002 (save to eeprom)");
    CHECK(outcome("atv12", "CMD=switch-on+quick_stop").starts_with("5 = "));
    CHECK(outcome("atv12", "CMD=6").starts_with("6 = "));
    CHECK(outcome("atv12", "CMD=go") == "unknown_bit");
    CHECK(checked("atv12", "CMD=revers").refused->nearest == "reverse");
    CHECK(outcome("atv12", "CMD=") == "no_value");
    CHECK(outcome("atv12", "CMD=+") == "unknown_bit");
}

TEST_CASE("a value that does not fit is refused with what would be right")
{
    CHECK(outcome("atv12", "ACC=1.35s") == "value_between_steps");
    CHECK(holds(sentence("atv12", "ACC=1.35s"), "steps of 0.1 s: 1.3 s or 1.4 s"));
    CHECK(holds(sentence("atv12", "LFR=-0.25Hz"), "-0.3 Hz or -0.2 Hz"));
    CHECK(outcome("atv12", "ACC=1000s") == "value_too_high");
    CHECK(holds(sentence("atv12", "ACC=1000s"), "0.0 s to 999.9 s"));
    CHECK(outcome("atv12", "ACC=999.95s") == "value_too_high");
    CHECK(outcome("atv12", "ACC=999.85s") == "value_between_steps");
    CHECK(outcome("atv12", "ACC=0.05s") == "value_between_steps");
    CHECK(outcome("atv12", "ACC=999.9s") == "9999 = 999.9 s");
    CHECK(outcome("atv12", "ACC=-0.05s") == "value_too_low");
    CHECK(outcome("atv12", "ACC=-1s") == "value_too_low");
    CHECK(outcome("atv12", "ACC=5Hz") == "wrong_unit");
    CHECK(holds(sentence("atv12", "ACC=5Hz"), "s, ms"));
    CHECK(outcome("atv12", "NPR=5W") == "wrong_unit");
    CHECK(checked("atv12", "LFR=1500rpm").refused->nearest == "LFRD=1500rpm");
    CHECK(outcome("atv12", "RFR=5Hz") == "read_only");
    CHECK(outcome("atv12", "ACC=1,3s") == "decimal_comma");
    for (char const* const word : {"LFR=-0Hz", "LFR=-0.0", "LFRD=-0rpm"}) { // it would turn a motor forward
        CHECK(outcome("atv12", word) == "zero_with_a_sign");
    }
    CHECK(holds(sentence("atv12", "LFR=-0Hz"), "-0.1 Hz"));
    CHECK(outcome("atv12", "LFR=0Hz") == "0 = 0.0 Hz");
    CHECK(holds(sentence("atv12", "ACC=1,3s"), "1.3, not 1,3"));
    CHECK(outcome("atv12", "ACC=fast") == "not_a_number");
    CHECK(outcome("atv12", "ACC=1.3.4s") == "wrong_unit");
    CHECK(outcome("atv12", "ACC=12345678901234567890") == "not_a_number");
    CHECK(outcome("atv12", "ACC=999999999999999s") == "value_too_high");
    CHECK(outcome("atv12", "ACC=-999999999999999min") == "value_too_low");
    CHECK(outcome("atv12", "ACC") == "no_value");
    CHECK(outcome("atv12", "ACCC=1s") == "unknown_register");
    CHECK(outcome("atv12", "AC*=1s") == "several_registers");
    CHECK(outcome("atv12", "CMD.reverse=1") == "single_bit");
    CHECK(outcome("atv28", "UNS=300V") == "value_never_written");
    CHECK(outcome("atv28", "UNS=380V") == "380 = 380 V");
    CHECK(outcome("atv28", "CMD=0x00F0") == "value_never_written");
}

TEST_CASE("limits and steps that other registers set are asked for, then kept")
{
    CHECK(outcome("atv310", "HSP=60Hz") == "needs LSP TFR");
    CHECK(outcome("atv310", "HSP=60Hz", {{"TFR", 500}, {"LSP", 0}}) == "value_too_high");
    CHECK(holds(sentence("atv310", "HSP=60Hz", {{"TFR", 500}, {"LSP", 0}}), "50.0 Hz (TFR)"));
    CHECK(outcome("atv310", "HSP=50Hz", {{"TFR", 500}, {"LSP", 0}}) == "500 = 50.0 Hz");
    CHECK(outcome("atv310", "HSP=10Hz", {{"TFR", 500}, {"LSP", 101}}) == "value_too_low");
    CHECK(outcome("atv310", "HSP=7000Hz") == "value_too_high"); // 16 bits do not hold it: nothing has to be read
    CHECK(outcome("atv310", "HSP=5000Hz", {{"TFR", 65'535}, {"LSP", 0}}) == "absurd_limit");
    CHECK(outcome("atv320", "HSP=60Hz", {{"TFR", 5'991}, {"LSP", 0}}) == "absurd_limit");
    CHECK(outcome("atv320", "HSP=60Hz", {{"TFR", 5'990}, {"LSP", 0}}) == "600 = 60.0 Hz");
    CHECK(outcome("atv28", "HSP=60Hz", {{"TFR", 4'001}, {"LSP", 0}}) == "absurd_limit");
    CHECK(outcome("atv28", "ITH=2.3A", {{"INV", 20}}) == "23 = 2.3 A");
    CHECK(outcome("atv28", "ITH=2.4A", {{"INV", 20}}) == "value_too_high");
    CHECK(outcome("atv28", "SMAL=1500rpm") == "needs LSP SDS TFR");
    CHECK(outcome("atv28", "SMAL=1500rpm", {{"LSP", 100}, {"TFR", 500}}) == "needs LSP SDS TFR");
    registers const slow{{"LSP", 100}, {"TFR", 500}, {"SDS", 30}}; // 10 Hz, 50 Hz, 30 rpm a hertz
    CHECK(outcome("atv28", "SMAL=1500rpm", slow) == "1500 = 1500 rpm");
    CHECK(outcome("atv28", "SMAL=1501rpm", slow) == "value_too_high");
    CHECK(outcome("atv28", "SMAL=300rpm", slow) == "300 = 300 rpm");
    CHECK(outcome("atv28", "SMAL=299rpm", slow) == "value_too_low");

    CHECK(outcome("atv320", "ACC=1.5s") == "needs INR");
    CHECK(outcome("atv320", "ACC=1.5s", {{"INR", 0}}) == "150 = 1.50 s");
    CHECK(outcome("atv320", "ACC=1.5s", {{"INR", 1}}) == "15 = 1.5 s");
    CHECK(outcome("atv320", "ACC=1.5s", {{"INR", 2}}) == "value_between_steps");
    CHECK(outcome("atv320", "ACC=1.5s", {{"INR", 9}}) == "unknown_step");
    CHECK(outcome("atv320", "ACC=1.5Hz") == "wrong_unit");
}

TEST_CASE("where no table knows a register, its value is a whole number")
{
    CHECK(outcome("", "100=7") == "7 = 7");
    CHECK(outcome("", "100=-1") == "not_a_number");
    CHECK(outcome("", "100:i16=-1") == "65535 = -1");
    CHECK(outcome("", "0x64=0xFFFF") == "65535 = 65535");
    CHECK(outcome("", "100=1.5") == "not_a_number");
    CHECK(outcome("", "100=5Hz") == "not_a_number");
    CHECK(outcome("", "100=65536") == "not_a_number");
    CHECK(outcome("", "ACC=1s") == "no_drive");
    CHECK(outcome("atv12", "100=7") == "7 = 7");
}

TEST_CASE("each word of each register that may be written is written back from its text")
{
    std::size_t written = 0;
    for (tool::drive_catalog const* drive : tool::all_catalogs()) {
        for (tool::register_entry const& each : drive->registers) {
            // Limits and steps that depend on others are tried above.
            if (not each.is_writable() or not each.steps_set_by.empty() or each.min.code().size() > 0 or
                each.max.code().size() > 0) {
                continue;
            }
            for (std::uint32_t number = 0; number <= 0xFFFF; number += 251 * rtuwire::test::one_in(7)) {
                auto const word = static_cast<std::uint16_t>(number);
                auto const raw = tool::check_value(std::string{each.code} + "=" + tool::hex_word(word), drive);
                std::string text = tool::text_of(each, word);
                text = each.kind == tool::register_kind::enumeration ? text.substr(0, text.find(':')) : text;
                std::string const typed = std::string{each.code} + "=" + text;
                auto const found = tool::check_value(typed, drive);
                INFO(drive->name << ' ' << typed);
                REQUIRE(found.is_ready() == raw.is_ready());
                REQUIRE((not found.is_ready() or found.words == std::vector{word}));
                written += found.is_ready() ? 1U : 0U;
            }
        }
    }
    CHECK(written > 10'000 / rtuwire::test::one_in(7));
}

TEST_CASE("a drive's register is the same by whatever place it is named")
{
    for (std::string_view const place :
         {"holding:9001", "h:0x2329", "list:49002", "9001:u16", "9001:hex", "9001:bits", "9001:abcd"}) {
        std::string const word{place};
        INFO(word);
        CHECK(outcome("atv320", word + "=0x000D", {{"INR", 1}}) == "13 = 1.3 s");
        CHECK(checked("atv320", word + "=0x000D").entry == tool::catalog_named("atv320")->by_code("ACC"));
    }
    CHECK(outcome("atv320", "9001:u16=13") == outcome("atv320", "9001=#13"));
    CHECK(outcome("atv320", "holding:9001=13") == "unit_missing");
    CHECK(outcome("atv320", "holding:9001=1.3s", {{"INR", 1}}) == outcome("atv320", "ACC=1.3s", {{"INR", 1}}));
    CHECK(outcome("atv320", "8602:i16=-1") == outcome("atv320", "8602=#-1"));
    CHECK(outcome("atv320", "holding:3202=1") == "read_only");
    // Whatever contradicts the drive's table is no other view of the same.
    for (std::string_view const form : {"9001:0.1s", "9001:1s", "9001:0.01", "9001:1+5", "9001:i16", "9001:badc",
                                        "9001:bcd16", "9001:text2", "8602:u16", "8602:1rpm"}) {
        std::string const word{form};
        CHECK(outcome("atv320", word + "=1", {{"INR", 0}}) == "wrong_form");
    }
    CHECK(holds(sentence("atv320", "9001:0.1s=1.3s"), "this is ACC"));
    CHECK(holds(sentence("atv320", "9001:0.1s=1.3s"), "in s, and its drive says its scale: leave out ':0.1s'"));
    CHECK(outcome("atv320", "64000:0.1V=1.3V") == "13 = 1.3 V");
    CHECK(outcome("atv320", "8500:u32=6") == "not_of_a_drive");
    CHECK(outcome("atv320", "coil:8501=on") == "not_of_a_drive");
    CHECK(outcome("atv320", "input:8501=6") == "read_only");
    CHECK(outcome("atv320", "8501.3=1") == "single_bit");
    CHECK(outcome("atv320", "8501-8502:u16=1") == "several_registers");
    CHECK(outcome("", "input:40=6") == "read_only");
    CHECK(outcome("", "40.3=on") == "8 = 1");
    CHECK(outcome("", "40.15=off") == "0 = 0");
    CHECK(outcome("", "40.4-7=0xA") == "160 = 10");
    CHECK(outcome("", "40.0-15=65535") == "65535 = 65535");
    CHECK(outcome("", "40.3=2") == "not_a_number");
    CHECK(outcome("", "40.4-7=16") == "not_a_number");
    CHECK(outcome("", "40.4-7=-1") == "not_a_number");
    CHECK(outcome("", "input:40.3=on") == "read_only");
    CHECK(outcome("", "coil:40=on") == "1 = 1");
    CHECK(outcome("", "40:0.1V=230.1V") == "2301 = 230.1 V");
    CHECK(outcome("", "40:text246=a").ends_with(" = a"));
    CHECK(outcome("", "40:text247=a") == "too_long");
    CHECK(outcome("", "40:text250=a") == "too_long");
}

TEST_CASE("a raw count is shown in the steps that the drive has")
{
    CHECK(outcome("atv320", "ACC=#13", {{"INR", 0}}) == "13 = 0.13 s");
    CHECK(outcome("atv320", "9001:u16=13", {{"INR", 1}}) == "13 = 1.3 s");
    CHECK(outcome("atv320", "ACC=0x000D", {{"INR", 2}}) == "13 = 13 s");
    CHECK(outcome("atv320", "ACC=#13") == "13 = 13 steps");
    CHECK(tool::check_value("ACC=#13", tool::catalog_named("atv320")).needed.size() == 1);
}

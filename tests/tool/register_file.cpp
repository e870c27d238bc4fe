// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Register files: what they mean, and what is refused of them, where and why.
#include "device/register_file.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

#include "exit_status.hpp"
#include "words/named_value.hpp"
#include "words/register_words.hpp"
#include "words/value_words.hpp"

namespace {

constexpr std::string_view meter = R"(# A meter.
[[register]]
name = "voltage"
space = "input"
address = 1000
type = "f32"
order = "cdab"
unit = "V"

[[register]]
name = "setpoint"
address = 40
type = "i16"
scale = 0.1
unit = "degC"
offset = -50
access = "write"
min = -10
max = 95.5

[[register]]
name = "mode"
address = 41
bits = "4-7"

[[register]]
name = "ready"
address = 41
bits = "3"

[[register]]
name = "relay"
space = "coil"
address = 0x03
access = "write"

[[register]]
name = "serial"
space = "list"
address = 40101
type = "text20"
)";

constexpr std::string_view boiler = R"([device]
max_registers = 8
pause = 20

[groups]
fast = "200ms"
slow = "5min"

[[register]]
name = "mode"
address = 1
type = "i16"
access = "write"
choices = { off = 0, heat = 1, cool = -1 }
setting = true
stored = true
group = "fast"

[[register]]
name = "stage"
address = 2
bits = "4-5"
choices = { low = 1, high = 2 }

[[register]]
name = "door"
space = "discrete"
address = 0
choices = { open = 1, closed = 0 }

[[register]]
name = "vent"
space = "coil"
address = 0
access = "write"
moves = true
choices = { open = 1, closed = 0 }

[[register]]
name = "power"
address = 3
type = "i32"
unit = "W"
invalid = [-2147483648, 0xFFFFFFFF]
group = "Fast"

[[register]]
name = "outside"
space = "input"
address = 0
type = "i16"
scale = 0.1
unit = "degC"
invalid = 0x7FFF
group = "slow"

[[register]]
name = "target"
address = 5
access = "write"
invalid = 0x7FFF
)";

/// The sentence of a refusal; empty where there is none.
std::string refused(std::string const& text)
{
    try {
        static_cast<void>(tool::read_register_file("m.toml", text));
    } catch (tool::ended const& why) {
        CHECK(why.status == tool::exit_status::usage);
        return why.what();
    }
    return {};
}

std::string of_one(std::string_view lines)
{
    return "[[register]]\nname = \"a1\"\naddress = 40\n" + std::string{lines};
}

std::string many_registers(unsigned count)
{
    std::string all;
    for (unsigned i = 0; i < count; ++i) {
        all += "[[register]]\nname = \"r" + std::to_string(i) + "\"\naddress = " + std::to_string(i) + '\n';
    }
    return all;
}

} // namespace

TEST_CASE("a register file's names are places")
{
    tool::named_places const file = tool::read_register_file("m.toml", std::string{meter});
    std::string all;
    for (tool::named_place const& each : file.places) {
        tool::place bare = each.where;
        bare.name.clear();
        all += each.where.name + ' ' + tool::text_of(bare) + (each.is_writable ? " w\n" : "\n");
        CHECK(tool::text_of(each.where) == each.where.name);
    }
    CHECK(all == "voltage input:1000:f32:cdab:1V\nsetpoint holding:40:i16:0.1degC-50.0 w\nmode holding:41.4-7\n"
                 "ready holding:41.3\nrelay coil:3 w\nserial holding:100:text20\n");
    std::string_view const words[]{"Voltage", "re*", "input:7"};
    tool::register_selection const found = tool::select_registers(words, {nullptr, &file});
    REQUIRE(found.registers.size() == 4);
    CHECK(found.registers[2].where.name == "relay");
    std::string_view const wrong[]{"voltag"};
    CHECK(tool::select_registers(wrong, {nullptr, &file}).refused->nearest == "voltage");
}

TEST_CASE("what a register file says of a value counts, by whatever words it is written")
{
    tool::named_places const file = tool::read_register_file("m.toml", std::string{meter});
    auto const says = [&file](std::string_view word) {
        tool::value_to_write const value = tool::check_value(word, {nullptr, &file});
        return value.refused ? value.refused->sentence : value.text;
    };
    CHECK(says("setpoint=21.5degC") == "21.5 degC");
    CHECK(says("SETPOINT=-10") == "-10.0 degC");
    CHECK(says("setpoint=95.5") == "95.5 degC");
    CHECK(says("relay=on") == "1");
    CHECK(says("holding:50=7") == "7");
    for (std::string_view const word : {"setpoint=95.6", "setpoint=-10.1", "setpoint=#1456", "setpoint=0x7FFF"}) {
        CHECK(says(word) == std::string{word} + ": setpoint takes at least -10 degC and at most 95.5 degC");
    }
    CHECK(says("voltage=1V") == "voltage=1V: input registers and discrete inputs are read only");
    CHECK(says("serial=x") == "serial=x: serial is read only: m.toml:38 gives it no access = \"write\"");
    CHECK(says("holding:100=1") == "holding:100=1: serial is read only: m.toml:38 gives it no access = \"write\"");
    CHECK(says("109:u16=1") == "109:u16=1: serial is read only: m.toml:38 gives it no access = \"write\"");
    CHECK(says("40=1") == "40=1: this is setpoint of m.toml, which has a form and limits: say that name");
    CHECK(says("39:u32=1") == "39:u32=1: this is setpoint of m.toml, which has a form and limits: say that name");
    CHECK(says("coil:3=on") == "coil:3=on: this is relay of m.toml, which has a form and limits: say that name");
}

TEST_CASE("choices, marks, groups and what means no value count for a register")
{
    tool::named_places const file = tool::read_register_file("b.toml", std::string{boiler});
    CHECK(file.max_registers == 8);
    CHECK(file.pause == 20U);
    CHECK(file.group_named("FAST")->period == 0.2);
    auto const text = [&file](std::string_view name, std::vector<std::uint16_t> const& words) {
        return tool::value_of(*file.by_name(name), words).text;
    };
    CHECK(text("mode", {1}) == "heat (1)");
    CHECK(text("mode", {0xFFFF}) == "cool (-1)");
    CHECK(text("mode", {7}) == "7, which is none of its choices");
    CHECK(tool::value_of(*file.by_name("mode"), std::vector<std::uint16_t>{1}).value ==
          tool::cell{std::string{"heat"}});
    CHECK(text("stage", {0x0020}) == "high (2)");
    CHECK(text("door", {1}) == "open (1)");
    CHECK(text("power", {0x8000, 0}) == "no value (0x80000000)");
    CHECK(text("power", {0xFFFF, 0xFFFF}) == "no value (0xFFFFFFFF)");
    CHECK(text("power", {0xFFFF, 0xFFFE}) == "-2 W");
    CHECK(text("outside", {0x7FFF}) == "no value (0x7FFF)");
    auto const says = [&file](std::string_view word) {
        tool::value_to_write const value = tool::check_value(word, {nullptr, &file});
        return value.refused ? value.refused->sentence : value.text;
    };
    CHECK(says("mode=Heat") == "heat (1)");
    CHECK(says("mode=-1") == "cool (-1)");
    CHECK(says("mode=0x0000") == "off (0)");
    CHECK(says("mode=3") == "mode=3: mode takes cool -1, off 0, heat 1");
    CHECK(says("mode=haet") == "mode=haet: mode takes cool -1, off 0, heat 1; did you mean 'heat'?");
    CHECK(says("vent=open") == "open (1)");
    CHECK(says("vent=on") == "open (1)");
    CHECK(says("target=#32767") == "target=#32767: 0x7FFF means that target has no value");
    std::string_view const group[]{"@fast", "target"};
    tool::register_selection const found = tool::select_registers(group, {nullptr, &file});
    REQUIRE(found.registers.size() == 3);
    CHECK(found.registers[0].named == file.by_name("mode"));
    CHECK(found.registers[1].named == file.by_name("power"));
    std::string_view const wrong[]{"@fest"};
    CHECK(tool::select_registers(wrong, {nullptr, &file}).refused->sentence ==
          "@fest: b.toml has no such group, but fast, slow; did you mean @fast?");
}

TEST_CASE("a register file that is wrong is refused with its place and the reason")
{
    struct row {
        std::string text;
        std::string_view says;
    };
    row const rows[]{
        {"", "m.toml:1:1: it has no registers"},
        {"[[register]]\nname = \"Time\"\naddress = 4", "m.toml:2:8: 'Time': is a column of what is shown, and no name"},
        {"[[register]]\nname = \"error\"\naddress = 4",
         "m.toml:2:8: 'error': is a column of what is shown, and no name"},
        {many_registers(2'001), "2001 registers; a register file has at most 2000"},
        {"register = 5", "m.toml:1:12: it has no registers"},
        {"register = [1]", "m.toml:1:12: it has no registers"},
        {"register = []", "m.toml:1:12: it has no registers"},
        {"[[register]]\nname = ", "m.toml:2:"},
        {"[[registers]]\n", "'registers' is no key here; did you mean 'register'?"},
        {"[[register]]\naddress = 4", "m.toml:1:1: a register without a name"},
        {"[[register]]\nname = \"a1\"\n", "m.toml:1:1: address is missing, or no whole number"},
        {"[[register]]\nname = 7\n", "m.toml:2:8: name is a text"},
        {"[[register]]\nname = \"a1\"\naddress = \"40\"", "m.toml:3:11: address is missing, or no whole number"},
        {"[[register]]\nname = \"a1\"\naddress = 4.5", "m.toml:3:11: address is missing, or no whole number"},
        {"[[register]]\nname = \"a1\"\naddress = -1", "m.toml:3:11: a1 is holding:-1: '' is no address"},
        {"[[register]]\nname = \"a1\"\naddress = 65536", "m.toml:3:11: a1 is holding:65536: '65536' is no address"},
        {of_one("adress = 4"), "m.toml:4:1: 'adress' is no key here; did you mean 'address'?"},
        {of_one("type = \"f33\""), "m.toml:4:8: a1 is holding:40:f33: 'f33' is no type"},
        {of_one("type = \"f32:cdab\""), "m.toml:4:8: type: 'f32:cdab' is none"},
        {of_one("type = 32"), "m.toml:4:8: type is a text"},
        {of_one("bits = \"16\""), "m.toml:4:8: a1 is holding:40.16: '.16' is no bit"},
        {of_one("space = \"inputs\""), "m.toml:4:9: a1 is inputs:0: 'inputs' is no space"},
        {"[[register]]\nname = \"a1\"\naddress = 20000\nspace = \"list\"",
         "m.toml:3:11: a1 is list:20000: '20000' is no number of a list"},
        {of_one("space = \"coil\"\nbits = \"3\""), "m.toml:5:8: a1 is coil:40.3: a coil is one bit"},
        {of_one("space = \"coil\"\nunit = \"V\""), "m.toml:5:8: a1 is coil:40:1V: a coil has no type"},
        {of_one("order = \"cdab\""), "m.toml:4:9: a1 is holding:40:cdab: each of its values is bytes of one register"},
        {of_one("type = \"text8\"\noffset = 3"), "m.toml:5:10: a1 is holding:40:text8:1+3.0: text8 is no number"},
        {of_one("scale = 0"), "m.toml:4:9: a1 is holding:40:0: '0': a scale is a number above 0"},
        {of_one("scale = \"0.1\""), "m.toml:4:9: scale is a number"},
        {of_one("scale = nan"), "m.toml:4:9: scale is a number"},
        {of_one("scale = -0.1"), "m.toml:4:9: a1 is holding:40:-0.1: '-0.1': a scale begins with a digit"},
        {of_one("unit = \"=V\""), "is no unit"},
        {of_one("unit = \"min-1\""), "m.toml:4:8: 'min-1' is no unit"},
        {of_one("unit = \"{{V\""), "is no unit"},
        {of_one("unit = \"5V\""), "m.toml:4:8: '5V' is no unit"},
        {of_one("unit = \".5V\""), "is no unit"},
        {of_one("type = \"0.1V\""), "type: '0.1V' is none"},
        {of_one("type = \"7V\""), "m.toml:4:8: type: '7V' is none"},
        {of_one("order = \"u16\""), "m.toml:4:9: order: 'u16' is none"},
        {of_one("access = \"rw\""), "m.toml:4:10: access is \"read\" or \"write\""},
        {of_one("access = true"), "m.toml:4:10: access is a text"},
        {of_one("space = \"input\"\naccess = \"write\""),
         "m.toml:5:10: input registers and discrete inputs are read only"},
        {of_one("bits = \"3\"\naccess = \"write\"\nsetting = true"),
         "m.toml:6:11: some bits of a register are no setting"},
        {of_one("min = 3"), "m.toml:4:7: min and max limit what is written, and this is not written"},
        {of_one("access = \"write\"\nmin = 3\nmax = 2"), "m.toml:5:7: min is above max"},
        {of_one("access = \"write\"\ntype = \"text8\"\nmax = 2"), "this is no number"},
        {of_one("type = \"f32\"\n[[register]]\nname = \"b1\"\naddress = 41"),
         "m.toml:7:11: b1 has register 41, which is of a1 in line 2"},
        {of_one("bits = \"3-5\"\n[[register]]\nname = \"b1\"\naddress = 40\nbits = \"5\""),
         "b1 has register 40, which is of a1"},
        {of_one("[[register]]\nname = \"A1\"\naddress = 41"), "m.toml:5:8: the name 'A1' stands in line 2, too"},
        {of_one("name = \"a2\""), "m.toml:4:"},
        {of_one("acess = \"write\""), "m.toml:4:1: 'acess' is no key here; did you mean 'access'?"},
        {of_one("choices = 3"), "m.toml:4:11: choices is a table"},
        {of_one("choices = {}"), "m.toml:4:11: choices are none: { off = 0, heat = 1 }"},
        {of_one("choices = { off = 0, OFF = 1 }"), "are one choice twice"},
        {of_one("choices = { off = 0, on = 0 }"), "m.toml:4:22: off and on are one choice twice"},
        {of_one("choices = { off = 70000 }"), "m.toml:4:19: no number of a1 is 70000"},
        {of_one("choices = { off = \"0\" }"), "m.toml:4:19: off is no whole number"},
        {of_one("choices = { \"=1\" = 0 }"), "m.toml:4:13: '=1': a name begins with a letter"},
        {of_one("bits = \"3\"\nchoices = { off = 2 }"), "m.toml:5:19: no number of a1 is 2"},
        {of_one("type = \"f32\"\nchoices = { off = 0 }"), "m.toml:5:11: choices are names of whole numbers"},
        {of_one("scale = 0.1\nchoices = { off = 0 }"), "m.toml:5:11: choices are names of whole numbers"},
        {of_one("access = \"write\"\nmin = 1\nchoices = { off = 0 }"), "m.toml:6:11: choices are names"},
        {of_one("invalid = 0x10000"), "m.toml:4:11: invalid is a number of 16 bits"},
        {of_one("invalid = -32769"), "m.toml:4:11: invalid is a number of 16 bits"},
        {of_one("invalid = [0x7FFF, 1.5]"), "m.toml:4:20: invalid is a number of 16 bits"},
        {of_one("type = \"text8\"\ninvalid = 0"), "m.toml:5:11: a text has no invalid number"},
        {of_one("setting = true"), "m.toml:4:11: setting is of what is written, and this has no access"},
        {of_one("stored = true"), "m.toml:4:10: stored is of what is written"},
        {of_one("setting = \"yes\""), "m.toml:4:11: setting is true or false"},
        {of_one("access = \"write\"\nmoves = true\nsetting = true"),
         "m.toml:6:11: what moves something is no setting: it is never restored"},
        {of_one("group = \"slow\""), "m.toml:4:9: the group 'slow' has no period"},
        {of_one("group = \"slw\"\n[groups]\nslow = \"1s\""), "did you mean 'slow'?"},
        {of_one("[groups]\nslow = 1"), "m.toml:5:8: a group has the period in which it is read: slow = \"200ms\""},
        {of_one("[groups]\nslow = \"0s\""), "m.toml:5:8: a group has the period"},
        {of_one("[groups]\n1slow = \"1s\""), "m.toml:5:1: '1slow': a name begins with a letter"},
        {of_one("[groups]\nslow = \"1s\"\nSlow = \"2s\""), "stands in two lines"},
        {"groups = 3", "m.toml:1:10: groups is a table"},
        {of_one("[device]\npause = 3001"), "m.toml:5:9: pause is a whole number from 0 to 3000"},
        {of_one("[device]\nmax_registers = 0"), "m.toml:5:17: max_registers is a whole number from 1 to 125"},
        {of_one("[device]\nmax_register = 9"),
         "m.toml:5:1: 'max_register' is no key here; did you mean 'max_registers'?"},
        {of_one("simulated = 70000"), "m.toml:4:13: simulated: it takes 0 to 65535"},
        {of_one("bits = \"3-4\"\nsimulated = 4"), "m.toml:5:13: simulated: these bits are one number from 0 to 3"},
        {of_one("choices = { off = 0 }\nsimulated = \"on\""), "m.toml:5:13: simulated: a1 takes off 0"},
        {of_one("simulated = [1]"), "m.toml:4:13: simulated: it takes a number"},
        {of_one("[device]\nvendor = \"A\""), "vendor and product go together"},
        {of_one("[device]\nvendor = \"\"\nproduct = \"B\""), "m.toml:5:10: vendor is a text of 1 to 63 characters"},
        {of_one("type = \"f32\"\n[device]\nmax_registers = 1"),
         "m.toml:4:8: a1 has 2 registers, and max_registers is 1"},
    };
    for (row const& each : rows) {
        INFO(each.text);
        CHECK_THAT(refused(each.text), Catch::Matchers::Contains(std::string{each.says}));
    }
    CHECK(refused(of_one("[[register]]\nname = \"b1\"\nspace = \"input\"\naddress = 40")).empty());
    CHECK_THAT(refused(of_one(std::string{"# "} + '\0')), Catch::Matchers::Contains("m.toml: a byte is zero"));
    CHECK_THAT(refused(std::string(60'000'000, '#')),
               Catch::Matchers::Contains("60000000 bytes; such a file has at most"));
    CHECK_THAT(refused("a = " + std::string(100'000, '[')), Catch::Matchers::Contains("m.toml:1:"));
}

TEST_CASE("a name is no order for a shell, a topic or a spreadsheet, and looks like no place")
{
    for (std::string const name :
         {"",        "=a",  "+a",   "-a",  "@a",      "1a",   "a/b",    "a+b",      "a#",       "{{a}}", "a b",
          "a.b",     "a:b", "a*",   "a?",  "a,b",     "$(a)", "a;b",    "a`b",      "a\\u001B", "a\\nb", "\\u00E4",
          "holding", "I",   "list", "u16", "Float32", "cdab", "text20", "ghefcdab", "hex"}) {
        INFO(name);
        CHECK_THAT(refused("[[register]]\nname = \"" + name + "\"\naddress = 1"),
                   Catch::Matchers::Contains("m.toml:2:8: '"));
    }
    for (std::string const name : {"a1", "Voltage_L1", "e5", "face", "A"}) {
        INFO(name);
        CHECK(refused("[[register]]\nname = \"" + name + "\"\naddress = 1").empty());
    }
}

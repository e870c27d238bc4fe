// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file of the gateway: what it means, and what is refused of it, where and why.
#include "../../tools/gateway/gateway_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "support/catch.hpp"

#include <rtuwire/sim.hpp>

#include "gateway/scratch_folder.hpp"

using namespace tool;
using namespace tool::gateway;
using gateway_test::scratch_folder;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view meter = R"(
[groups]
slow = "30s"

[[register]]
name = "voltage"
space = "input"
address = 0
type = "f32"
unit = "V"

[[register]]
name = "energy"
space = "input"
address = 2
type = "u32"
scale = 0.01
unit = "kWh"
group = "slow"

[[register]]
name = "set_point"
address = 40
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = 5
max = 30
stored = true

[[register]]
name = "mode"
address = 41
access = "write"
choices = { off = 0, heat = 1 }

[[register]]
name = "valve"
space = "coil"
address = 3
access = "write"
moves = true

[[register]]
name = "lamp"
space = "coil"
address = 4
access = "write"
)";

constexpr std::string_view whole = R"(site = "hall3"
gateway = "g1"
[broker]
host = "127.0.0.1"
discovery = ""
[[line]]
name = "line1"
port = "sim:atv320:7"
baud = 38400
format = "8N1"
timeout = 0.2
retries = 0
rs485 = false
[[line.device]]
name = "meter1"
unit = 3
file = "meter.toml"
every = 2.0
groups = [{ registers = ["energy"], every = 60.0 }]
settings = ["set_point", "mode", "lamp"]
[[line.device]]
name = "fan"
unit = 7
drive = "ATV320"
registers = ["RFR", "ETA.fault", "LFT"]
settings = ["ITH"]
feeds_supervision = true
)";

class file_folder : public scratch_folder {
public:
    file_folder() { write("meter.toml", meter); }

    gateway_plan read(std::string_view text) const
    {
        return read_gateway_file(path("gateway.toml"), std::string{text});
    }

    /// Why a text is refused, behind the name of its folder.
    std::string refusal(std::string_view text) const
    {
        try {
            static_cast<void>(read(text));
        } catch (ended const& why) {
            CHECK(why.status == exit_status::usage);
            std::string const all = why.what();
            std::string const head = path("");
            return all.starts_with(head) ? all.substr(head.size()) : all;
        }
        return "taken";
    }
};

std::string with(std::string_view text, std::string_view from, std::string_view to)
{
    std::string changed{text};
    std::size_t const at = changed.find(from);
    REQUIRE(at != changed.npos);
    return changed.replace(at, from.size(), to);
}

device_value const& value_named(device_plan const& device, std::string_view name)
{
    for (device_value const& each : device.values) {
        if (each.name == name) {
            return each;
        }
    }
    FAIL("no value " << name);
    std::abort();
}

} // namespace

TEST_CASE("a whole file has its lines, devices, values and periods")
{
    file_folder const folder;
    gateway_plan const plan = folder.read(with(whole, "settings = [\"ITH\"]\n", ""));

    CHECK(plan.site == "hall3");
    CHECK(plan.gateway == "g1");
    CHECK(plan.broker.discovery.empty());
    REQUIRE(plan.lines.size() == 1);
    line_plan const& line = *plan.lines[0];
    CHECK(line.choices.baud == 38'400);
    CHECK(line.choices.format == "8N1");
    CHECK(line.choices.response_timeout == 0.2);
    CHECK(line.choices.retries == 0);
    REQUIRE(line.devices.size() == 2);

    device_plan const& meter_device = line.devices[0];
    CHECK(meter_device.unit.unit.byte() == 3);
    CHECK(meter_device.values.size() == 6);
    CHECK(value_named(meter_device, "voltage").every == 2.0);
    CHECK(value_named(meter_device, "voltage").unit == "V");
    CHECK_FALSE(value_named(meter_device, "voltage").decimals);
    CHECK(value_named(meter_device, "energy").every == 60.0);
    CHECK(value_named(meter_device, "energy").decimals == 2U);
    CHECK_FALSE(value_named(meter_device, "energy").setting);
    device_value const& set_point = value_named(meter_device, "set_point");
    REQUIRE(set_point.setting);
    CHECK(set_point.setting->lowest == 5.0);
    CHECK(set_point.setting->highest == 30.0);
    CHECK(set_point.setting->step == 0.1);
    CHECK(set_point.setting->is_stored);
    CHECK(value_named(meter_device, "mode").kind == value_kind::choice);
    CHECK(value_named(meter_device, "mode").setting->choices == std::vector<std::string>{"off", "heat"});
    CHECK(value_named(meter_device, "lamp").kind == value_kind::flag);

    device_plan const& fan = line.devices[1];
    REQUIRE(fan.drive != nullptr);
    CHECK(fan.unit.drive == "atv320");
    REQUIRE(fan.values.size() == 3);
    CHECK(fan.values[0].name == "RFR");
    CHECK(fan.values[0].unit == "Hz");
    CHECK(fan.values[0].decimals == 1U);
    CHECK(fan.values[1].name == "ETA_fault");
    CHECK(fan.values[1].kind == value_kind::flag);
    CHECK(fan.values[2].kind == value_kind::choice);
    bool const is_told = plan.notes.size() == 1 and plan.notes[0].find("runs on while it is read") != std::string::npos;
    CHECK(is_told);
}

TEST_CASE("without a period in the file a register has that of its group in the register file, or a second")
{
    file_folder const folder;
    gateway_plan const plan = folder.read(R"(site = "s"
gateway = "g"
[[line]]
name = "l"
port = "/dev/ttyUSB0"
[[line.device]]
name = "d"
unit = 1
file = "./meter.toml"
)");
    device_plan const& device = plan.lines[0]->devices[0];
    CHECK(device.values.size() == 6);
    CHECK(value_named(device, "energy").every == 30.0);
    CHECK(value_named(device, "voltage").every == 1.0);
    CHECK_FALSE(value_named(device, "set_point").setting);
    REQUIRE(plan.notes.size() == 1);
    CHECK(plan.notes[0].find("/dev/serial/by-id/") != std::string::npos);
}

TEST_CASE("what is wrong in the file is refused with its place")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    REQUIRE(folder.refusal(right) == "taken");
    struct wrong_text {
        std::string_view from;
        std::string_view to;
        std::string_view why; ///< begins with it
    };
    wrong_text const all[]{
        {"site = \"hall3\"", "site = \"hall 3\"", "gateway.toml:1:8: site is a part of topics"},
        {"site = \"hall3\"", "", "gateway.toml:1:1: site is missing"},
        {"gateway = \"g1\"", "gateway = \"g1/#\"", "gateway.toml:2:11: gateway is a part of topics"},
        {"gateway = \"g1\"", "gatway = \"g1\"", "gateway.toml:2:1: 'gatway' is no key here; did you mean 'gateway'?"},
        {"gateway = \"g1\"", "gateway = \"g1\"\nwrite = true", "gateway.toml:3:1: 'write' is typed: no file allows it"},
        {"host = \"127.0.0.1\"", "host = \"\"", "gateway.toml:4:8: host is empty"},
        {"host = \"127.0.0.1\"", "port = 65536", "gateway.toml:4:8: port is a whole number from 1 to 65535"},
        {"host = \"127.0.0.1\"", "password_file = \"p\"", "gateway.toml:4:17: a password goes with a user"},
        {"host = \"127.0.0.1\"", "cert_file = \"p\"", "gateway.toml:3:1: cert_file and key_file go together"},
        {"discovery = \"\"", "protocol = \"4\"", "gateway.toml:5:12: protocol is that of MQTT, \"5\" or \"3.1.1\""},
        {"discovery = \"\"", "discovery = \"a/+\"", "gateway.toml:5:13: discovery is the prefix"},
        {"name = \"line1\"", "name = \"status\"", "gateway.toml:7:8: 'status' is a topic of the gateway itself"},
        {"port = \"sim:atv320:7\"\n", "", "gateway.toml:6:1: port is missing"},
        {"port = \"sim:atv320:7\"", "port = \"sim:atv3200:7\"", "gateway.toml:8:8: port = \"sim:atv3200:7\": "},
        {"baud = 38400", "baud = 0", "gateway.toml:9:8: baud = \"0\": '0' is no number from 1 to 10000000"},
        {"format = \"8N1\"", "format = 8E1", "gateway.toml:10:10: "},
        {"timeout = 0.2", "timeout = 0", "gateway.toml:11:11: timeout = \"0\": '0' is no number from 0.001 to 30"},
        {"rs485 = false", "rs485 = 2", "gateway.toml:13:9: rs485 = \"2\": it is true or false"},
        {"unit = 3", "unit = 0", "gateway.toml:16:8: unit is a whole number from 1 to 247"},
        {"unit = 3\n", "", "gateway.toml:14:1: unit is missing"},
        {"unit = 3", "unit = 7", "gateway.toml:23:8: unit '7' stands in line 16, too"},
        {"name = \"fan\"", "name = \"meter1\"", "gateway.toml:22:8: the device 'meter1' stands in line 15, too"},
        {"file = \"meter.toml\"", "file = \"none.toml\"", "gateway.toml:17:8: "},
        {"file = \"meter.toml\"\n", "", "gateway.toml:14:1: the device 'meter1' has either a register file"},
        {"every = 2.0", "every = 0.001", "gateway.toml:18:9: every is a number of seconds, 0.02 to 86400"},
        {"every = 2.0", "evry = 2.0", "gateway.toml:18:1: 'evry' is no key here; did you mean 'every'?"},
        {"[\"energy\"], every = 60.0", "[\"enrgy\"], every = 60.0", "gateway.toml:19:26: "},
        {"[\"energy\"], every = 60.0 }", "[\"energy\"], every = 60.0 }, { registers = [\"energy\"], every = 1 }",
         "gateway.toml:19:68: energy is in two groups"},
        {"[\"energy\"], every = 60.0", "[\"energy\"]", "gateway.toml:19:11: a group has registers and a period"},
        {"\"lamp\"", "\"valve\"",
         "gateway.toml:20:34: valve cannot be a setting: it moves something, as its register file says in line 39"},
        {"\"lamp\"", "\"voltage\"", "gateway.toml:20:34: voltage cannot be a setting: it has no access = \"write\""},
        {"\"lamp\"", "\"coil:4\"",
         "gateway.toml:20:34: coil:4 cannot be a setting: a setting is a register by its name"},
        {"drive = \"ATV320\"", "drive = \"atv32\"", "gateway.toml:24:9: 'atv32' is no drive"},
        {"feeds_supervision = true", "", "gateway.toml:24:9: reading 'fan' feeds the drive's supervision of its line"},
        {"feeds_supervision = true", "feeds_supervision = 1", "gateway.toml:26:21: feeds_supervision is true or false"},
        {"[\"RFR\", \"ETA.fault\", \"LFT\"]", "[\"RFRR\"]", "gateway.toml:25:14: "},
        {"[\"RFR\", \"ETA.fault\", \"LFT\"]", "[]", "gateway.toml:25:13: registers is a list of names"},
    };
    for (wrong_text const& each : all) {
        std::string const why = folder.refusal(with(right, each.from, each.to));
        CAPTURE(each.to, why);
        CHECK(why.starts_with(each.why));
    }
    CHECK(folder.refusal("") ==
          "gateway.toml:1:1: site is missing: it is a part of topics, 1 to 64 letters, digits, - and _");
    CHECK(folder.refusal("site = \"a\"\ngateway = \"b\"\n").find("it has no lines") != std::string::npos);
}

TEST_CASE("no text and no key of a file, or of a register file that it names, has a control character")
{
    file_folder const folder;
    std::string const right = with(
        with(with(whole, "settings = [\"ITH\"]\n", ""), "discovery = \"\"", "user = \"u\"\npassword_file = \"p\""),
        "rs485 = false\n", "[line.serve]\nunits = \"3\"\nlisten = \"mbap://0.0.0.0:1502\"\nfrom = [\"10.0.0.7\"]\n");
    REQUIRE(folder.refusal(right) == "taken");
    std::pair<std::string, std::string> const marks[]{{"\\u0000", "\\x00"}, {"\\n", "\\x0A"},
                                                      {"\\t", "\\x09"},     {"\\u001B", "\\x1B"},
                                                      {"\\u007F", "\\x7F"}, {"\\u0085", "\\xC2\\x85"}};
    auto const check_all = [&](std::string const& file, std::string const& text, auto const& refusal_of) {
        unsigned texts = 0;
        for (std::size_t begin = text.find('"'); begin != text.npos; begin = text.find('"', begin)) {
            std::size_t const end = text.find('"', begin + 1);
            ++texts;
            for (auto const& [mark, shown] : marks) {
                for (std::size_t const at : {begin + 1, end}) {
                    std::string changed = text;
                    changed.insert(at, mark);
                    std::string const found = refusal_of(changed);
                    auto const line =
                        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
                    CAPTURE(changed.substr(begin, end + mark.size() + 1 - begin), found);
                    CHECK(found.starts_with(file + ':' + std::to_string(line) + ':'));
                    CHECK(found.find(shown + (at == end ? "' has a control character" : "")) != found.npos);
                }
            }
            begin = end + 1;
        }
        return texts;
    };
    CHECK(check_all("gateway.toml", right, [&](std::string const& text) { return folder.refusal(text); }) == 22);
    CHECK(check_all("meter.toml", std::string{meter}, [&](std::string const& text) {
              folder.write("meter.toml", text);
              return folder.refusal(right);
          }) == 22);
    folder.write("meter.toml", with(meter, "off = 0", "\"of\\u0000f\" = 0"));
    CHECK(folder.refusal(right).starts_with("meter.toml:36:13: 'of\\x00f' has a control character"));
}

TEST_CASE("of a drive nothing is a setting that moves its motor, changes how it turns, or takes orders")
{
    file_folder const folder;
    CHECK(folder.refusal(whole) == "taken");
    for (std::string_view const name : {"CMD", "LFR", "LFRD", "HSP", "LSP", "ACC", "CHCF", "FR1", "RFR", "CMI"}) {
        std::string const why = folder.refusal(with(whole, "ITH", name));
        CAPTURE(name, why);
        CHECK(why.starts_with("gateway.toml:26:13: " + std::string{name} + " cannot be a setting: "));
    }
}

TEST_CASE("of a drive nothing is a setting that moves it out of reach, or that changes what watches it")
{
    file_folder const folder;
    struct guarded {
        std::string_view drive;
        unsigned unit;
        std::vector<std::string_view> names;
    };
    // By the manuals: each drive's place on its lines, the time-out of its link, and what it does at a loss or a fault.
    guarded const all[]{
        {"atv320", 7, {"ADD", "TBR", "TFO", "TTO", "SLL", "COL", "ADCO", "BDCO", "AMOC", "OPL", "OLL", "ETF"}},
        {"atv12", 7, {"ADD", "TBR", "TFO", "TTO", "SLL", "EPL", "LFL1", "TOL", "PST"}},
        {"atv310", 7, {"ADD", "TBR", "TFO", "TTO", "SLL"}},
        {"atv310_2026", 7, {"ADD", "TBR", "TFO", "TTO", "SLL"}},
        {"atv28", 7, {"ADD", "BDR", "OPL", "IPL", "STP"}}};
    for (guarded const& each : all) {
        std::string const text = with(with(whole, "ATV320", each.drive), "\"RFR\", \"ETA.fault\", \"LFT\"", "\"RFR\"");
        CHECK(folder.refusal(text) == "taken");
        for (std::string_view const name : each.names) {
            std::string const why = folder.refusal(with(text, "ITH", name));
            CAPTURE(each.drive, name, why);
            CHECK(why.starts_with("gateway.toml:26:13: " + std::string{name} + " cannot be a setting: "));
        }
    }
}

TEST_CASE("a line is another one where its words, or those of its register files, are others")
{
    file_folder folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    std::string const before = folder.read(right).lines[0]->said;

    CHECK(folder.read(with(right, "hall3", "hall4")).lines[0]->said == before);
    CHECK(folder.read(with(right, "baud = 38400", "# at last\nbaud = 38_400")).lines[0]->said == before);
    CHECK(folder.read(with(right, "baud = 38400", "baud = 9600")).lines[0]->said != before);
    CHECK(folder.read(with(right, "every = 2.0", "every = 2.5")).lines[0]->said != before);
    folder.write("meter.toml", std::string{meter} + "# more\n");
    CHECK(folder.read(right).lines[0]->said != before);
}

TEST_CASE("a password is read from a file that not everybody reads")
{
    file_folder const folder;
    std::string const file = folder.write("password", "se cret\n");
    std::string const text = with(with(whole, "settings = [\"ITH\"]\n", ""), "host = \"127.0.0.1\"",
                                  "user = \"u\"\npassword_file = \"password\"");
    std::string const name = folder.write("gateway.toml", text);
    std::string const place = name + ":5:17: password_file: ";

    fs::permissions(file, fs::perms::owner_read | fs::perms::group_read);
    CHECK(password_of(gateway_file_at(name).broker) == "se cret");
    for (fs::perms const each : {fs::perms::others_read, fs::perms::others_write}) {
        fs::permissions(file, fs::perms::owner_read | each);
        CHECK_THROWS_WITH(gateway_file_at(name),
                          place + file + ": anybody may read or change this password; say chmod o= " + file);
    }
    fs::remove(file);
    CHECK_THROWS_WITH(gateway_file_at(name), place + file + ": No such file or directory");
    folder.write("password", "two\nlines\n");
    fs::permissions(file, fs::perms::owner_read);
    CHECK_THROWS_WITH(gateway_file_at(name),
                      place + file + ": it holds the password alone, on one line of at most 1024 bytes");
}

TEST_CASE("what is no regular file, or waits for more, is refused at once with the key that names it")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    std::string const pipe = folder.path("pipe");
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    folder.write("pem", "x");
    fs::permissions(folder.path("pem"), fs::perms::owner_read);
    std::vector<std::pair<std::string, std::string>> wrong{{pipe, "is a pipe, no regular file"},
                                                           {"/dev/zero", "is a device, no regular file"},
                                                           {folder.path(""), "is a directory, no regular file"},
                                                           {folder.path("nothing"), "No such file or directory"}};
    if (::access("/proc/kmsg", R_OK) == 0) { // by root's programs alone
        wrong.emplace_back("/proc/kmsg", "");
    }
    for (auto const& [file, why] : wrong) {
        CAPTURE(file);
        CHECK(folder.refusal(with(right, "\"meter.toml\"", '"' + file + '"'))
                  .starts_with("gateway.toml:17:8: " + file + ": " + why));
        if (file != folder.path("nothing")) {
            CHECK_THROWS_WITH(gateway_file_at(file), Catch::Matchers::StartsWith(file + ": " + why));
        }
        for (std::string const key : {"password_file", "ca_file", "cert_file", "key_file"}) {
            std::string keys = "user = \"u\"";
            for (std::string const each : {"ca_file", "cert_file", "key_file"}) {
                keys += each == key ? "" : "\n" + each + " = \"pem\"";
            }
            std::string const name =
                folder.write("gateway.toml", with(right, "host = \"127.0.0.1\"", key + " = \"" + file + "\"\n" + keys));
            CAPTURE(key);
            CHECK_THROWS_WITH(gateway_file_at(name),
                              Catch::Matchers::StartsWith(name + ":4:" + std::to_string(key.size() + 4) + ": " + key +
                                                          ": " + file + ": " + why));
        }
    }
    std::string const name =
        folder.write("gateway.toml",
                     with(right, "host = \"127.0.0.1\"", "ca_file = \"pem\"\ncert_file = \"pem\"\nkey_file = \"pem\""));
    CHECK_NOTHROW(gateway_file_at(name));
    fs::permissions(folder.path("pem"), fs::perms::owner_read | fs::perms::others_read);
    CHECK_THROWS_WITH(gateway_file_at(name),
                      Catch::Matchers::StartsWith(name + ":6:12: key_file: " + folder.path("pem") +
                                                  ": anybody may read or change this key"));
}

TEST_CASE("a line that answers clients says which units they may read")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    auto const with_serve = [&right](std::string const& keys) {
        return with(right, "rs485 = false\n", "[line.serve]\n" + keys + "\n");
    };
    gateway_plan const plan =
        folder.read(with_serve("units = \"3,7-9\"\nlisten = \"mbap://0.0.0.0:1503\"\nfrom = [\"10.0.0.0/8\"]"));
    REQUIRE(plan.lines[0]->serve);
    CHECK(plan.lines[0]->serve->units == "3,7-9");
    CHECK(plan.lines[0]->serve->listen == std::vector<std::string>{"mbap://0.0.0.0:1503"});
    CHECK(plan.lines[0]->serve->from == std::vector<std::string>{"10.0.0.0/8"});
    CHECK(plan.lines[0]->said != folder.read(right).lines[0]->said);
    bool const is_told =
        std::ranges::any_of(plan.notes, [](auto const& each) { return each.find("units 3,7-9") != each.npos; });
    CHECK(is_told);
    CHECK(folder.read(with_serve("units = \"3\"")).lines[0]->serve->listen.front() == "mbap://127.0.0.1:1502");
    CHECK_FALSE(folder.read(right).lines[0]->serve);

    auto const warns = [&](std::string const& keys) {
        return std::ranges::any_of(
            folder.read(with_serve("units = \"3\"\n" + keys)).notes,
            [](std::string const& note) { return note.find(": say from = ") != std::string::npos; });
    };
    for (std::string const place : {"0.0.0.0:1502", "192.168.1.7:1502", "[::]:1502"}) {
        CHECK(warns("listen = \"mbap://" + place + "\""));
        CHECK_FALSE(warns("listen = \"mbap://" + place + "\"\nfrom = [\"192.168.1.0/24\"]"));
        for (std::string const all :
             {"\"0.0.0.0/0\"", "\"::/0\"", "\"10.0.0.7\", \"0.0.0.0/0\"", "\"::ffff:0:0/96\""}) {
            CHECK(warns("listen = \"mbap://" + place + "\"\nfrom = [" + all + "]"));
        }
    }
    for (std::string const keys : {"", "listen = \"mbap://127.0.0.1:1503\"", "listen = \"tcp://[::1]:1502\"",
                                   "listen = \"mbap://localhost:1502\""}) {
        CHECK_FALSE(warns(keys));
    }

    for (auto const& [keys, why] : std::vector<std::pair<std::string, std::string>>{
             {"", "13:1: units is missing"},
             {"units = \"\"", "14:9: units is empty"},
             {"units = 3", "14:9: "},
             {"units = \"3\"\nwrite = true", "15:9: clients of a gateway's line read"},
             {"units = \"3\"\nwrites = true", "15:1: "},
             {"units = \"300\"", "14:9: units: '300' in '300' is no address of a unit: 1 to 247\n"},
             {"units = \"0,3\"", "14:9: units: '0' in '0,3' is no address of a unit: 1 to 247\n"},
             {"units = \"9-3\"", "14:9: units: '9-3' in '9-3' is neither"},
             {"units = \"3\"\nlisten = \"nowhere\"", "15:10: listen: "},
             {"units = \"3\"\nlisten = \"mbap://meter.example.org:1502\"",
              "15:10: listen: port mbap://meter.example.org:1502: who listens names an address of this machine"},
             {"units = \"3\"\nlisten = \"mbap://127.0.0.1\"",
              "15:10: listen: port mbap://127.0.0.1: no port is named; it is like mbap://127.0.0.1:1502"},
             {"units = \"3\"\nlisten = \"mbap://localhost:0\"", "15:10: listen: port 0 is any that is free"},
             {"units = \"3\"\nlisten = \"mbap://224.0.0.1:1502\"",
              "15:10: listen: port mbap://224.0.0.1:1502: this is an address of many machines at once"},
             {"units = \"3\"\nlisten = \"mbap://[ff02::1]:1502\"",
              "15:10: listen: port mbap://[ff02::1]:1502: this is an address of many machines at once"},
             {"units = \"3\"\nlisten = \"mbap://0.0.0.0:1502\"\nfrom = [\"fd00::/8\", \"::1\"]",
              "16:8: from: nobody could connect to mbap://0.0.0.0:1502, which is of IPv4, from addresses of IPv6 "
              "alone"},
             {"units = \"3\"\nfrom = [\"fd00::/8\"]",
              "15:8: from: nobody could connect to mbap://127.0.0.1:1502 from there: this machine alone reaches it, by "
              "127.0.0.1; name that, or listen at 0.0.0.0, or at an address of this machine that they reach\n"},
             {"units = \"3\"\nfrom = [\"10.0.0.0/8\", \"192.168.1.7\"]",
              "15:8: from: nobody could connect to mbap://127.0.0.1:1502 from there: this machine alone reaches it"},
             {"units = \"3\"\nlisten = \"tcp://[::1]:1502\"\nfrom = [\"fd00::/8\"]",
              "16:8: from: nobody could connect to tcp://[::1]:1502 from there: this machine alone reaches it, by ::1; "
              "name that, or listen at [::], or at"},
             {"units = \"3\"\nlisten = \"mbap://[fd00::1]:1502\"\nfrom = [\"10.0.0.0/8\"]",
              "16:8: from: nobody could connect to mbap://[fd00::1]:1502, which is of IPv6, from addresses of IPv4 "
              "alone"},
             {"units = \"3\"\nfrom = \"10.0.0.1\"", "15:8: from is a list"},
             {"units = \"3\"\nfrom = [\"10.0.0.0/8\",\n\"10.0.0.1/8\"]", "16:1: from 10.0.0.1/8"},
             {"units = \"3\"\nfrom = [\"10.0.0.0/8\",\n\"10.0.0.0/024\"]",
              "16:1: from 10.0.0.0/024: it is an address, 10.0.0.7, or those that begin alike, 192.168.1.0/24 or "
              "fd00::/8: a length in decimal, without a zero in front,"}}) {
        std::string const found = folder.refusal(with_serve(keys)) + '\n';
        CAPTURE(keys, found);
        CHECK(found.starts_with("gateway.toml:" + why));
    }
    for (std::string const keys :
         {"listen = \"mbap://0.0.0.0:1502\"\nfrom = [\"fd00::/8\", \"10.0.0.0/8\"]",
          "listen = \"mbap://[::]:1502\"\nfrom = [\"fd00::/8\"]",
          "listen = \"mbap://[::]:1502\"\nfrom = [\"10.0.0.0/8\"]", "from = [\"10.0.0.0/8\", \"127.0.0.1\"]",
          "from = [\"127.0.0.0/8\"]", "listen = \"mbap://[::1]:1502\"\nfrom = [\"::1\"]"}) {
        CAPTURE(keys);
        CHECK(folder.refusal(with_serve("units = \"3\"\n" + keys)) == "taken");
    }
    CHECK(folder.refusal(with(right, "rs485 = false\n", "serve = 3\n")) ==
          "gateway.toml:13:9: serve is a table: its keys stand in lines behind [line.serve]");
}

TEST_CASE("two lines listen at two places")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    auto const two = [&right](std::string const& one, std::string const& other) {
        return with(right, "rs485 = false\n", "[line.serve]\nunits = \"3\"\nlisten = \"" + one + "\"\n") +
               "[[line]]\nname = \"line2\"\nport = \"sim:atv320:8\"\n[line.serve]\nunits = \"3\"\nlisten = \"" + other +
               "\"\n[[line.device]]\nname = \"m\"\nunit = 3\nfile = \"meter.toml\"\n";
    };
    std::pair<std::string, std::string> const same[]{{"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1502"},
                                                     {"mbap://127.0.0.1:1502", "tcp://localhost:1502"},
                                                     {"mbap://0.0.0.0:1502", "mbap://127.0.0.1:1502"},
                                                     {"mbap://192.168.1.7:1502", "mbap://0.0.0.0:1502"},
                                                     {"mbap://[::]:1502", "mbap://127.0.0.1:1502"},
                                                     {"mbap://[::]:1502", "mbap://0.0.0.0:1502"},
                                                     {"mbap://[::1]:1502", "mbap://[0:0:0:0:0:0:0:1]:1502"},
                                                     {"mbap://[::ffff:127.0.0.1]:1502", "tcp://127.0.0.1:1502"}};
    for (auto const& [one, other] : same) {
        std::string const found = folder.refusal(two(one, other));
        CAPTURE(one, other, found);
        CHECK(found.ends_with(": listen: " + other + " is taken: the line 'line1' listens at " + one +
                              "; say another port"));
    }
    std::pair<std::string, std::string> const others[]{{"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1503"},
                                                       {"mbap://127.0.0.1:1502", "mbap://192.168.1.7:1502"},
                                                       {"mbap://0.0.0.0:1502", "mbap://[::1]:1502"},
                                                       {"mbap://[fe80::1%eth0]:1502", "mbap://[fe80::1%eth1]:1502"}};
    for (auto const& [one, other] : others) {
        CAPTURE(one, other);
        CHECK_NOTHROW(folder.read(two(one, other)));
    }
}

TEST_CASE("a line does not ask itself")
{
    file_folder const folder;
    std::string const right = with(with(whole, "settings = [\"ITH\"]\n", ""), "rs485 = false\n", "");
    auto const refusal = [&](std::string const& port, std::string const& listen) {
        return folder.refusal(with(with(right, "sim:atv320:7", port), "[[line.device]]",
                                   "[line.serve]\nunits = \"3\"\nlisten = \"" + listen + "\"\n[[line.device]]"));
    };
    std::pair<std::string, std::string> const same[]{
        {"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1502"}, {"mbap://127.0.0.1:1502", "mbap://0.0.0.0:1502"},
        {"tcp://LocalHost:1502", "mbap://127.0.0.1:1502"},  {"mbap://localhost:1502", "tcp://[::1]:1502"},
        {"mbap://[::1]:1502", "mbap://[::]:1502"},          {"mbap://0.0.0.0:1502", "mbap://127.0.0.1:1502"},
        {"mbap://192.168.1.7", "mbap://192.168.1.7:502"}};
    for (auto const& [port, listen] : same) {
        std::string const found = refusal(port, listen);
        CAPTURE(port, listen, found);
        CHECK(found.starts_with("gateway.toml:15:10: listen: " + listen + " is the line's own port, " + port));
    }
    std::pair<std::string, std::string> const others[]{{"mbap://127.0.0.1:1503", "mbap://127.0.0.1:1502"},
                                                       {"mbap://192.168.1.7:1502", "mbap://0.0.0.0:1502"},
                                                       {"mbap://meter:1502", "mbap://0.0.0.0:1502"},
                                                       {"mbap://[::1]:1502", "mbap://127.0.0.1:1502"},
                                                       {"mbap://[::1]:1502", "mbap://0.0.0.0:1502"}};
    for (auto const& [port, listen] : others) {
        CAPTURE(port, listen);
        CHECK(refusal(port, listen) == "taken");
    }
}

TEST_CASE("lines do not ask each other in a ring")
{
    file_folder const folder;
    struct two_ends {
        std::string port;
        std::string listen;
    };
    auto const refusal = [&folder](std::vector<two_ends> const& lines) {
        std::string text = "site = \"s\"\ngateway = \"g\"\n";
        for (std::size_t i = 0; i < lines.size(); ++i) {
            text +=
                "[[line]]\nname = \"l" + std::to_string(i + 1) + "\"\nport = \"" + lines[i].port + "\"\n" +
                (lines[i].listen.empty() ? "" : "[line.serve]\nunits = \"3\"\nlisten = \"" + lines[i].listen + "\"\n") +
                "[[line.device]]\nname = \"m\"\nunit = 3\nfile = \"meter.toml\"\n";
        }
        return folder.refusal(text);
    };
    std::string const meter_port = "mbap://meter:502";
    CHECK(
        refusal({{"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1501"}, {"tcp://localhost:1501", "tcp://0.0.0.0:1502"}}) ==
        "gateway.toml:15:8: port: these lines ask each other, and none of them a device: 'l2' asks "
        "tcp://localhost:1501, "
        "where 'l1' listens, 'l1' asks mbap://127.0.0.1:1502, where 'l2' listens; name the port of a device in one of "
        "them");
    // Of three and of four, closed by the last one; the line between them is none of theirs.
    CHECK(refusal({{"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1501"},
                   {"mbap://127.0.0.1:1503", "mbap://127.0.0.1:1502"},
                   {meter_port, ""},
                   {"mbap://127.0.0.1:1501", "mbap://127.0.0.1:1503"}})
              .starts_with("gateway.toml:32:8: port: these lines ask each other, and none of them a device: 'l4' asks "
                           "mbap://127.0.0.1:1501, where 'l1' listens, 'l1' asks"));
    CHECK(refusal({{"mbap://127.0.0.1:1504", "mbap://127.0.0.1:1501"},
                   {"mbap://127.0.0.1:1501", "mbap://127.0.0.1:1502"},
                   {"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1503"},
                   {"mbap://127.0.0.1:1503", "mbap://127.0.0.1:1504"}})
              .starts_with("gateway.toml:35:8: port: these lines ask each other"));
    // One that asks them is not among them.
    CHECK(refusal({{"mbap://localhost:1501", ""},
                   {"mbap://[::1]:1502", "mbap://127.0.0.1:1501"},
                   {"mbap://127.0.0.1:1501", "mbap://[::1]:1502"}})
              .starts_with("gateway.toml:22:8: port: these lines ask each other, and none of them a device: 'l3' asks "
                           "mbap://127.0.0.1:1501, where 'l2' listens, 'l2' asks"));
    // However its host is written.
    for (std::string const host : {"127.1", "0x7f000001", "2130706433", "localhost.", "0"}) {
        INFO(host);
        CHECK(refusal({{"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1501"},
                       {"mbap://" + host + ":1501", "mbap://127.0.0.1:1502"}})
                  .starts_with("gateway.toml:15:8: port: these lines ask each other"));
    }
    // By a name that is two addresses.
    CHECK(refusal({{meter_port, "mbap://127.0.0.1:1501"},
                   {"mbap://127.0.0.1:1503", "mbap://[::1]:1501"},
                   {"mbap://localhost:1501", "mbap://127.0.0.1:1503"}})
              .starts_with("gateway.toml:25:8: port: these lines ask each other"));
    // Through another one to a device, and a line of another machine.
    for (std::vector<two_ends> const& right :
         {std::vector<two_ends>{{meter_port, "mbap://127.0.0.1:1501"},
                                {"mbap://127.0.0.1:1501", "mbap://127.0.0.1:1502"},
                                {"mbap://127.0.0.1:1502", "mbap://127.0.0.1:1503"}},
          std::vector<two_ends>{{"mbap://192.168.1.7:1502", "mbap://127.0.0.1:1501"},
                                {"mbap://127.0.0.1:1501", "mbap://0.0.0.0:1502"}}}) {
        CHECK(refusal(right) == "taken");
    }
}

TEST_CASE("where a file has no time-out it is one that a change is told with in time")
{
    file_folder const folder;
    std::string const text = with(with(whole, "settings = [\"ITH\"]\n", ""), "timeout = 0.2\n", "");
    CHECK(folder.read(text).lines[0]->choices.response_timeout == 0.5);
    for (std::string const port : {"mbap://127.0.0.1:1502", "tcp://127.0.0.1:4001"}) {
        CHECK(folder.read(with(text, "sim:atv320:7", port)).lines[0]->choices.response_timeout == 1.0);
    }
}

TEST_CASE("a broker's host is a name or an address")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    for (std::string const host : {"broker", "broker.example.org", "broker.example.org.", "a_b", "192.0.2.7", "::1",
                                   "fe80::1%eth0", "3com.example"}) {
        CAPTURE(host);
        CHECK(folder.refusal(with(right, "127.0.0.1", host)) == "taken");
    }
    for (std::string const host : {"mqtt://broker", "broker:1883", "broker/x", "a b", "-a", "a..b", ".", "1.2.3",
                                   "256.1.1.1", "[::1]", "1::2::3", "bÃ¶se"}) {
        CAPTURE(host);
        CHECK(folder.refusal(with(right, "127.0.0.1", host))
                  .starts_with("gateway.toml:4:8: host is a name or an address"));
    }
}

TEST_CASE("each of 3000 drawn changes of a right file is taken, or refused with a place")
{
    file_folder const folder;
    std::string const right = with(whole, "settings = [\"ITH\"]\n", "");
    rtuwire::sim::random_source draws{7};
    unsigned refused = 0;
    for (unsigned i = 0; i < 3'000; ++i) {
        std::string text = right;
        for (std::uint32_t changes = 1 + draws.below(3); changes > 0; --changes) {
            std::size_t const at = draws.below(static_cast<std::uint32_t>(text.size()));
            switch (draws.below(4)) {
            case 0: text[at] = static_cast<char>(draws.below(256)); break;
            case 1: text.erase(at, 1 + draws.below(20)); break;
            case 2:
                text.insert(at, right, draws.below(static_cast<std::uint32_t>(right.size())), 1 + draws.below(40));
                break;
            default: text.insert(at, 1, "\"[]{}=.,#\n0"[draws.below(12)]); break;
            }
        }
        std::string const why = folder.refusal(text);
        CAPTURE(text, why);
        CHECK((why == "taken" or why.starts_with("gateway.toml:") or why.starts_with("meter.toml:")));
        refused += why == "taken" ? 0U : 1U;
    }
    CHECK(refused > 1'500);
    CHECK(refused < 3'000);
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lines in threads of their own, on simulated ports: values, settings, others in a place, a reload.
#include "../../tools/gateway/running_line.hpp"

#include "../../tools/gateway/opened_line.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include <rtuwire/port.hpp>

#include "line/time_text.hpp"
#include "support/catch.hpp"
#include "support/soon.hpp"

#include "gateway/scratch_folder.hpp"

using namespace tool;
using namespace tool::gateway;
using gateway_test::scratch_folder;

namespace {

constexpr std::string_view served_meter = R"(
[[register]]
name = "voltage"
space = "input"
address = 0
type = "f32"
unit = "V"
simulated = 230.5

[[register]]
name = "temperature"
address = 10
type = "i16"
scale = 0.1
unit = "degC"
invalid = 0x7FFF
simulated = 3276.7

[[register]]
name = "set_point"
address = 40
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = 5
max = 30
simulated = 20

[[register]]
name = "wide"
address = 50
type = "u32"
access = "write"
simulated = 1

[[register]]
name = "lamp"
space = "coil"
address = 4
access = "write"

[[register]]
name = "speed"
address = 60
access = "write"
max = 10
simulated = 12

[[register]]
name = "mode"
address = 61
access = "write"
choices = { off = 0, heat = 1 }
simulated = 7
)";

constexpr std::size_t voltage = 0, temperature = 1, set_point = 2, wide = 3, lamp = 4, speed = 5, mode = 6;

std::string line_text(std::string const& name, std::string const& port, std::string const& devices)
{
    return "[[line]]\nname = \"" + name + "\"\nport = \"" + port + "\"\ntimeout = 0.3\nretries = 0\n" + devices;
}

std::string device_text(std::string const& name, unsigned unit, std::string const& rest)
{
    return "[[line.device]]\nname = \"" + name + "\"\nunit = " + std::to_string(unit) + "\nevery = 0.1\n" + rest + '\n';
}

/// Lines of a folder of their own; writes are noted there.
class lines_of_folder {
public:
    explicit lines_of_folder(bool may_write = true) : lines{may_write, stored, [this] { ++news; }}
    {
        file = folder.write("meter.toml", served_meter);
        ::setenv("XDG_STATE_HOME", folder.path("").c_str(), 1);
    }

    gateway_plan plan(std::string const& text) const
    {
        return read_gateway_file(folder.path("gateway.toml"), "site = \"s\"\ngateway = \"g\"\n" + text);
    }

    running_line& only() { return *lines.all().at(0); }

    scratch_folder folder{};
    std::string file{};
    std::atomic<unsigned long> news{0};
    stored_writes stored{folder.path("state"), "/etc/one.toml", unix_now(), stored_writes::clock::now()};
    running_lines lines;
};

/// Looks until something is so; false where that takes until the limit of all tests.
template <typename Condition> bool comes(Condition condition)
{
    rtuwire::instant const until = rtuwire::test::soon();
    while (not condition()) {
        if (rtuwire::reached(rtuwire::steady_now(), until)) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    return true;
}

setting_answer answer_of(running_line& line, std::size_t value, std::string const& text)
{
    line.submit({0, value, text, unix_now() + 30'000'000, text});
    std::vector<setting_answer> all;
    CHECK(comes([&] {
        all = line.take_answers();
        return not all.empty();
    }));
    return all.empty() ? setting_answer{} : all[0];
}

} // namespace

TEST_CASE("a device of a register file is read on its port, and what means no value is none")
{
    lines_of_folder on;
    on.lines.apply(on.plan(line_text("l1", "sim:" + on.file + ":3", device_text("m", 3, "file = \"./meter.toml\""))));
    running_line& line = on.only();
    REQUIRE(comes([&] { return line.device(0)->values[voltage].state == value_state::valid; }));
    device_slot::content const now = line.device(0);
    CHECK(now->is_available);
    CHECK(std::get<double>(now->values[voltage].value) == 230.5);
    CHECK(now->values[temperature].state == value_state::invalid);
    CHECK(now->values[temperature].why == "no value (0x7FFF)");
    CHECK(std::holds_alternative<std::monostate>(now->values[temperature].value));
    CHECK(std::get<double>(now->values[set_point].value) == 20.0);
    CHECK(std::get<bool>(now->values[lamp].value) == false);
    for (std::size_t const outside : {speed, mode}) {
        CHECK(now->values[outside].state == value_state::invalid);
        CHECK(std::holds_alternative<std::monostate>(now->values[outside].value));
    }
    CHECK(now->values[speed].why.find("outside its limits") != std::string::npos);
    CHECK(now->values[mode].why.find("none of its choices") != std::string::npos);
    CHECK(now->values[voltage].time + 60'000'000 > unix_now());
    CHECK(comes([&] { return line.device(0)->seq > now->seq + 3; }));
    CHECK(line.state().is_up);
    CHECK(line.state().requests > 0);
    CHECK(on.news > 3);
}

TEST_CASE("settings are judged as write judges them, written once and read back")
{
    lines_of_folder on;
    on.lines.apply(on.plan(
        line_text("l1", "sim:" + on.file + ":3",
                  device_text("m", 3, "file = \"./meter.toml\"\nsettings = [\"set_point\", \"wide\", \"lamp\"]"))));
    running_line& line = on.only();
    REQUIRE(comes([&] { return line.device(0)->is_available; }));

    setting_answer const done = answer_of(line, set_point, "21.5");
    CHECK(done.result == setting_result::done);
    CHECK(done.id == "21.5");
    CHECK(done.why.empty());
    CHECK(comes([&] { return line.device(0)->values[set_point].value == cell{21.5}; }));
    CHECK(answer_of(line, wide, "4000000000").result == setting_result::done);
    CHECK(answer_of(line, lamp, "1").result == setting_result::done);
    CHECK(comes([&] { return line.device(0)->values[lamp].value == cell{true}; }));

    setting_answer const equal = answer_of(line, set_point, "21.5");
    CHECK(equal.result == setting_result::done);
    CHECK(equal.why.find("already, and is not written again") != std::string::npos);
    for (std::string const text :
         {"31", "4.9", "1e9", "warm", "", "21.5,3", "21.5 m==", "\n22", "#225", "0x00E1", "0XE1", " #225", "+0xE1"}) {
        CAPTURE(text);
        CHECK(answer_of(line, set_point, text).result == setting_result::refused);
    }
    CHECK(line.device(0)->values[set_point].value == cell{21.5});
    CHECK(std::filesystem::exists(on.folder.path("rtuwire/writes.log")));
}

TEST_CASE("a setting that expires behind its last look, before its frame leaves, is not written")
{
    lines_of_folder on;
    gateway_plan const plan = on.plan(line_text(
        "l1", "sim:" + on.file + ":3", device_text("m", 3, "file = \"./meter.toml\"\nsettings = [\"set_point\"]")));
    opened_line line{*plan.lines[0], [](std::string const&) {}};
    line.open();
    REQUIRE(line.identify(0, false).what == device_finding::kind::right);
    waiting_setting setting{{0, set_point, "21.5", unix_now() + 30'000'000}, line.now() + std::chrono::seconds{30}};
    unsigned looks = 0;
    auto const written = [&](std::function<void()> const& behind_look) {
        auto outcome = line.write(setting, false, [&]() -> std::optional<setting_outcome> {
            ++looks;
            behind_look();
            return std::nullopt;
        });
        REQUIRE(outcome);
        return *std::move(outcome);
    };
    waiting_setting const fresh = setting;
    for (bool const by_calendar : {true, false}) {
        CAPTURE(by_calendar);
        setting = fresh;
        setting_outcome const late = written([&] {
            setting.request.expires = by_calendar ? unix_now() : setting.request.expires;
            setting.until = by_calendar ? setting.until : line.now();
        });
        CHECK(late.result == setting_result::expired);
        CHECK_FALSE(late.was_sent);
    }
    setting = fresh;
    setting.request.text = "20"; // it holds that
    CHECK(written([] {}).why.find("already") != std::string::npos);
    setting = fresh;
    CHECK(written([] {}).result == setting_result::done); // and the line goes on
    CHECK(looks == 3);
}

TEST_CASE("a drive is identified before its values count, and another one in its place is marked")
{
    lines_of_folder on;
    on.lines.apply(on.plan(line_text("l1", "sim:atv320:7,atv12:8",
                                     device_text("right", 7, "drive = \"atv320\"\nfeeds_supervision = true") +
                                         device_text("wrong", 8, "drive = \"atv320\"\nfeeds_supervision = true"))));
    running_line& line = on.only();
    REQUIRE(comes([&] { return line.device(0)->is_available; }));
    REQUIRE(comes([&] { return line.device(1)->why.find("calls itself") != std::string::npos; }));
    CHECK(line.device(1)->why.find("the file says that it is an atv320") != std::string::npos);
    CHECK_FALSE(line.device(1)->is_available);
    for (slot_value const& each : line.device(1)->values) {
        CHECK(each.state == value_state::not_read);
    }
    CHECK(line.device(0)->values[0].state == value_state::valid);
}

TEST_CASE("a setting of a drive is checked by its table")
{
    lines_of_folder on;
    on.lines.apply(on.plan(line_text("l1", "sim:atv320:7",
                                     device_text("fan", 7,
                                                 "drive = \"atv320\"\nregisters = [\"RFR\"]\nsettings = [\"ITH\", "
                                                 "\"NRD\"]\nfeeds_supervision = true"))));
    running_line& line = on.only();
    REQUIRE(comes([&] { return line.device(0)->is_available; }));
    constexpr std::size_t ith = 1, nrd = 2;
    cell const before = line.device(0)->values[ith].value;
    cell const shown = line.device(0)->values[nrd].value;
    for (std::string const text : {"7000", "-1", "#30", "0x1E", "1.23456"}) {
        setting_answer const wrong = answer_of(line, ith, text);
        CAPTURE(text, wrong.why);
        CHECK(wrong.result == setting_result::refused);
    }
    CHECK(answer_of(line, nrd, "#1").result == setting_result::refused);
    CHECK(line.device(0)->values[ith].value == before);
    CHECK(line.device(0)->values[nrd].value == shown);
    double const next = std::get<double>(before) - 0.1;
    setting_answer const done = answer_of(line, ith, std::to_string(next).substr(0, 4));
    CAPTURE(done.why, next);
    CHECK(done.result == setting_result::done);
    CHECK(comes([&] { return line.device(0)->values[ith].value != before; }));
}

TEST_CASE("a drive that is called a meter is not read on")
{
    lines_of_folder on;
    std::string const file = "file = \"./meter.toml\"";
    on.lines.apply(
        on.plan(line_text("l1", "sim:atv320:7,atv28:8",
                          device_text("a", 7, file) + device_text("b", 8, file) + device_text("c", 9, file))));
    running_line& line = on.only();
    for (std::size_t const which : {0U, 1U}) {
        REQUIRE(comes([&] { return line.device(which)->why.find("feeds its supervision") != std::string::npos; }));
    }
    REQUIRE(comes([&] { return line.device(2)->why.find("no response") != std::string::npos; }));
}

TEST_CASE("a line that did not change goes on behind a reload, and the others end and begin")
{
    lines_of_folder on;
    std::string const first = line_text("l1", "sim:" + on.file + ":3", device_text("m", 3, "file = \"./meter.toml\""));
    std::string const second = line_text("l2", "sim:" + on.file + ":4", device_text("n", 4, "file = \"./meter.toml\""));
    on.lines.apply(on.plan(first + second));
    running_line const* const before = on.lines.all()[0].get();
    REQUIRE(comes(
        [&] { return on.lines.all()[0]->device(0)->is_available and on.lines.all()[1]->device(0)->is_available; }));
    std::uint64_t const seq = before->device(0)->seq;

    std::string const changed =
        line_text("l2", "sim:" + on.file + ":5", device_text("n", 5, "file = \"./meter.toml\""));
    on.lines.apply(on.plan(changed + first));
    REQUIRE(on.lines.all().size() == 2);
    CHECK(on.lines.all()[1].get() == before);
    CHECK(on.lines.all()[1]->state().opened == 1);
    CHECK(comes([&] { return before->device(0)->seq > seq; }));
    CHECK(comes([&] { return on.lines.all()[0]->device(0)->is_available; }));
    CHECK(on.lines.all()[0]->plan().devices[0].unit.unit.byte() == 5);

    on.lines.apply(on.plan(first));
    CHECK(on.lines.all().size() == 1);
    CHECK(on.lines.all()[0].get() == before);
}

TEST_CASE("each setting is answered once, also where its line ends before, while or after it is written")
{
    for (unsigned const wait : {0U, 1U, 2U, 5U, 20U}) {
        CAPTURE(wait);
        lines_of_folder on;
        std::string const said = line_text("l1", "sim:" + on.file + ":3",
                                           device_text("m", 3, "file = \"./meter.toml\"\nsettings = [\"set_point\"]"));
        on.lines.apply(on.plan(said));
        running_line& line = on.only();
        REQUIRE(comes([&] { return line.device(0)->is_available; }));
        line.submit({0, set_point, "21.5", unix_now() + 30'000'000, "id"});
        std::this_thread::sleep_for(std::chrono::milliseconds{wait});
        std::vector<setting_answer> answers;
        on.lines.apply({}, [&](running_line& gone) { answers = gone.take_answers(); });
        CHECK(on.lines.all().empty());
        REQUIRE(answers.size() == 1);
        CHECK(answers[0].id == "id");
        CHECK((answers[0].result == setting_result::done or answers[0].result == setting_result::refused));
    }
}

TEST_CASE("a port that is not there is told, tried again, and taken when it comes")
{
    lines_of_folder on;
    std::string const device = on.folder.path("adapter");
    on.lines.apply(on.plan(line_text("l1", device, device_text("m", 3, "file = \"./meter.toml\""))));
    running_line& line = on.only();
    REQUIRE(comes([&] { return not line.state().why.empty() and line.state().why != "not opened yet"; }));
    CHECK(line.state().why.find(device) != std::string::npos);
    CHECK_FALSE(line.state().is_up);
    CHECK_FALSE(line.device(0)->is_available);

    rtuwire::pseudo_terminal adapter;
    REQUIRE(adapter.open());
    std::filesystem::create_symlink(adapter.path(), device);
    CHECK(comes([&] { return line.state().is_up; }));
    CHECK(comes([&] { return line.state().silences > 0; })); // nobody is there
    adapter = rtuwire::pseudo_terminal{};
    std::filesystem::remove(device);
    CHECK(comes([&] { return not line.state().is_up; }));
    CHECK(line.device(0)->values[voltage].state == value_state::not_read);
}

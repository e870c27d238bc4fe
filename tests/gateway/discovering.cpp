// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What Home Assistant is told of a value. tests/gateway has a validator of its published schema besides.
#include "messages/discovery.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "gateway/devices.hpp"
#include "messages/topics.hpp"
#include "support/catch.hpp"

namespace {

using namespace tool::gateway;
using namespace gateway_test;
using nlohmann::json;

struct tried_value {
    tried_value()
    {
        plan.site = "hall3";
        plan.gateway = "g1";
        line.name = "line1";
    }

    json message(bool may_write = false)
    {
        retained_message const made = discovery_of(plan, line, device, value, may_write);
        topic = made.topic;
        CHECK(topic == discovery_topic(plan, line, device, value, may_write));
        return json::parse(made.text);
    }

    gateway_plan plan;
    line_plan line;
    device_plan device{device_named("meter1")};
    device_value value{value_named("voltage_l1", "V")};
    std::string topic;
};

} // namespace

TEST_CASE("a measured value is a sensor with its unit, its class and three ways of being away")
{
    tried_value one;
    one.value.every = 1.0;
    json const said = one.message();
    CHECK(one.topic == "homeassistant/sensor/hall3_g1_line1_meter1/voltage_l1/config");
    CHECK(said["unique_id"] == "rtuwire_hall3_g1_line1_meter1_voltage_l1");
    CHECK(said["object_id"] == "hall3_g1_line1_meter1_voltage_l1");
    CHECK(said["default_entity_id"] == "sensor.hall3_g1_line1_meter1_voltage_l1");
    CHECK(said["state_topic"] == topics{"hall3", "g1"}.state("line1", "meter1"));
    CHECK(said["unit_of_measurement"] == "V");
    CHECK(said["device_class"] == "voltage");
    CHECK(said["state_class"] == "measurement");
    CHECK(said["suggested_display_precision"] == 1);
    CHECK(said["expire_after"] == 5);
    CHECK(said["availability_mode"] == "all");
    CHECK(said["availability"] == json::array({{{"topic", "rtuwire/hall3/g1/status"}},
                                               {{"topic", "rtuwire/hall3/g1/line1/availability"}},
                                               {{"topic", "rtuwire/hall3/g1/line1/meter1/availability"}}}));
    CHECK(said["device"]["identifiers"] == json::array({"rtuwire_hall3_g1_line1_meter1"}));
    CHECK(said["device"]["name"] == "meter1");
    CHECK_FALSE(said.contains("command_topic"));
    CHECK_FALSE(said.contains("entity_category"));
}

TEST_CASE("a value expires after three of its periods")
{
    tried_value one;
    for (auto const& [every, seconds] : {std::pair{60.0, 180}, {2.5, 8}, {0.1, 5}, {3'600.0, 10'800}}) {
        one.value.every = every;
        CHECK(one.message()["expire_after"] == seconds);
    }
}

TEST_CASE("a counter of energy only rises, unless its type has a sign")
{
    tried_value one;
    one.value.unit = "kWh";
    one.value.which.where.form.type = tool::value_type::f32;
    CHECK(one.message()["state_class"] == "total_increasing");
    CHECK(one.message()["device_class"] == "energy");
    one.value.which.where.form.type = tool::value_type::i32;
    CHECK(one.message()["state_class"] == "total");
}

TEST_CASE("a unit that Home Assistant spells otherwise is spelt so, and an unknown one has no class")
{
    tried_value one;
    one.value.unit = "degC";
    CHECK(one.message()["unit_of_measurement"] == "°C");
    CHECK(one.message()["device_class"] == "temperature");
    one.value.unit = "rpm";
    CHECK(one.message()["unit_of_measurement"] == "rpm");
    CHECK_FALSE(one.message().contains("device_class"));
    one.value.unit = "";
    CHECK_FALSE(one.message().contains("unit_of_measurement"));
    CHECK(one.message()["state_class"] == "measurement");
}

TEST_CASE("a text is no measurement")
{
    tried_value one;
    one.value.kind = value_kind::text;
    json const said = one.message();
    CHECK_FALSE(said.contains("state_class"));
    CHECK_FALSE(said.contains("unit_of_measurement"));
    CHECK_FALSE(said.contains("suggested_display_precision"));
}

TEST_CASE("words of bits and of choices of a drive are no measurements")
{
    gateway_plan const plan = read_gateway_file("gateway.toml", R"(
site = "hall3"
gateway = "g1"
[[line]]
name = "line1"
port = "sim:atv320:7"
[[line.device]]
name = "fan"
unit = 7
drive = "atv320"
registers = ["ETA", "ETA.3", "LFT", "RFR", "3201:u16"]
feeds_supervision = true
)");
    line_plan const& line = *plan.lines.front();
    device_plan const& device = line.devices.front();
    REQUIRE(device.values.size() == 5);
    for (device_value const& value : device.values) {
        json const said = json::parse(discovery_of(plan, line, device, value, false).text);
        bool const is_amount = value.name == "RFR" or value.name.starts_with("3201");
        INFO(said.dump());
        CHECK(said.contains("state_class") == is_amount);
        CHECK(said.contains("suggested_display_precision") == is_amount);
        CHECK(said.contains("unit_of_measurement") == (value.name == "RFR"));
        CHECK(said["expire_after"] == 5);
    }
}

TEST_CASE("some bits of a register are a measurement where they have a unit")
{
    tried_value one;
    one.value.which.where.bit = 3;
    one.value.which.where.last_bit = 5;
    CHECK(one.message()["state_class"] == "measurement");
    one.value.unit = "";
    CHECK_FALSE(one.message().contains("state_class"));
    CHECK_FALSE(one.message().contains("suggested_display_precision"));
}

TEST_CASE("a setting is a number only where it may be written, never optimistic and never kept")
{
    tried_value one;
    one.value.name = "set_point";
    one.value.unit = "degC";
    one.value.setting = setting_limits{.lowest = 5, .highest = 30.5, .step = 0.5};
    CHECK(one.message()["state_class"] == "measurement");
    CHECK(one.topic.starts_with("homeassistant/sensor/"));
    json const said = one.message(true);
    CHECK(one.topic == "homeassistant/number/hall3_g1_line1_meter1/set_point/config");
    CHECK(said["command_topic"] == "rtuwire/hall3/g1/line1/meter1/set/set_point");
    CHECK(said["entity_category"] == "config");
    CHECK(said["mode"] == "box");
    CHECK(said["optimistic"] == false);
    CHECK(said["retain"] == false);
    CHECK(said["min"] == 5);
    CHECK(said["max"] == 30.5);
    CHECK(said["step"] == 0.5);
    CHECK_FALSE(said.contains("state_class"));
    CHECK_FALSE(said.contains("expire_after"));
    CHECK(said["availability_mode"] == "all");
    std::string const how = said["command_template"];
    for (std::string_view const key : {"\"value\"", "\"expires\"", "\"id\""}) {
        CHECK(how.find(key) != how.npos);
    }
}

TEST_CASE("a setting of choices, or of a bit, is a list")
{
    tried_value one;
    one.value.setting = setting_limits{.choices = {"off", "heat", "cool"}};
    one.value.kind = value_kind::choice;
    CHECK(one.message(true)["options"] == json::array({"off", "heat", "cool"}));
    CHECK(one.topic.starts_with("homeassistant/select/"));
    one.value.kind = value_kind::flag;
    CHECK(one.message(true)["options"] == json::array({"off", "on"}));
}

TEST_CASE("two devices, or values, that discovery would take for one are told")
{
    gateway_plan plan;
    plan.site = "s";
    plan.gateway = "g";
    for (auto const& [line, device] : {std::pair{"a", "b_c"}, {"a_b", "c"}}) {
        auto one = std::make_shared<line_plan>();
        one->name = line;
        one->devices.push_back(device_named(device));
        plan.lines.push_back(one);
    }
    std::string const why = why_no_discovery(plan);
    CHECK(why.find("a/b_c and a_b/c") != why.npos);
    plan.broker.discovery = "";
    CHECK(why_no_discovery(plan).empty());
    plan.broker.discovery = "homeassistant";
    plan.lines.pop_back();
    CHECK(why_no_discovery(plan).empty());

    auto two = std::make_shared<line_plan>();
    two->name = "l";
    for (auto const& [device, value] : {std::pair{"d", "a_b"}, {"d_a", "b"}}) {
        two->devices.push_back(device_named(device));
        two->devices.back().values = {{.name = value, .which = {}}};
    }
    plan.lines.push_back(two);
    CHECK(why_no_discovery(plan).find("l/d/a_b and l/d_a/b are both s_g_l_d_a_b") == 0);
    two->devices.front().values.front().name = "a"; // a value that is called as the other device is
    CHECK(why_no_discovery(plan).empty());
}

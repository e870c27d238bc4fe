// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is published when, for a broker that is there, away or slow; lines are said to be as each test wants them.
#include "messages/publisher.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "gateway/devices.hpp"
#include "messages/discovery.hpp"
#include "messages/reconnect_pauses.hpp"
#include "support/catch.hpp"

namespace {

using namespace tool::gateway;
using namespace gateway_test;
using namespace std::chrono_literals;
using nlohmann::json;

constexpr std::uint64_t second = 1'000'000;
constexpr std::uint64_t began = 1'796'000'523 * second; // 2026-11-30T01:02:03Z

/// A gateway of one line with devices that a test sets, and the messages that it gives.
class tried_gateway {
public:
    explicit tried_gateway(bool may_write = false, std::set<std::string> kept = {}) : gives{may_write, std::move(kept)}
    {
        plan.file = "gateway.toml";
        plan.site = "hall3";
        plan.gateway = "g1";
        add("line1", {"meter1", "meter2"});
    }

    void add(std::string const& name, std::vector<std::string> const& devices)
    {
        line_plan line;
        line.name = name;
        for (std::string const& each : devices) {
            device_plan device = device_named(each);
            device.values = {value_named("voltage", "V"), value_named("energy", "kWh")};
            line.devices.push_back(device);
            slots[name + '/' + each] = std::make_shared<slot_content const>(slot_content{.values = {{}, {}}});
        }
        plan.lines.push_back(std::make_shared<line_plan const>(line));
    }

    void use_plan()
    {
        std::vector<line_feed> lines;
        for (auto const& line : plan.lines) {
            lines.push_back(
                {line, [this, name = line->name] { return states[name]; },
                 [this, line](std::size_t which) { return slots[line->name + '/' + line->devices[which].name]; }});
        }
        gives.set_plan(plan, std::move(lines), now);
    }

    void connect()
    {
        use_plan();
        gives.connected();
    }

    /// A round of a device: its first value, and its second where that is read.
    void read(std::string const& device, double voltage, bool has_energy = true)
    {
        slot_content content = *slots[device];
        content.time = began + seq * second;
        content.seq = ++seq;
        content.is_available = true;
        content.values[0] = {value_state::valid, voltage, content.time, content.seq, {}};
        if (has_energy) {
            content.values[1] = {value_state::valid, 7.5, content.time, content.seq, {}};
        }
        slots[device] = std::make_shared<slot_content const>(content);
    }

    void fall_silent(std::string const& device)
    {
        slot_content content = *slots[device];
        content.time = began + seq * second;
        content.seq = ++seq;
        content.is_available = false;
        content.why = "it does not respond";
        for (slot_value& each : content.values) {
            each = {value_state::not_read, {}, content.time, content.seq, content.why};
        }
        slots[device] = std::make_shared<slot_content const>(content);
    }

    void beat(std::string const& line = "line1")
    {
        states[line].time = began + ++beats * second;
        ++states[line].seq;
        states[line].is_up = true;
    }

    std::vector<outgoing_message> all()
    {
        std::vector<outgoing_message> found;
        while (auto const next = gives.next(now)) {
            found.push_back(*next);
            REQUIRE(found.size() < 1'000);
        }
        return found;
    }

    gateway_plan plan;
    publisher gives;
    std::map<std::string, line_state> states;
    std::map<std::string, device_slot::content> slots;
    publisher::time now{1h};
    std::uint64_t seq{0};
    std::uint64_t beats{0};
};

std::vector<std::string> texts_on(std::vector<outgoing_message> const& all, std::string_view topic)
{
    std::vector<std::string> found;
    for (outgoing_message const& each : all) {
        if (each.topic == "rtuwire/hall3/g1/" + std::string{topic}) {
            found.push_back(each.text);
        }
    }
    return found;
}

using texts = std::vector<std::string>;

bool is_discovery(outgoing_message const& message) { return message.topic.starts_with("homeassistant/"); }

} // namespace

TEST_CASE("nothing is given before there is a connection, and then what is newest")
{
    tried_gateway one;
    one.use_plan();
    one.beat();
    one.read("line1/meter1", 229.9);
    one.read("line1/meter1", 230.1);
    CHECK(one.all().empty());
    one.gives.connected();
    auto const all = one.all();
    CHECK(all.front() == outgoing_message{"rtuwire/hall3/g1/status", "online", true, true});
    CHECK(texts_on(all, "line1/availability") == texts{"online"});
    CHECK(texts_on(all, "line1/meter1/availability") == texts{"online"});
    CHECK(texts_on(all, "line1/meter2/availability") == texts{"offline"});
    CHECK(texts_on(all, "line1/meter1/state") ==
          texts{R"({"time":"2026-11-30T01:02:04.000Z","seq":2,"values":{"voltage":{"value":230.1,"unit":"V"},)"
                R"("energy":{"value":7.5,"unit":"kWh"}}})"});
    CHECK(texts_on(all, "line1/meter2/state").empty());
    CHECK(one.all().empty());
    CHECK(one.gives.is_complete());
}

TEST_CASE("values are given once, those of their own round, and never kept by the broker")
{
    tried_gateway one;
    one.connect();
    one.beat();
    one.all();
    one.now += 20s; // behind what Home Assistant is told again
    one.all();
    one.read("line1/meter1", 230.0);
    one.all();
    one.read("line1/meter1", 231.0, false);
    auto const all = one.all();
    REQUIRE(all.size() == 1);
    CHECK_FALSE(all[0].is_retained);
    json const said = json::parse(all[0].text);
    CHECK(said["values"].size() == 1);
    CHECK(said["values"]["voltage"]["value"] == 231.0);
    CHECK(one.all().empty());
}

TEST_CASE("a value of an earlier round tells its own time where it is given with a later one")
{
    tried_gateway one;
    one.use_plan();
    one.read("line1/meter1", 230.0);
    one.read("line1/meter1", 231.0, false);
    one.gives.connected();
    json const said = json::parse(texts_on(one.all(), "line1/meter1/state").at(0));
    CHECK(said["time"] == "2026-11-30T01:02:04.000Z");
    CHECK_FALSE(said["values"]["voltage"].contains("time"));
    CHECK(said["values"]["energy"]["time"] == "2026-11-30T01:02:03.000Z");
}

TEST_CASE("values of a silent device are marked, and never given as fresh")
{
    tried_gateway one;
    one.connect();
    one.read("line1/meter1", 230.0);
    one.all();
    one.fall_silent("line1/meter1");
    auto const all = one.all();
    CHECK(texts_on(all, "line1/meter1/availability") == texts{"offline"});
    for (std::string const& each : texts_on(all, "line1/meter1/state")) {
        json const state = json::parse(each);
        for (auto const& [name, value] : state.at("values").items()) {
            CHECK(value["value"].is_null());
            CHECK(value["why"] == "it does not respond");
        }
    }
    one.now += 60s;
    CHECK(texts_on(one.all(), "line1/meter1/state").empty());
}

TEST_CASE("a value that the device has not, or that is out of its limits, is marked and no number")
{
    tried_gateway one;
    one.connect();
    slot_content content{.time = began, .seq = 1, .is_available = true, .values = {{}, {}}};
    content.values[0] = {value_state::invalid, {}, began, 1, "no value (0x8000)"};
    content.values[1] = {value_state::failed, {}, began, 1, "exception 02"};
    one.slots["line1/meter1"] = std::make_shared<slot_content const>(content);
    CHECK(texts_on(one.all(), "line1/meter1/state") ==
          texts{R"-({"time":"2026-11-30T01:02:03.000Z","seq":1,"values":{"voltage":{"value":null,"invalid":true,)-"
                R"-("why":"no value (0x8000)"},"energy":{"value":null,"why":"exception 02"}}})-"});
}

TEST_CASE("a line without a heartbeat for three seconds is offline, whatever its devices said")
{
    tried_gateway one;
    one.connect();
    one.beat();
    CHECK(texts_on(one.all(), "line1/availability") == texts{"online"});
    one.now += 2'999ms;
    CHECK(texts_on(one.all(), "line1/availability").empty());
    one.now += 1ms;
    CHECK(texts_on(one.all(), "line1/availability") == texts{"offline"});
    CHECK(one.all().empty());
    one.beat();
    CHECK(texts_on(one.all(), "line1/availability") == texts{"online"});
    one.states["line1"].is_up = false; // it lives, its port is gone
    ++one.states["line1"].seq;
    CHECK(texts_on(one.all(), "line1/availability") == texts{"offline"});
}

TEST_CASE("the counters of a line are given each second, with the time of its own loop, and not while it stands")
{
    tried_gateway one;
    one.connect();
    one.beat();
    one.states["line1"].requests = 7;
    auto const first = texts_on(one.all(), "line1/status");
    REQUIRE(first.size() == 1);
    json const said = json::parse(first[0]);
    CHECK(said["time"] == "2026-11-30T01:02:04.000Z");
    CHECK(said["seq"] == 1);
    CHECK(said["requests"] == 7);
    CHECK(said["silences"] == 0);
    CHECK(said["errors"] == 0);
    CHECK(said["up"] == true);
    one.now += 999ms;
    one.beat();
    CHECK(texts_on(one.all(), "line1/status").empty());
    one.now += 1ms;
    CHECK(texts_on(one.all(), "line1/status").size() == 1);
    for (auto const& [later, count] : {std::pair{1'200ms, 1U}, {799ms, 0U}, {1ms, 1U}}) { // a late one moves no other
        one.now += later;
        one.beat();
        CHECK(texts_on(one.all(), "line1/status").size() == count);
    }
    one.now += 10s;
    CHECK(texts_on(one.all(), "line1/status").empty());
}

TEST_CASE("discovery is given on connect and when Home Assistant begins, before values")
{
    tried_gateway one;
    one.connect();
    one.read("line1/meter1", 230.0);
    auto const all = one.all();
    auto const count = std::ranges::count_if(all, is_discovery);
    CHECK(count == 4);
    auto const last = std::find_if(all.rbegin(), all.rend(), is_discovery);
    auto const state =
        std::ranges::find(all, std::string{"rtuwire/hall3/g1/line1/meter1/state"}, &outgoing_message::topic);
    CHECK((last.base() - all.begin()) <= (state - all.begin()));
    for (outgoing_message const& each : all) {
        CHECK((not is_discovery(each) or (each.is_retained and not each.text.empty())));
    }
    one.now += 60s;
    one.all();
    one.gives.discover_again();
    auto const again = one.all();
    CHECK(std::ranges::count_if(again, is_discovery) == 4);
    CHECK(texts_on(again, "line1/meter1/state").empty());
    // It has subscribed by then, and gets what there is.
    one.now += 10s;
    CHECK(texts_on(one.all(), "line1/meter1/state").size() == 1);
    one.now += 10s;
    CHECK(texts_on(one.all(), "line1/meter1/state").empty());
}

TEST_CASE("without a prefix there is no discovery, and nothing is given again")
{
    tried_gateway one;
    one.plan.broker.discovery = "";
    one.connect();
    one.read("line1/meter1", 230.0);
    CHECK(std::ranges::count_if(one.all(), is_discovery) == 0);
    one.now += 60s;
    CHECK(texts_on(one.all(), "line1/meter1/state").empty());
}

TEST_CASE("what the broker keeps of a device that left the file is taken back once, also by the next process")
{
    std::set<std::string> kept;
    {
        tried_gateway one;
        one.use_plan();
        kept = one.gives.kept();
        CHECK(kept.contains("homeassistant/sensor/hall3_g1_line1_meter2/voltage/config"));
        CHECK(kept.contains("rtuwire/hall3/g1/line1/meter2/availability"));
        CHECK(kept.contains("rtuwire/hall3/g1/status"));
    }
    tried_gateway next{false, kept};
    next.plan.lines.clear();
    next.add("line1", {"meter1"});
    next.use_plan();
    CHECK(next.gives.kept() == kept); // until it is taken back
    next.gives.connected();
    std::set<std::string> emptied;
    for (outgoing_message const& each : next.all()) {
        if (each.text.empty()) {
            CHECK(each.is_retained);
            CHECK(each.must_arrive);
            emptied.insert(each.topic);
        }
    }
    CHECK(emptied == std::set<std::string>{"homeassistant/sensor/hall3_g1_line1_meter2/energy/config",
                                           "homeassistant/sensor/hall3_g1_line1_meter2/voltage/config",
                                           "rtuwire/hall3/g1/line1/meter2/availability"});
    // The connection was lost before all had arrived: the next one tells it again.
    next.gives.arrived("rtuwire/hall3/g1/line1/meter2/availability");
    next.gives.disconnected();
    next.gives.connected();
    auto const again = next.all();
    CHECK(std::ranges::count_if(again, [](auto const& each) { return each.text.empty(); }) == 2);
    next.gives.arrived("homeassistant/sensor/hall3_g1_line1_meter2/energy/config");
    CHECK(next.gives.has_to_take_back());
    next.gives.arrived("homeassistant/sensor/hall3_g1_line1_meter2/voltage/config");
    CHECK_FALSE(next.gives.has_to_take_back());
    CHECK_FALSE(next.gives.kept().contains("homeassistant/sensor/hall3_g1_line1_meter2/voltage/config"));
}

TEST_CASE("a changed file takes back what left, and gives no value again of a line that goes on")
{
    tried_gateway one;
    one.plan.broker.discovery = "";
    one.add("line2", {"meter3"});
    one.connect();
    one.beat("line1");
    one.beat("line2");
    one.read("line1/meter1", 230.0);
    one.all();
    one.plan.lines.pop_back();
    one.use_plan();
    auto const all = one.all();
    CHECK(texts_on(all, "line1/meter1/state").empty());
    CHECK(texts_on(all, "line1/availability").empty());
    CHECK(texts_on(all, "line2/availability") == texts{""});
    CHECK(texts_on(all, "line2/meter3/availability") == texts{""});
    CHECK(all.size() == 2);
}

TEST_CASE("the end says that everything is offline, and nothing after it")
{
    tried_gateway one;
    one.connect();
    one.beat();
    one.read("line1/meter1", 230.0);
    one.all();
    one.gives.end();
    one.read("line1/meter1", 231.0);
    auto const all = one.all();
    CHECK(texts_on(all, "line1/meter1/availability") == texts{"offline"});
    CHECK(texts_on(all, "line1/meter2/availability") == texts{"offline"});
    CHECK(texts_on(all, "line1/availability") == texts{"offline"});
    CHECK(all.back() == outgoing_message{"rtuwire/hall3/g1/status", "offline", true});
    CHECK(all.size() == 4);
    CHECK(one.gives.is_complete());
}

TEST_CASE("one device that speaks fast holds up no other")
{
    tried_gateway one;
    one.connect();
    one.all();
    one.read("line1/meter2", 1.0);
    int given = 0;
    for (int i = 0; i < 10; ++i) {
        one.read("line1/meter1", i);
        auto const next = one.gives.next(one.now);
        REQUIRE(next);
        given += next->topic.starts_with("rtuwire/hall3/g1/line1/meter2/") ? 1 : 0;
    }
    CHECK(given >= 2); // its availability and its values
}

TEST_CASE("where what was given is on its way still, values wait, and only the newest leaves then")
{
    tried_gateway one;
    one.connect();
    one.beat();
    one.all();
    one.read("line1/meter1", 1.0);
    CHECK(one.gives.next(one.now, false)->topic == "rtuwire/hall3/g1/line1/meter1/availability");
    one.read("line1/meter1", 2.0);
    CHECK_FALSE(one.gives.next(one.now, false));
    one.read("line1/meter1", 3.0);
    auto const all = one.all();
    REQUIRE(texts_on(all, "line1/meter1/state").size() == 1);
    CHECK(json::parse(all[0].text)["values"]["voltage"]["value"] == 3.0);
    CHECK(one.all().empty());
}

TEST_CASE("an answer is given once there is a connection, and is not kept by the broker")
{
    tried_gateway one;
    one.use_plan();
    one.gives.put_answer({"line1", "meter1", "voltage"}, "{}");
    CHECK(one.all().empty());
    one.gives.connected();
    auto const all = one.all();
    auto const found =
        std::ranges::find(all, outgoing_message{"rtuwire/hall3/g1/line1/meter1/answer/voltage", "{}", false});
    CHECK(found != all.end());
}

TEST_CASE("pauses before a broker is tried again grow, have an end, and differ between gateways")
{
    std::set<std::int64_t> first;
    for (int gateway = 0; gateway < 100; ++gateway) {
        reconnect_pauses pauses{"hall3/g" + std::to_string(gateway)};
        std::chrono::milliseconds whole{1'000};
        for (int i = 0; i < 10; ++i) {
            auto const pause = pauses.next();
            CHECK(pause >= whole / 2);
            CHECK(pause <= whole * 3 / 2);
            if (i == 0) {
                first.insert(pause.count());
            }
            whole = std::min(whole * 2, std::chrono::milliseconds{30'000});
        }
        pauses.connection_lasted(9s); // lost at once: no good one
        CHECK(pauses.next() >= 15s);
        pauses.connection_lasted(10s);
        CHECK(pauses.next() <= 1'500ms);
    }
    CHECK(first.size() > 80);
    CHECK(*first.rbegin() - *first.begin() > 800);
}

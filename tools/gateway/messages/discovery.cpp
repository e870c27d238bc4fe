// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/discovery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include <nlohmann/json.hpp>
#include <rtuwire/frames.hpp>

#include "messages/topics.hpp"
#include "output/plain_text.hpp"
#include "words/words.hpp"

namespace tool::gateway {

namespace {

using ordered = nlohmann::ordered_json;

/// What Home Assistant knows of a unit. Its own spelling of it where that differs; a class that is not certain, or that only
/// its newer versions know, would have it refuse the entity: then there is none.
struct known_unit {
    std::string_view unit;
    std::string_view device_class;
    std::string_view spelling{};
};

constexpr std::array known_units{
    known_unit{"V", "voltage"},         known_unit{"mV", "voltage"},
    known_unit{"A", "current"},         known_unit{"mA", "current"},
    known_unit{"W", "power"},           known_unit{"kW", "power"},
    known_unit{"VA", "apparent_power"}, known_unit{"var", "reactive_power"},
    known_unit{"Wh", "energy"},         known_unit{"kWh", "energy"},
    known_unit{"MWh", "energy"},        known_unit{"Hz", "frequency"},
    known_unit{"kHz", "frequency"},     known_unit{"degC", "temperature", "°C"},
    known_unit{"°C", "temperature"},    known_unit{"degF", "temperature", "°F"},
    known_unit{"°F", "temperature"},    known_unit{"K", "temperature"},
    known_unit{"Pa", "pressure"},       known_unit{"hPa", "pressure"},
    known_unit{"kPa", "pressure"},      known_unit{"bar", "pressure"},
    known_unit{"mbar", "pressure"},     known_unit{"ms", "duration"},
    known_unit{"s", "duration"},        known_unit{"min", "duration"},
    known_unit{"h", "duration"},        known_unit{"m3", "", "m³"},
    known_unit{"m3/h", "", "m³/h"},
};

known_unit const* known(std::string_view unit)
{
    auto const found = std::ranges::find(known_units, unit, &known_unit::unit);
    return found == known_units.end() ? nullptr : &*found;
}

/// A number as short as it is, 1 and not 1.0.
ordered json_of(double number)
{
    bool const is_whole = std::trunc(number) == number and std::abs(number) < 1e15;
    return is_whole ? ordered(static_cast<std::int64_t>(number)) : ordered(number);
}

std::string node_of(gateway_plan const& plan, line_plan const& line, device_plan const& device)
{
    return plan.site + '_' + plan.gateway + '_' + line.name + '_' + device.name;
}

std::string entity_of(std::string const& node, device_value const& value) { return node + '_' + value.name; }

/// What a message of a device says of a value. One without it changes nothing: a number ignores an empty text, a text would
/// be empty.
std::string value_template(device_value const& value, bool ignores_empty)
{
    std::string const one = "value_json['values']['" + value.name + "']['value']";
    std::string const said =
        value.kind == value_kind::flag ? "none if " + one + " is none else 'on' if " + one + " else 'off'" : one;
    return "{{ (" + said + ") if '" + value.name + "' in value_json['values'] else " +
           (ignores_empty ? "''" : "(this.state if this is defined else '')") + " }}";
}

/// The message of a setting: it acts soon or, where something kept it, never. A device that answers 0.3 s too late takes 23 s.
std::string command_template()
{
    return "{\"value\": {{ value | tojson }}, "
           "\"expires\": \"{{ (utcnow() + timedelta(seconds=30)).strftime('%Y-%m-%dT%H:%M:%SZ') }}\", "
           "\"id\": \"{{ utcnow().timestamp() }}\"}";
}

class entity {
public:
    entity(gateway_plan const& plan, line_plan const& line, device_plan const& device, device_value const& value,
           bool may_write)
        : plan_{plan}, line_{line}, device_{device}, value_{value},
          is_setting_{may_write and value.setting.has_value()}, topics_{plan.site, plan.gateway}
    {}

    retained_message message()
    {
        std::string const node = node_of(plan_, line_, device_);
        std::string const id = entity_of(node, value_);
        all_["name"] = value_.name;
        all_["unique_id"] = "rtuwire_" + id;
        // The name of one key until 2025, and of the other since.
        all_["object_id"] = id;
        all_["default_entity_id"] = std::string{component()} + '.' + lower(id);
        all_["state_topic"] = topics_.state(line_.name, device_.name);
        all_["value_template"] = value_template(value_, is_setting_ or value_.kind == value_kind::number);
        add_unit();
        if (is_setting_) {
            add_setting();
        } else {
            all_["expire_after"] = static_cast<int>(std::max(5.0, std::ceil(3 * value_.every)));
        }
        add_availability();
        add_device("rtuwire_" + node);
        return {topic(), plain_json(all_.dump(-1, ' ', false, ordered::error_handler_t::replace))};
    }

    std::string topic() const
    {
        return plan_.broker.discovery + '/' + std::string{component()} + '/' + node_of(plan_, line_, device_) + '/' +
               value_.name + "/config";
    }

private:
    bool has_choices() const { return value_.kind == value_kind::choice or value_.kind == value_kind::flag; }

    /// A word of bits, or some of them: its number is no amount, of which a mean or a digit behind the point would say anything.
    bool is_bits() const
    {
        auto const& [where, entry] = std::tie(value_.which.where, value_.which.entry);
        bool const is_entry = entry != nullptr and where.form.said.empty();
        return value_.unit.empty() and (where.bit >= 0 or (is_entry and entry->kind == register_kind::bits));
    }

    unsigned digits() const { return value_.decimals.value_or(is_bits() ? 0 : 2); }

    /// A counter of both directions.
    bool may_fall() const
    {
        value_type const type = value_.which.where.form.type;
        return type == value_type::i16 or type == value_type::i32 or type == value_type::i64;
    }

    std::string_view component() const
    {
        return not is_setting_                   ? "sensor"
               : has_choices()                   ? "select"
               : value_.kind == value_kind::text ? "text"
                                                 : "number";
    }

    void add_unit()
    {
        if (value_.kind != value_kind::number) {
            return;
        }
        known_unit const* const unit = known(value_.unit);
        std::string_view const device_class = device_class_of(value_.unit);
        if (not value_.unit.empty()) {
            all_["unit_of_measurement"] =
                unit != nullptr and not unit->spelling.empty() ? std::string{unit->spelling} : value_.unit;
        }
        if (not device_class.empty()) {
            all_["device_class"] = device_class;
        }
        if (not is_setting_ and not is_bits()) {
            all_["state_class"] = device_class != "energy" ? "measurement" : may_fall() ? "total" : "total_increasing";
            all_["suggested_display_precision"] = digits();
        }
    }

    void add_setting()
    {
        all_["command_topic"] = topics_.setting({line_.name, device_.name, value_.name});
        all_["command_template"] = command_template();
        all_["entity_category"] = "config";
        all_["optimistic"] = false;
        all_["retain"] = false;
        setting_limits const& limits = *value_.setting;
        if (has_choices()) {
            all_["options"] = value_.kind == value_kind::flag ? ordered{"off", "on"} : ordered(limits.choices);
        } else if (value_.kind == value_kind::number) {
            all_["mode"] = "box";
            // Without them it would take 1 to 100. The gateway itself checks by the register.
            all_["min"] = json_of(limits.lowest.value_or(-2'147'483'648.0));
            all_["max"] = json_of(limits.highest.value_or(4'294'967'295.0));
            // It knows no smaller one.
            all_["step"] = json_of(std::max(0.001, limits.step.value_or(std::pow(10, -double(digits())))));
        }
    }

    void add_availability()
    {
        all_["availability"] = ordered::array();
        for (std::string const& topic :
             {topics_.status(), topics_.availability(line_.name), topics_.availability(line_.name, device_.name)}) {
            all_["availability"].push_back({{"topic", topic}});
        }
        all_["availability_mode"] = "all";
    }

    void add_device(std::string const& id)
    {
        ordered device;
        device["identifiers"] = {id};
        device["name"] = device_.name;
        if (device_.names and not device_.names->vendor.empty()) {
            device["manufacturer"] = device_.names->vendor;
            device["model"] = device_.names->product;
        } else {
            device["model"] = device_.type;
        }
        all_["device"] = std::move(device);
        all_["origin"] = {{"name", "rtuwire-gateway"}};
    }

    gateway_plan const& plan_;
    line_plan const& line_;
    device_plan const& device_;
    device_value const& value_;
    bool is_setting_;
    topics topics_;
    ordered all_{};
};

} // namespace

std::string birth_topic(gateway_plan const& plan) { return plan.broker.discovery + "/status"; }

std::string_view device_class_of(std::string_view unit)
{
    known_unit const* const found = known(unit);
    return found == nullptr ? std::string_view{} : found->device_class;
}

retained_message discovery_of(gateway_plan const& plan, line_plan const& line, device_plan const& device,
                              device_value const& value, bool may_write)
{
    return entity{plan, line, device, value, may_write}.message();
}

std::string discovery_topic(gateway_plan const& plan, line_plan const& line, device_plan const& device,
                            device_value const& value, bool may_write)
{
    return entity{plan, line, device, value, may_write}.topic();
}

std::string why_no_discovery(gateway_plan const& plan)
{
    std::map<std::string, std::string> devices, entities; // whose identifiers have nothing to do with each other
    std::string why;
    auto const add = [&](auto& to, std::string const& id, std::string const& name) {
        auto const [before, is_new] = to.emplace(id, name);
        if (not is_new and why.empty() and not plan.broker.discovery.empty()) {
            why = before->second + " and " + name + " are both " + before->first + " in discovery: rename one";
        }
    };
    for (auto const& line : plan.lines) {
        for (device_plan const& each : line->devices) {
            std::string const node = node_of(plan, *line, each), name = line->name + '/' + each.name;
            add(devices, node, name);
            for (device_value const& value : each.values) {
                add(entities, entity_of(node, value), name + '/' + value.name);
            }
        }
    }
    return why;
}

} // namespace tool::gateway

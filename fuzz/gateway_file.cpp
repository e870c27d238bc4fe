// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Files of the gateway, beside the register files that come with the tool: any text is refused by its place in words for
// people, or gives lines whose devices each have values, topics and discovery of their own, and no setting that moves a motor.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "gateway_file.hpp"
#include "input.hpp"
#include "messages/discovery.hpp"

using namespace tool;
using namespace tool::gateway;
using fuzz::require;

namespace {

std::string const file = RTUWIRE_DEVICE_FOLDER "/gateway.toml";

/// Where the drives have commands and references (their programming manuals).
constexpr unsigned moving[]{400, 401, 8501, 8502, 8503, 8504, 8601, 8602};

void is_topic_part(std::string_view name)
{
    require(not name.empty() and name.size() <= 64);
    require(std::ranges::all_of(name, [](char c) {
        return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or (c >= '0' and c <= '9') or c == '-' or c == '_';
    }));
}

void value_is_right(gateway_plan const& plan, line_plan const& line, device_plan const& device,
                    device_value const& value)
{
    is_topic_part(value.name);
    require(value.every >= 0.02 and value.every <= 86'400);
    if (value.setting) {
        require(device.drive == nullptr or std::ranges::count(moving, value.which.where.address) == 0);
        require(value.which.named == nullptr or (value.which.named->is_writable and not value.which.named->moves));
    }
    for (bool const may_write : {false, true}) {
        retained_message const message = discovery_of(plan, line, device, value, may_write);
        require(message.topic == discovery_topic(plan, line, device, value, may_write));
        require(message.topic.find_first_of("+#") == std::string::npos);
        require(nlohmann::json::accept(message.text));
    }
}

void device_is_right(gateway_plan const& plan, line_plan const& line, device_plan const& device)
{
    is_topic_part(device.name);
    require((device.drive == nullptr) != (device.names == nullptr));
    require(device.drive == nullptr or device.feeds_supervision);
    require(not device.values.empty());
    std::set<std::string> names;
    for (device_value const& each : device.values) {
        require(names.insert(each.name).second);
        value_is_right(plan, line, device, each);
    }
}

void are_right(gateway_plan const& plan)
{
    is_topic_part(plan.site);
    is_topic_part(plan.gateway);
    require(not plan.lines.empty() and plan.lines.size() <= most_lines);
    std::set<std::string> lines;
    std::set<std::string> ports;
    for (auto const& line : plan.lines) {
        is_topic_part(line->name);
        require(lines.insert(line->name).second and ports.insert(line->choices.port).second);
        require(not line->devices.empty() and line->devices.size() <= most_devices);
        std::set<std::string> devices;
        std::set<unsigned> units;
        for (device_plan const& each : line->devices) {
            unsigned const unit = each.unit.unit.byte();
            require(unit >= 1 and unit <= 247 and units.insert(unit).second and devices.insert(each.name).second);
            device_is_right(plan, *line, each);
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    try {
        are_right(read_gateway_file(file, {reinterpret_cast<char const*>(data), size}));
    } catch (ended const& why) {
        require(why.status == exit_status::usage and std::string_view{why.what()}.starts_with(file + ':'));
    }
    return 0;
}

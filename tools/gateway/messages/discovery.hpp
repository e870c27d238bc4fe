// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How a value names itself to Home Assistant, by its MQTT discovery.
#pragma once

#include <string>
#include <string_view>

#include "gateway_file.hpp"

namespace tool::gateway {

/// A message that the broker keeps; with an empty text it forgets the one before.
struct retained_message {
    std::string topic;
    std::string text;

    friend bool operator==(retained_message const&, retained_message const&) = default;
};

/// Where Home Assistant says "online" when it has begun.
[[nodiscard]] std::string birth_topic(gateway_plan const& plan);

/// The device class of what is measured in a unit, as Home Assistant names it: "voltage" of "V"; empty where none is sure.
[[nodiscard]] std::string_view device_class_of(std::string_view unit);

/// A sensor, or, of a setting that may be written, what sets it: a number or a list of choices.
[[nodiscard]] retained_message discovery_of(gateway_plan const& plan, line_plan const& line, device_plan const& device,
                                            device_value const& value, bool may_write);

/// Where it goes.
[[nodiscard]] std::string discovery_topic(gateway_plan const& plan, line_plan const& line, device_plan const& device,
                                          device_value const& value, bool may_write);

/// Two devices whose names are one in discovery, "a_b" on "c" and "b" on "c_a"; empty where there are none.
[[nodiscard]] std::string why_no_discovery(gateway_plan const& plan);

} // namespace tool::gateway

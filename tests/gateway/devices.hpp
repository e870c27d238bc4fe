// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Devices of a gateway's file, as tests of what is published want them.
#pragma once

#include <string>
#include <utility>

#include "gateway_file.hpp"

namespace gateway_test {

inline tool::gateway::device_plan device_named(std::string name)
{
    return {.name = std::move(name), .unit = {*rtuwire::unit_id::checked(3)}, .type = "sdm630.toml"};
}

inline tool::gateway::device_value value_named(std::string name, std::string unit)
{
    tool::gateway::device_value value{.name = std::move(name), .which = {}};
    value.unit = std::move(unit);
    value.decimals = 1;
    return value;
}

} // namespace gateway_test

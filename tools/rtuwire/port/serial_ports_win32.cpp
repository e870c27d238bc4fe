// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/serial_ports.hpp"

#include <rtuwire/port.hpp>

namespace tool {

std::vector<serial_port> serial_ports(std::string const&)
{
    std::vector<serial_port> found;
    for (rtuwire::win32_port const& each : rtuwire::win32_ports()) {
        found.push_back({.device = each.name,
                         .driver = each.driver,
                         .maker = each.maker,
                         .product = each.product,
                         .serial = each.serial});
    }
    return found;
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the tool knows of the serial ports of Windows, for lines.py: a line for each.
#include <cstdio>

#include "port/serial_ports.hpp"

int main()
{
    for (tool::serial_port const& each : tool::serial_ports()) {
        std::printf("%s|%s|%s|%s|%s|%s\n", each.device.c_str(), each.stable.c_str(), each.driver.c_str(),
                    each.maker.c_str(), each.product.c_str(), each.serial.c_str());
    }
}

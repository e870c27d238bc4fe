// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The serial ports of this system: no line is opened.
#include <cstdio>

#include "commands/commands.hpp"
#include "port/device_holder.hpp"
#include "port/serial_ports.hpp"

namespace tool {

exit_status run_ports(choices const& chosen)
{
    output results{chosen.form, false};
    std::vector<serial_port> const ports = serial_ports();
    for (serial_port const& each : ports) {
        results.put({{"port", each.device},
                     {"driver", each.driver},
                     {"maker", each.maker},
                     {"product", each.product},
                     {"serial", each.serial},
                     {"used by", holder_of(each.device).name},
                     {"stable name", each.stable}});
    }
    results.finish();
    if (ports.empty()) {
        std::fputs("rtuwire: this system knows no serial port\n", stderr);
    }
    return exit_status::done;
}

} // namespace tool

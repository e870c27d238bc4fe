// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/traffic.hpp"

#include <array>
#include <string>

#include "exit_status.hpp"

namespace tool {

void refuse_traffic(any_port& port, rtuwire::duration time)
{
    rtuwire::instant const end = port.now() + time;
    std::size_t bytes = 0;
    bool is_damaged = false;
    std::array<std::byte, 512> place;
    while (not reached(port.now(), end)) {
        auto const heard = port.read(place, end);
        if (not heard) {
            throw ended{exit_status::port, port.failure()};
        }
        is_damaged = port.take_receive_error() or is_damaged;
        bytes += heard->size();
    }
    if (bytes > 0 or is_damaged) {
        refuse_for_safety(port.device() + ": somebody is talking on this line, " + std::to_string(bytes) +
                          " bytes while this program listened; a second client disturbs the first, and keeps a drive "
                          "running that its own has left. To speak all the same, say --no-listen");
    }
}

} // namespace tool

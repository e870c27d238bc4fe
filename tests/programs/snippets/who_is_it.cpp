// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: auto const page = line.ask(unit_id{5}, read_device_identification
#include <cstdint>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/serial_line.hpp>

using namespace rtuwire;

void show(std::uint8_t object, byte_view value);
void show(std::uint16_t count);

void snippet(blocking_client<posix_serial>& line)
{
    // BLOCK
}

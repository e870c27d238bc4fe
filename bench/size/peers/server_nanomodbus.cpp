// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sixteen registers, served by functions 03, 06, 16 and 23 of nanoMODBUS.
#include "nanomodbus.hpp"

#include <array>

namespace {

std::array<std::uint16_t, 16> bank;
nmbs_t node;

bool has(std::uint16_t first, std::uint16_t count) { return first + count <= static_cast<int>(bank.size()); }

nmbs_error read(std::uint16_t first, std::uint16_t count, std::uint16_t* to, std::uint8_t, void*)
{
    if (not has(first, count)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (int i = 0; i < count; ++i) {
        to[i] = bank[static_cast<std::size_t>(first + i)];
    }
    return NMBS_ERROR_NONE;
}

nmbs_error write(std::uint16_t first, std::uint16_t count, std::uint16_t const* from, std::uint8_t, void*)
{
    if (not has(first, count)) {
        return NMBS_EXCEPTION_ILLEGAL_DATA_ADDRESS;
    }
    for (int i = 0; i < count; ++i) {
        bank[static_cast<std::size_t>(first + i)] = from[i];
    }
    return NMBS_ERROR_NONE;
}

nmbs_error write_one(std::uint16_t address, std::uint16_t value, std::uint8_t unit, void* nothing)
{
    return write(address, 1, &value, unit, nothing);
}

} // namespace

int main()
{
    nmbs_platform_conf const platform = board_platform();
    nmbs_callbacks callbacks;
    nmbs_callbacks_create(&callbacks);
    callbacks.read_holding_registers = read;
    callbacks.write_single_register = write_one;
    callbacks.write_multiple_registers = write;
    nmbs_server_create(&node, 1, &platform, &callbacks);
    set_timeouts(node);
    for (;;) {
        nmbs_server_poll(&node);
    }
}

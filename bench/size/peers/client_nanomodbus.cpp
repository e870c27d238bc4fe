// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions 03, 06, 16 and 23, asked one after the other without end by nanoMODBUS.
#include "nanomodbus.hpp"

namespace {

constexpr std::uint16_t words[]{1, 2, 3, 4};
nmbs_t link;

[[gnu::noinline]] std::uint16_t ask(unsigned number)
{
    std::uint16_t got[4]{};
    nmbs_error error = NMBS_ERROR_NONE;
    switch (number) {
    case 0: error = nmbs_read_holding_registers(&link, 3201, 4, got); break;
    case 1: error = nmbs_write_single_register(&link, 8501, 6); break;
    case 2: error = nmbs_write_multiple_registers(&link, 8501, 4, words); break;
    default: error = nmbs_read_write_registers(&link, 3201, 4, got, 8501, 4, words); break;
    }
    return error == NMBS_ERROR_NONE ? got[0] : std::uint16_t{0};
}

} // namespace

int main()
{
    nmbs_platform_conf const platform = board_platform();
    nmbs_client_create(&link, &platform);
    set_timeouts(link);
    nmbs_set_destination_rtu_address(&link, 1);
    for (unsigned number = 0;; number = (number + 1) % 4) {
        board::put(static_cast<std::byte>(ask(number)));
    }
}

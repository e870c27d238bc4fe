// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of nanoMODBUS as `rtuwire check --client` starts it: PORT TIMEOUT, then "read UNIT ADDRESS COUNT" or
// "write UNIT ADDRESS VALUE".
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "nanomodbus_line.hpp"

namespace {

std::uint16_t number(char const* word) { return static_cast<std::uint16_t>(std::atoi(word)); }

} // namespace

int main(int argc, char** argv)
{
    int device = argc < 3 ? -1 : open_serial_line(argv[1]);
    nmbs_platform_conf const platform = nanomodbus_line(device);
    nmbs_t line;
    if (device < 0 or nmbs_client_create(&line, &platform) != NMBS_ERROR_NONE) {
        return 2;
    }
    nmbs_set_read_timeout(&line, std::atoi(argv[2]));
    nmbs_set_byte_timeout(&line, 100); // as in its examples
    for (char** word = argv + 3; word + 4 <= argv + argc; word += 4) {
        std::uint16_t values[125];
        bool const is_read = std::strcmp(word[0], "read") == 0;
        nmbs_set_destination_rtu_address(&line, static_cast<std::uint8_t>(number(word[1])));
        nmbs_error const why = is_read ? nmbs_read_holding_registers(&line, number(word[2]), number(word[3]), values)
                                       : nmbs_write_single_register(&line, number(word[2]), number(word[3]));
        if (why != NMBS_ERROR_NONE) {
            std::printf("error: %s\n", nmbs_strerror(why));
            continue;
        }
        for (int i = 0; is_read and i < number(word[3]); ++i) {
            std::printf("%d ", values[i]);
        }
        std::puts(is_read ? "" : "ok");
    }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A function in a message has one number, the decimal one of the specification, with the byte of the frame beside it where that
// is written otherwise: "function 16" is never 0x16.
#include "frame/function_text.hpp"

#include <array>
#include <string>

#include "support/catch.hpp"

#include "motion/raw_effect.hpp"
#include "serve/write_gate.hpp"

TEST_CASE("a function has its decimal number, and its byte where that looks otherwise")
{
    struct row {
        unsigned code;
        std::string words;
    };
    // MODBUS Application Protocol Specification V1.1b3, section 6: each function with its code in both forms.
    std::array<row, 23> const rows{{
        {0x01, "function 01, read coils"},
        {0x02, "function 02, read discrete inputs"},
        {0x03, "function 03, read holding registers"},
        {0x04, "function 04, read input registers"},
        {0x05, "function 05, write single coil"},
        {0x06, "function 06, write single register"},
        {0x07, "function 07, read exception status"},
        {0x08, "function 08, diagnostics"},
        {0x09, "function 09, which is not public"},
        {0x0B, "function 11 (0x0B), get comm event counter"},
        {0x0C, "function 12 (0x0C), get comm event log"},
        {0x0F, "function 15 (0x0F), write multiple coils"},
        {0x10, "function 16 (0x10), write multiple registers"},
        {0x11, "function 17 (0x11), report server ID"},
        {0x14, "function 20 (0x14), read file record"},
        {0x15, "function 21 (0x15), write file record"},
        {0x16, "function 22 (0x16), mask write register"},
        {0x17, "function 23 (0x17), read/write multiple registers"},
        {0x18, "function 24 (0x18), read FIFO queue"},
        {0x2B, "function 43 (0x2B), encapsulated interface transport"},
        {0x22, "function 34 (0x22), which is not public"},
        {0x41, "function 65 (0x41), which is not public"},
        {0x7F, "function 127 (0x7F), which is not public"},
    }};
    for (row const& each : rows) {
        std::array const pdu{static_cast<std::byte>(each.code)};
        CHECK(tool::words_of_function(pdu) == each.words);
        bool const is_public = each.words.find("not public") == std::string::npos;
        if (not is_public) {
            CHECK(tool::function_text(static_cast<rtuwire::function_code>(each.code)) ==
                  each.words.substr(0, each.words.find(',')));
        }
    }
    std::array const mask{std::byte{0x16}, std::byte{0}, std::byte{1}, std::byte{0},
                          std::byte{2},    std::byte{0}, std::byte{3}};
    CHECK(tool::judge_request({}, 7, mask).why ==
          "unit 7: function 22 (0x16), mask write register, may change something, and only reads pass; say --write");
}

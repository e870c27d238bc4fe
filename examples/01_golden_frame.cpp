// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 1: a request as bytes and a response as a value, both checked by the compiler already. Nothing comes before
// this lesson.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace {

//! [frame]
constexpr auto request = encode(unit_id{2}, read_holding_registers{.start = 3102, .count = 4});
static_assert(request == "02 03 0C 1E 00 04 27 6C"_hex);

constexpr auto received = "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex;
//! [frame]

} // namespace

int main()
{
    char text[3 * max_adu_size];
    auto const hex = to_hex(*request, text);
    std::printf("asked    %.*s\n", static_cast<int>(hex.size()), hex.data());
    auto const taken = decode_adu(received);
    if (not taken or check_response(*request, *taken) != errc::none) {
        return 1;
    }
    auto const read = read_holding_registers_response::decode(taken->pdu());
    if (not read) {
        return 1;
    }
    for (std::size_t i = 0; i < read->registers.size(); ++i) {
        std::printf("register %zu: %u\n", 3102 + i, read->registers[i]);
    }
    return 0;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions 03, 06, 16, 23 and 43/14 on frames that the firmware cuts by silence.
#include "board.hpp"

#include <array>

#include <rtuwire/server/respond.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {2, "1"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr unit_id address{1};
constexpr duration silence = microseconds(2'000);
word_bank<16> bank;

/// Writes the response to a frame in its place.
[[gnu::noinline]] byte_view response(byte_span place, std::size_t size)
{
    no_diagnostics none;
    return response_frame(place, size, address, bank, profile, none);
}

} // namespace

int main()
{
    std::array<std::byte, max_adu_size> frame;
    std::size_t size = 0;
    instant last{0};
    for (;;) {
        if (board::has_byte()) {
            std::byte const byte = board::byte();
            last = board::now();
            if (size < frame.size()) {
                frame[size++] = byte;
            }
        }
        if (size != 0 and reached(board::now(), last + silence)) {
            board::put(response(frame, size));
            size = 0;
        }
    }
}

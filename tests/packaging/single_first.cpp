// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One of two files of a program that include the single header: this one with all its parts.
#define RTUWIRE_PORT
#define RTUWIRE_PRINT
#include <rtuwire.hpp>

#include <iostream>

rtuwire::byte_view frame_of_the_other();

int main()
{
    using namespace rtuwire;
    constexpr auto expected = "02 03 0C 1E 00 04 27 6C"_hex;
    auto const frame = frame_of_the_other();
    if (frame.size() != expected.size()) {
        return 1;
    }
    for (std::size_t at = 0; at < expected.size(); ++at) {
        if (frame[at] != expected[at]) {
            return 2;
        }
    }
    posix_serial closed;
    std::cout << errc::timed_out << '\n';
    return closed.is_open() ? 3 : 0;
}

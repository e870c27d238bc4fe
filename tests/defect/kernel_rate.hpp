// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the kernel says of a terminal's line, by the kernel's own header: it cannot stand beside <termios.h>.
#pragma once

#include <cstdint>

namespace rtuwire::test {

struct line_of_kernel {
    std::uint32_t input_rate;
    std::uint32_t output_rate;
    bool has_parity;
    bool has_two_stop_bits;
};

/// All zero where it cannot be read.
line_of_kernel line_of(int device);

/// Sets both rates of a terminal; whether it could be done.
bool set_rate(int device, std::uint32_t bits_per_second);

/// The numbers of that header: the size of its structure, the offsets of its rates, and the requests.
struct numbers_of_kernel {
    unsigned long size, output_rate_at, input_rate_at, control_characters_at, get, set;
    std::uint32_t rate_bits, any_rate, input_shift;
};
numbers_of_kernel kernel_numbers();

} // namespace rtuwire::test

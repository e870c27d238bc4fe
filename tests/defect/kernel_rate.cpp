// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "defect/kernel_rate.hpp"

#include <cstddef>

#ifdef __linux__
#include <asm/ioctls.h>
#include <asm/termbits.h>

extern "C" int ioctl(int device, unsigned long request, ...) noexcept;
#endif

namespace rtuwire::test {

#ifdef __linux__
line_of_kernel line_of(int device)
{
    termios2 line{};
    if (::ioctl(device, TCGETS2, &line) != 0) {
        return {};
    }
    return {line.c_ispeed, line.c_ospeed, (line.c_cflag & PARENB) != 0, (line.c_cflag & CSTOPB) != 0};
}

bool set_rate(int device, std::uint32_t bits_per_second)
{
    termios2 line{};
    if (::ioctl(device, TCGETS2, &line) != 0) {
        return false;
    }
    line.c_cflag = (line.c_cflag & ~tcflag_t{CBAUD | CIBAUD}) | BOTHER | BOTHER << IBSHIFT;
    line.c_ispeed = line.c_ospeed = bits_per_second;
    return ::ioctl(device, TCSETS2, &line) == 0;
}

numbers_of_kernel kernel_numbers()
{
    return {sizeof(termios2),
            offsetof(termios2, c_ospeed),
            offsetof(termios2, c_ispeed),
            offsetof(termios2, c_cc),
            TCGETS2,
            TCSETS2,
            CBAUD,
            BOTHER,
            IBSHIFT};
}
#endif

} // namespace rtuwire::test

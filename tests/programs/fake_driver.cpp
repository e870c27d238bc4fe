// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Loaded in front of the C library: the calls that a pseudo-terminal has no driver for are answered as by a UART's.
// The transceiver is inverted and has delays, as the device tree of a board sets it (W23).
#include <cstdarg>

#include <asm/termbits.h>
#include <dlfcn.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

namespace {

serial_rs485 as_delivered()
{
    serial_rs485 settings{};
    settings.flags = SER_RS485_ENABLED | SER_RS485_RTS_AFTER_SEND | SER_RS485_RX_DURING_TX;
    settings.delay_rts_before_send = 1;
    settings.delay_rts_after_send = 2;
    return settings;
}

serial_rs485 transceiver = as_delivered();

/// What a UART makes of a rate that its clock cannot give.
unsigned nearest_rate(unsigned asked)
{
    switch (asked) {
    case 250'000: return 230'400;
    case 31'250: return 31'000;
    case 76'800: return 75'264; // 2 % less
    case 1'000'001: return 980'000;
    default: return asked;
    }
}

} // namespace

extern "C" int ioctl(int device, unsigned long request, ...) noexcept
{
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    if (request == TIOCGRS485) {
        *static_cast<serial_rs485*>(argument) = transceiver;
        return 0;
    }
    if (request == TIOCSRS485) {
        transceiver = *static_cast<serial_rs485*>(argument);
        return 0;
    }
    if (request == TCSETS2) {
        auto& line = *static_cast<termios2*>(argument);
        line.c_ispeed = line.c_ospeed = nearest_rate(line.c_ospeed);
    }
    using call = int (*)(int, unsigned long, void*);
    static auto const next = reinterpret_cast<call>(::dlsym(RTLD_NEXT, "ioctl"));
    return next(device, request, argument);
}

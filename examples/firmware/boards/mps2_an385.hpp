// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Arm MPS2 with the Cortex-M3 image AN385: CMSDK UARTs, 25 MHz.
#pragma once

#include <cstddef>
#include <cstdint>

namespace board {

inline constexpr std::uint32_t core_clock = 25'000'000;
inline constexpr char const* name = "mps2-an385";

/// The interrupt of the line's receiver, by its number in the vector table behind the core's 16.
inline constexpr unsigned line_interrupt = 0;

inline std::uint32_t volatile& at(std::uintptr_t address)
{
    return *reinterpret_cast<std::uint32_t volatile*>(address);
}

/// One CMSDK UART: 8 data bits, no parity.
template <std::uintptr_t Base> struct uart {
    static void begin(std::uint32_t baud)
    {
        at(Base + 0x10) = core_clock / baud;
        at(Base + 0x08) = 0x1 | 0x2 | 0x8; // transmitter, receiver, its interrupt
    }
    static bool has_octet() { return (at(Base + 0x04) & 0x2) != 0; }
    static std::byte octet() { return static_cast<std::byte>(at(Base)); }
    static bool has_room() { return (at(Base + 0x04) & 0x1) == 0; }
    static void put(std::byte octet) { at(Base) = static_cast<std::uint32_t>(octet); }
    static bool is_idle() { return has_room(); }
    /// An octet was lost since the last call.
    static bool take_damage()
    {
        bool const is_lost = (at(Base + 0x04) & 0x8) != 0;
        at(Base + 0x04) = 0x8;
        return is_lost;
    }
    static void clear_interrupt() { at(Base + 0x0C) = 0x2; }
};

using line_uart = uart<0x4000'4000>;
using console_uart = uart<0x4000'5000>;

/// GPIO 0, pin 0: the transceiver's driver enable, high while sending.
struct driver_enable {
    static void begin() { at(0x4001'0010) = 1; }
    static void set(bool is_on) { at(0x4001'0004) = is_on ? 1 : 0; }
};

inline void begin_clocks() {}

} // namespace board

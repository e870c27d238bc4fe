// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stellaris LM3S6965 evaluation board: Cortex-M3, PL011 UARTs, 12.5 MHz after reset.
#pragma once

#include <cstddef>
#include <cstdint>

namespace board {

inline constexpr std::uint32_t core_clock = 12'500'000;
inline constexpr char const* name = "lm3s6965evb";

/// The interrupt of the line's UART, a bit by its number in the vector table behind the core's 16.
inline constexpr std::uint32_t line_interrupts = 1U << 5U;

inline std::uint32_t volatile& at(std::uintptr_t address)
{
    return *reinterpret_cast<std::uint32_t volatile*>(address);
}

/// A byte from the receiver.
struct received {
    std::byte value;
    bool is_damaged;    ///< by its parity or its stop bit
    bool is_after_loss; ///< one before it was lost
};

/// One PL011: 8 data bits, even parity.
template <std::uintptr_t Base> struct uart {
    static void begin(std::uint32_t baud)
    {
        std::uint32_t const divisor = (core_clock * 4 + baud / 2) / baud; // in 64ths
        at(Base + 0x24) = divisor / 64;
        at(Base + 0x28) = divisor % 64;
        at(Base + 0x2C) = 0x60 | 0x6; // 8 bits, even parity; no FIFO: an interrupt for each byte
        at(Base + 0x30) = 0x301;
        at(Base + 0x38) = 0x30;
    }
    static bool has_byte() { return (at(Base + 0x18) & 0x10) == 0; }
    static received take()
    {
        std::uint32_t const word = at(Base);
        return {static_cast<std::byte>(word & 0xFFU), (word & 0x700U) != 0, (word & 0x800U) != 0};
    }
    static bool has_room() { return (at(Base + 0x18) & 0x20) == 0; }
    static void put(std::byte value) { at(Base) = static_cast<std::uint32_t>(value); }
    /// The last stop bit has left.
    static bool is_idle() { return (at(Base + 0x18) & 0x8) == 0 and has_room(); }
    static void clear_interrupts() { at(Base + 0x44) = 0x30; }
    /// As if the UART had: the next interrupt is its.
    static void request_interrupt() { at(0xE000'E200) = line_interrupts; }
};

using line_uart = uart<0x4000'C000>;
using console_uart = uart<0x4000'D000>;

/// Port B, pin 0: the transceiver's driver enable, high while sending.
struct driver_enable {
    static void begin()
    {
        at(0x4000'5400) |= 1; // output
        at(0x4000'551C) |= 1; // digital
    }
    static void set(bool is_on) { at(0x4000'5004) = is_on ? 1 : 0; }
};

/// Gives the clock to UART 0 and 1 and to port B.
inline void begin_clocks()
{
    at(0x400F'E104) |= 0x3;
    at(0x400F'E108) |= 0x2;
}

} // namespace board

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Arm MPS2 with the Cortex-M3 image AN385: CMSDK UARTs, 25 MHz.
#pragma once

#include <cstddef>
#include <cstdint>

namespace board {

inline constexpr std::uint32_t core_clock = 25'000'000;
inline constexpr char const* name = "mps2-an385";

/// The interrupts of the line's receiver, of its transmitter and of their overruns, each a bit by its number in the
/// vector table behind the core's 16.
inline constexpr std::uint32_t line_interrupts = 1U << 0U | 1U << 1U | 1U << 12U;

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

/// One CMSDK UART: 8 data bits, no parity.
template <std::uintptr_t Base> struct uart {
    static void begin(std::uint32_t baud)
    {
        at(Base + 0x10) = core_clock / baud;
        at(Base + 0x08) = 0x1 | 0x2 | 0x4 | 0x8; // transmitter, receiver, their interrupts
    }
    static bool has_byte() { return (at(Base + 0x04) & 0x2) != 0; }
    static received take()
    {
        bool const is_lost = (at(Base + 0x04) & 0x8) != 0;
        at(Base + 0x04) = 0x8;
        return {static_cast<std::byte>(at(Base)), false, is_lost};
    }
    static bool has_room() { return (at(Base + 0x04) & 0x1) == 0; }
    static void put(std::byte value) { at(Base) = static_cast<std::uint32_t>(value); }
    /// The last byte has left the buffer. This UART does not tell of its stop bit: a real board waits for one
    /// character more.
    static bool is_idle() { return has_room(); }
    static void clear_interrupts() { at(Base + 0x0C) = 0xF; }
    /// As if the transmitter had room.
    static void request_interrupt() { at(0xE000'E200) = 1U << 1U; }
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

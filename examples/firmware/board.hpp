// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the programs here need of a board: a clock, a UART with a driver-enable pin, a console, sleep. A board of
// your own is a header like the two in boards/. The line itself is in line.hpp, or in frames.hpp with DMA.
#pragma once

#include <cstddef>
#include <cstdint>

#include RTUWIRE_BOARD

#include <rtuwire/frames.hpp>

/// A program defines these two when it uses the line: the interrupt of its UART, and the clock's, which comes
/// each millisecond. They have one priority, so neither comes in between the other.
void on_line_interrupt();
void on_tick();

namespace board {

/// Counted by SysTick's interrupt.
inline std::uint32_t volatile milliseconds_gone = 0;

/// Microseconds since the start; wraps as `instant` does. In an interrupt, too: SysTick's own may be waiting
/// there, and its millisecond is not counted yet.
inline rtuwire::instant now()
{
    constexpr std::uint32_t ticks_a_millisecond = core_clock / 1'000;
    std::uint32_t before = 0, left = 0, waiting = 0;
    do {
        before = milliseconds_gone;
        left = at(0xE000'E018);
        waiting = at(0xE000'ED04) >> 26U & 1U;
        if (waiting != 0) {
            left = at(0xE000'E018); // it may have run out between the two looks
        }
    } while (before != milliseconds_gone);
    std::uint32_t const gone = ticks_a_millisecond - 1 - left;
    return rtuwire::instant{(before + waiting) * 1'000 + gone * 1'000 / ticks_a_millisecond};
}

/// Until the next interrupt; the clock's comes each millisecond. Interrupts are masked from the look to the
/// sleep, which ends all the same: none that comes in between is slept over.
template <typename Line> void sleep(Line const& line)
{
    asm volatile("cpsid i" : : : "memory");
    if (line.is_served()) {
        asm volatile("wfi" : : : "memory");
    }
    asm volatile("cpsie i" : : : "memory");
}

template <typename Characters> void print_all(Characters const& characters)
{
    for (char const c : characters) {
        while (not console_uart::has_room()) {
        }
        console_uart::put(static_cast<std::byte>(c));
    }
}

inline void print(rtuwire::literal words) { print_all(words); }

/// Whatever has a text: an amount with its unit, an enumerator, an error, how something ended.
template <typename Value> void print(Value const& value) { print_all(text_of(value)); }
template <std::size_t Size> void print(char const (&words)[Size]) { print_all(rtuwire::literal{words}); }

/// Clocks, pins and UARTs.
inline void begin()
{
    begin_clocks();
    driver_enable::begin();
    driver_enable::set(false);
    line_uart::begin(19'200);
    console_uart::begin(115'200);
    at(0xE000'E014) = core_clock / 1'000 - 1;
    at(0xE000'E018) = 0;
    at(0xE000'E010) = 0x7; // SysTick from the core's clock, with its interrupt
}

/// Once the program's line is ready for them.
inline void start_interrupts() { at(0xE000'E100) = line_interrupts; }

/// Ends an emulation by semihosting with a program's result. On a real board, an endless loop.
[[noreturn]] inline void end(int status)
{
    constexpr std::uint32_t exit_extended = 0x20;
    std::uint32_t const report[] = {0x20026, static_cast<std::uint32_t>(status)};
    register std::uint32_t operation asm("r0") = exit_extended;
    register std::uint32_t const* argument asm("r1") = report;
    asm volatile("bkpt 0xAB" : : "r"(operation), "r"(argument) : "memory");
    for (;;) {
    }
}

} // namespace board

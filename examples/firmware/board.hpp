// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the programs here need of a board: a clock, an RS-485 line with a driver-enable pin, a console.
// A board of your own is a header like the two in boards/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include RTUWIRE_BOARD

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/time.hpp>

namespace board {

/// Counted by SysTick's interrupt.
inline std::uint32_t volatile milliseconds_gone = 0;

/// Microseconds since the start; wraps as `instant` does.
inline rtuwire::instant now()
{
    constexpr std::uint32_t ticks_a_millisecond = core_clock / 1'000;
    std::uint32_t before = 0, left = 0;
    do {
        before = milliseconds_gone;
        left = at(0xE000'E018);
    } while (before != milliseconds_gone);
    std::uint32_t const gone = ticks_a_millisecond - 1 - left;
    return rtuwire::instant{before * 1'000 + gone * 1'000 / ticks_a_millisecond};
}

/// Octets from the receiver's interrupt to the loop: one side writes, the other reads.
class inbox {
public:
    /// False, and the octet is lost, where the loop came too late.
    bool put(std::byte octet)
    {
        std::uint32_t const next = (in_ + 1) % size;
        if (next == out_) {
            return false;
        }
        octets_[in_] = octet;
        in_ = next;
        return true;
    }
    /// What has arrived, as far as there is room.
    rtuwire::byte_view take(rtuwire::byte_span place)
    {
        std::size_t count = 0;
        while (count < place.size() and out_ != in_) {
            place[count++] = octets_[out_];
            out_ = (out_ + 1) % size;
        }
        return place.first(count);
    }

private:
    static constexpr std::uint32_t size = 320;

    // Volatile like the indices, so that no octet is written after the index that gives it away.
    std::byte volatile octets_[size]{};
    std::uint32_t volatile in_{0};
    std::uint32_t volatile out_{0};
};

inline inbox line_inbox;
inline bool volatile line_is_damaged = false;

/// The receiver's interrupt.
inline void receive()
{
    line_uart::clear_interrupt();
    if (line_uart::take_damage()) {
        line_is_damaged = true;
    }
    while (line_uart::has_octet()) {
        if (not line_inbox.put(line_uart::octet())) {
            line_is_damaged = true;
        }
    }
}

/// The transmitter, fed from the loop. The driver is enabled from the first start bit to the last stop
/// bit.
class transmitter {
public:
    void send(rtuwire::byte_view frame)
    {
        rest_ = frame;
        is_sending_ = true;
        driver_enable::set(true);
    }
    [[nodiscard]] bool is_sending() const { return is_sending_; }

    /// Whether the last stop bit has left since the last call.
    bool feed()
    {
        while (not rest_.empty() and line_uart::has_room()) {
            line_uart::put(rest_[0]);
            rest_ = rest_.subspan(1);
        }
        if (not is_sending_ or not rest_.empty() or not line_uart::is_idle()) {
            return false;
        }
        is_sending_ = false;
        driver_enable::set(false);
        return true;
    }

private:
    rtuwire::byte_view rest_{};
    bool is_sending_{false};
};

/// Hands to a client or a server what the line did, and to the line what it says; for each pass.
template <typename Engine> void serve_line(Engine& engine, transmitter& out)
{
    std::array<std::byte, 64> place;
    rtuwire::instant const now = board::now();
    // Before the octets: what arrived damaged must not end as a frame first.
    if (line_is_damaged) {
        line_is_damaged = false;
        engine.receive_error(now);
    }
    engine.receive(line_inbox.take(place), now);
    engine.advance(now);
    if (rtuwire::byte_view const frame = engine.poll_transmit(); not frame.empty()) {
        out.send(frame);
    }
    // While it sends, the loop does not sleep: on these boards no interrupt asks for the next octet.
    while (out.is_sending()) {
        if (out.feed()) {
            engine.sent(board::now());
        }
    }
}

/// Until the next interrupt; the clock's comes each millisecond.
inline void sleep() { asm volatile("wfi"); }

inline void print(rtuwire::text words)
{
    for (char const c : words) {
        while (not console_uart::has_room()) {
        }
        console_uart::put(static_cast<std::byte>(c));
    }
}

inline void print(std::int32_t number)
{
    if (number < 0) {
        print("-");
        number = -number;
    }
    if (number > 9) {
        print(number / 10);
    }
    char const digit[] = {static_cast<char>('0' + number % 10), '\0'};
    print(rtuwire::text{digit});
}

/// Clocks, pins, UARTs and interrupts.
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
    at(0xE000'E100) = 1U << line_interrupt;
}

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

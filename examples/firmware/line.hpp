// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An RS-485 line behind a UART and a driver-enable pin, for a client, a bus or a server: interrupts receive and
// send, the loop takes what happened from a queue. Knows no board: what it needs of one are its parameters.
#pragma once

#include <atomic>

#include <rtuwire/client.hpp>

namespace board {

/// A half-duplex line. The driver is enabled before the first start bit and disabled after the last stop bit.
template <typename Uart, typename DriverEnable> class half_duplex_line {
public:
    constexpr half_duplex_line() = default;

    /// The UART's interrupt, receiver and transmitter. No other interrupt that calls this line may come in
    /// between: they have one priority.
    void on_interrupt(rtuwire::instant now)
    {
        Uart::clear_interrupts();
        // The receiver first: a byte that came in while sending stands before `sent`.
        while (Uart::has_byte()) {
            auto const got = Uart::take();
            if (got.is_after_loss) {
                events_.receive_overrun(now);
            }
            if (got.is_damaged) {
                events_.receive_error(now);
            } else {
                events_.receive(got.value, now);
            }
        }
        go_on(now);
    }

    /// The clock's interrupt, each millisecond. These UARTs tell when there is room for a byte, not when the
    /// last stop bit has left; one that does (STM32: TC) does not need this.
    void on_tick(rtuwire::instant now) { go_on(now); }

    /// In each pass of the loop.
    template <typename Engine> void serve(Engine& engine, rtuwire::instant now)
    {
        events_.deliver_to(engine, now);
        engine.advance(now);
        if (rtuwire::byte_view const frame = engine.poll_transmit(); not frame.empty()) {
            rest_ = frame;
            DriverEnable::set(true);
            // The interrupt reads the frame from here on, up to `sent`.
            is_sending_.store(true, std::memory_order_release);
            Uart::request_interrupt();
        }
    }

    /// Whether the loop may sleep; to be asked with interrupts masked.
    [[nodiscard]] bool is_served() const { return events_.is_empty(); }

private:
    void go_on(rtuwire::instant now)
    {
        if (not is_sending_.load(std::memory_order_acquire)) {
            return;
        }
        while (not rest_.empty() and Uart::has_room()) {
            Uart::put(rest_[0]);
            rest_ = rest_.subspan(1);
        }
        if (rest_.empty() and Uart::is_idle()) {
            DriverEnable::set(false);
            is_sending_.store(false, std::memory_order_release);
            events_.sent(now);
        }
    }

    rtuwire::interrupt_queue<> events_{};
    rtuwire::byte_view rest_{};
    std::atomic<bool> is_sending_{false};
};

} // namespace board

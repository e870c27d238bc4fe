// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file for Zephyr behind a UART whose interrupt comes as long as something is to be done, which has no room for a second
// byte, and which receives nothing more behind an overrun until it was asked for its errors.
// PROCESSORS: cortex-m0plus cortex-m3 cortex-m4 rv32imc
#include "lives.hpp"

#define main run_board
#include "../../examples/boards/zephyr.cpp"
#undef main

#include "loop.hpp"

namespace {

uart_irq_callback_user_data_t handler = nullptr;
bool has_byte = false, is_stuck = false, is_sending_enabled = false, is_in_interrupt = false, is_updated = false;
int errors = 0;
std::uint8_t data = 0;

void interrupt()
{
    is_in_interrupt = true;
    for (int i = 0; i < 4; ++i) {
        is_updated = false;
        handler(&stand_in_uart, nullptr);
        stand_in::check(is_updated, "uart_irq_update comes first");
        bool const is_due =
            has_byte or (is_sending_enabled and (stand_in::line.waiting() == 0 or stand_in::line.is_idle()));
        if (not is_due) {
            break;
        }
    }
    is_in_interrupt = false;
}

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (is_stuck) {
        return;
    }
    if (how == arrival::overrun or has_byte) {
        is_stuck = true;
        errors |= 1;
    } else {
        data = byte;
        has_byte = true;
        errors |= how == arrival::parity ? 2 : how == arrival::framing ? 4 : how == arrival::noise ? 32 : 0;
    }
    interrupt();
}

struct zephyr : stand_in::loop_of_file {
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    static void open()
    {
        stand_in::line.on_byte = arrive;
        auto const sent = [] {
            if (is_sending_enabled) {
                interrupt();
            }
        };
        stand_in::line.on_room = sent;
        stand_in::line.on_last_bit = sent;
    }
    static void run() { run_board(); }
};

} // namespace

device const stand_in_uart{"uart"};

int64_t k_uptime_ticks() { return static_cast<int64_t>(stand_in::line.now() / 100); }
uint64_t k_ticks_to_us_floor64(uint64_t ticks) { return ticks * 100; }
int k_sem_take(k_sem* sem, k_timeout_t timeout)
{
    if (sem->count == 0) {
        stand_in::line.pass_to_event(static_cast<stand_in::wire::time>(timeout.ticks) * 100);
    }
    sem->count = 0;
    return 0;
}
void k_sem_give(k_sem* sem) { sem->count = 1; }
int gpio_pin_configure_dt(gpio_dt_spec const*, gpio_flags_t flags)
{
    stand_in::check(flags == GPIO_OUTPUT_INACTIVE, "the pin is an output");
    return 0;
}
int gpio_pin_set_dt(gpio_dt_spec const* spec, int is_on)
{
    stand_in::check(spec->pin == 3, "the pin is the driver's");
    stand_in::line.drive(is_on != 0);
    return 0;
}
int uart_err_check(device const*)
{
    int const found = errors;
    errors = 0;
    is_stuck = false;
    return found;
}
int uart_fifo_fill(device const*, uint8_t const* bytes, int size)
{
    stand_in::check(is_in_interrupt and size > 0, "it is filled in the interrupt");
    stand_in::line.put(bytes[0]);
    return 1;
}
int uart_fifo_read(device const*, uint8_t* place, int)
{
    if (not has_byte) {
        return 0;
    }
    *place = data;
    has_byte = false;
    return 1;
}
void uart_irq_tx_enable(device const*)
{
    is_sending_enabled = true;
    interrupt();
}
void uart_irq_tx_disable(device const*) { is_sending_enabled = false; }
int uart_irq_tx_ready(device const*) { return is_in_interrupt and stand_in::line.waiting() == 0 ? 1 : 0; }
void uart_irq_rx_enable(device const*) {}
int uart_irq_tx_complete(device const*)
{
    stand_in::check(is_in_interrupt, "that is asked in the interrupt");
    return stand_in::line.is_idle() ? 1 : 0;
}
int uart_irq_rx_ready(device const*) { return has_byte ? 1 : 0; }
void uart_irq_err_enable(device const*) {}
int uart_irq_update(device const*)
{
    is_updated = true;
    return 1;
}
int uart_irq_callback_user_data_set(device const*, uart_irq_callback_user_data_t callback, void*)
{
    handler = callback;
    return 0;
}

int main() { return stand_in::live<zephyr>(value, trouble); }

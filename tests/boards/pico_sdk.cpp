// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file for RP2040 and RP2350 behind a PL011 without its FIFO: a byte waits in its data register with what went wrong, an
// overrun is told with the byte that stayed, and the interrupt comes until the register is read.
// PROCESSORS: cortex-m0plus cortex-m33 rv32imac
#include "lives.hpp"

#define main run_board
#include "../../examples/boards/pico_sdk.cpp"
#undef main

#include "loop.hpp"

namespace {

uart_hw_t registers{};
std::uint32_t waiting = 0;
bool has_word = false, is_enabled = false;
irq_handler_t handler = nullptr;

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    waiting = byte | (how == arrival::overrun or has_word ? UART_UARTDR_OE_BITS
                      : how == arrival::parity            ? UART_UARTDR_PE_BITS
                      : how == arrival::framing           ? UART_UARTDR_FE_BITS
                      : how == arrival::noise             ? UART_UARTDR_FE_BITS | UART_UARTDR_BE_BITS
                                                          : 0U);
    has_word = true;
    if (is_enabled) {
        handler();
    }
}

struct pico_sdk : stand_in::loop_of_file {
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    static void open() { stand_in::line.on_byte = arrive; }
    static void run() { run_board(); }
};

} // namespace

uart_inst_t* const stand_in_uart1 = nullptr;

uint32_t time_us_32() { return stand_in::line.now_32(); }
absolute_time_t make_timeout_time_us(uint64_t us) { return stand_in::line.now() + us; }
bool best_effort_wfe_or_timeout(absolute_time_t timeout)
{
    stand_in::line.pass_to_event(timeout - stand_in::line.now());
    return stand_in::line.now() >= timeout;
}
void gpio_init(uint) {}
void gpio_set_dir(uint gpio, bool out) { stand_in::check(gpio == 3 and out, "the pin is an output"); }
void gpio_put(uint gpio, bool is_on)
{
    stand_in::check(gpio == 3, "the pin is GPIO 3");
    stand_in::line.drive(is_on);
}
void gpio_set_function(uint, gpio_function_t) {}
void irq_set_exclusive_handler(uint number, irq_handler_t its_handler)
{
    stand_in::check(number == UART1_IRQ, "the interrupt is UART1's");
    handler = its_handler;
}
void irq_set_enabled(uint, bool enabled) { is_enabled = enabled; }
uart_hw_t* uart_get_hw(uart_inst_t*)
{
    registers.dr = waiting; // reading it takes it
    waiting = 0;
    has_word = false;
    return &registers;
}
uint uart_init(uart_inst_t*, uint baudrate) { return baudrate; }
void uart_set_format(uart_inst_t*, uint data_bits, uint stop_bits, uart_parity_t parity)
{
    stand_in::check(data_bits == 8 and stop_bits == 1 and parity == UART_PARITY_EVEN, "the format is 8E1");
}
void uart_set_fifo_enabled(uart_inst_t*, bool enabled) { stand_in::check(not enabled, "each byte has its interrupt"); }
void uart_set_irqs_enabled(uart_inst_t*, bool rx_has_data, bool) { is_enabled = rx_has_data; }
bool uart_is_readable(uart_inst_t*) { return has_word; }
void uart_write_blocking(uart_inst_t*, uint8_t const* bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i) {
        stand_in::line.put(bytes[i]);
        while (stand_in::line.waiting() > 0) { // one place before the shift register
            stand_in::line.pass(100);
        }
    }
}
void uart_tx_wait_blocking(uart_inst_t*)
{
    while (not stand_in::line.is_idle()) {
        stand_in::line.pass(10);
    }
}

int main() { return stand_in::live<pico_sdk>(value, trouble); }

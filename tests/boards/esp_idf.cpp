// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file for ESP-IDF behind a driver that does what its own does: it keeps bytes in a ring, tells of each and of errors in a
// queue that drops what does not fit, stops receiving while the ring is full, and enables the line's driver by RTS.
// PROCESSORS: rv32imc lx106
#include "lives.hpp"

#include "../../examples/boards/esp_idf.cpp"

#include "loop.hpp"

namespace {

std::deque<std::uint8_t> ring;
std::deque<uart_event_type_t> queue;
std::size_t ring_size = 0, queue_size = 0;
bool is_half_duplex = false, is_on_pin = false;
constexpr stand_in::wire::time tick = 10'000; // as configured at first

void tell(uart_event_type_t what)
{
    if (queue.size() < queue_size) {
        queue.push_back(what);
    }
}

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (ring.size() == ring_size) {
        return tell(UART_BUFFER_FULL);
    }
    if (how == arrival::overrun) {
        return tell(UART_FIFO_OVF); // the driver has emptied it
    }
    ring.push_back(how == arrival::noise ? stand_in::as_it_comes(byte, how) : byte); // of which it knows nothing
    tell(how == arrival::parity ? UART_PARITY_ERR : how == arrival::framing ? UART_FRAME_ERR : UART_DATA);
}

struct esp_idf : stand_in::loop_of_file {
    static constexpr auto timing = line_timing::host(19'200, character_format::even_8_1);
    static void open()
    {
        stand_in::line.on_byte = arrive;
        stand_in::line.on_last_bit = [] { stand_in::line.drive(false); };
    }
    static void run() { app_main(); }
};

} // namespace

void stand_in_error_check(esp_err_t error) { stand_in::check(error == ESP_OK, "the driver takes it"); }
int64_t esp_timer_get_time() { return static_cast<int64_t>(stand_in::line.now()); }
esp_err_t uart_driver_install(uart_port_t number, int rx_size, int tx_size, int size, QueueHandle_t*, int)
{
    ring_size = static_cast<std::size_t>(rx_size);
    queue_size = static_cast<std::size_t>(size);
    return number == UART_NUM_1 and rx_size > 128 and tx_size == 0 ? ESP_OK : -1;
}
esp_err_t uart_param_config(uart_port_t, uart_config_t const* config)
{
    return config->baud_rate == 19'200 and config->data_bits == UART_DATA_8_BITS and
                   config->parity == UART_PARITY_EVEN and config->stop_bits == UART_STOP_BITS_1
               ? ESP_OK
               : -1;
}
esp_err_t uart_set_pin(uart_port_t, int tx, int rx, int rts, int)
{
    is_on_pin = tx == 17 and rx == 16 and rts == 18;
    return is_on_pin ? ESP_OK : -1;
}
esp_err_t uart_set_mode(uart_port_t, uart_mode_t mode)
{
    is_half_duplex = mode == UART_MODE_RS485_HALF_DUPLEX;
    return ESP_OK;
}
esp_err_t uart_set_rx_full_threshold(uart_port_t, int threshold) { return threshold == 1 ? ESP_OK : -1; }
int uart_read_bytes(uart_port_t, void* place, uint32_t length, uint32_t ticks)
{
    stand_in::check(ticks == 0, "a read does not wait");
    auto* const out = static_cast<std::uint8_t*>(place);
    uint32_t count = 0;
    for (; count < length and not ring.empty(); ++count) {
        out[count] = ring.front();
        ring.pop_front();
    }
    return static_cast<int>(count);
}
int uart_write_bytes(uart_port_t, void const* bytes, size_t size)
{
    stand_in::line.drive(is_half_duplex and is_on_pin);
    for (size_t i = 0; i < size; ++i) {
        stand_in::line.put(static_cast<std::uint8_t const*>(bytes)[i]);
    }
    return static_cast<int>(size);
}
esp_err_t uart_wait_tx_done(uart_port_t, uint32_t)
{
    while (not stand_in::line.is_idle()) {
        stand_in::line.pass_to_event(tick);
    }
    return ESP_OK;
}
BaseType_t xQueuePeek(QueueHandle_t, void* buffer, TickType_t ticks)
{
    // A task that waits goes on when something is in the queue, or at a tick.
    for (auto const end = stand_in::line.now() + ticks * tick; queue.empty() and stand_in::line.now() < end;) {
        stand_in::line.pass_to_event(end - stand_in::line.now());
    }
    if (queue.empty()) {
        return 0;
    }
    static_cast<uart_event_t*>(buffer)->type = queue.front();
    return pdTRUE;
}
BaseType_t xQueueReceive(QueueHandle_t handle, void* buffer, TickType_t ticks)
{
    BaseType_t const has = xQueuePeek(handle, buffer, ticks);
    if (has == pdTRUE) {
        queue.pop_front();
    }
    return has;
}

int main() { return stand_in::live<esp_idf>(value, trouble); }

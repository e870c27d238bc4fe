// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The sketch for ESP32 behind a core that does what its own does: bytes wait in a ring, errors are told in another task, and
// RTS enables the line's driver.
// PROCESSORS: rv32imc lx106
#include "lives.hpp"

#include "../../examples/boards/arduino_esp32.cpp"

#include "loop.hpp"

namespace {

std::deque<std::uint8_t> ring;
OnReceiveErrorCb on_error;
bool is_half_duplex = false, is_on_pin = false;

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (how == arrival::overrun) {
        return on_error(UART_FIFO_OVF_ERROR);
    }
    ring.push_back(how == arrival::noise ? stand_in::as_it_comes(byte, how) : byte); // of which it knows nothing
    if (how == arrival::parity or how == arrival::framing) {
        on_error(how == arrival::parity ? UART_PARITY_ERROR : UART_FRAME_ERROR);
    }
}

struct arduino_esp32 : stand_in::loop_of_file {
    static constexpr auto timing = line_timing::host(19'200, character_format::even_8_1);
    static void open()
    {
        stand_in::line.on_byte = arrive;
        stand_in::line.on_last_bit = [] { stand_in::line.drive(false); };
        setup();
    }
    static void run()
    {
        for (;;) {
            loop();
        }
    }
};

} // namespace

HardwareSerial Serial1;

void HardwareSerial::begin(unsigned long baud, uint32_t config, int8_t, int8_t, bool, unsigned long, uint8_t)
{
    stand_in::check(baud == 19'200 and config == SERIAL_8E1, "the format is 8E1");
}
bool HardwareSerial::setPins(int8_t rx, int8_t tx, int8_t cts, int8_t rts)
{
    is_on_pin = rx == 16 and tx == 17 and cts == -1 and rts == 18;
    return true;
}
bool HardwareSerial::setMode(SerialMode mode)
{
    is_half_duplex = mode == UART_MODE_RS485_HALF_DUPLEX;
    return true;
}
bool HardwareSerial::setRxFIFOFull(uint8_t bytes) { return bytes == 1; }
void HardwareSerial::onReceiveError(OnReceiveErrorCb function) { on_error = function; }
int HardwareSerial::available() { return static_cast<int>(ring.size()); }
int HardwareSerial::read()
{
    int const byte = ring.front();
    ring.pop_front();
    return byte;
}
void HardwareSerial::flush()
{
    while (not stand_in::line.is_idle()) {
        stand_in::line.pass_to_event(1'000);
    }
}
size_t HardwareSerial::write(uint8_t const* buffer, size_t size)
{
    stand_in::line.drive(is_half_duplex and is_on_pin);
    for (size_t i = 0; i < size; ++i) {
        stand_in::line.put(buffer[i]);
    }
    return size;
}
unsigned long micros() { return stand_in::line.now_32(); }
void delay(uint32_t ms) { stand_in::line.pass(ms * 1'000); }

int main() { return stand_in::live<arduino_esp32>(value, trouble); }

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The sketch for any core with C++20 behind a HardwareSerial that says nothing of damage, and whose flush returns while the
// last two bytes leave, as those do that wait for their buffer alone.
// PROCESSORS: cortex-m0plus cortex-m3 cortex-m4
#include "lives.hpp"

#include "../../examples/boards/arduino_stream.cpp"

#include "loop.hpp"

namespace {

std::deque<std::uint8_t> ring;

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    if (how != stand_in::arrival::overrun) {
        ring.push_back(stand_in::as_it_comes(byte, how));
    }
}

struct hurried_serial final : HardwareSerial {
    void begin(unsigned long baud, uint16_t config) override
    {
        stand_in::check(baud == 19'200 and config == SERIAL_8E1, "the format is 8E1");
    }
    int available() override { return static_cast<int>(ring.size()); }
    int read() override
    {
        int const byte = ring.front();
        ring.pop_front();
        return byte;
    }
    size_t write(uint8_t byte) override
    {
        stand_in::line.put(byte);
        return 1;
    }
    size_t write(uint8_t const* buffer, size_t size) override
    {
        for (size_t i = 0; i < size; ++i) {
            write(buffer[i]);
        }
        return size;
    }
    void flush() override
    {
        while (stand_in::line.waiting() > 1) {
            stand_in::line.pass_to_event(1'000);
        }
    }
};

struct arduino_stream : stand_in::loop_of_file {
    static constexpr auto timing = ::timing;
    static void open()
    {
        stand_in::line.on_byte = arrive;
        setup();
    }
    static void run()
    {
        for (;;) {
            loop();
        }
    }
};

hurried_serial hurried;

} // namespace

HardwareSerial& Serial1 = hurried;

void pinMode(pin_size_t pin, PinMode mode) { stand_in::check(pin == 2 and mode == OUTPUT, "the pin is an output"); }
void digitalWrite(pin_size_t pin, PinStatus status)
{
    stand_in::check(pin == 2, "the pin is 2");
    stand_in::line.drive(status == HIGH);
}
unsigned long micros()
{
    stand_in::line.pass(2); // that is how long it takes
    return stand_in::line.now_32();
}
void delay(unsigned long ms) { stand_in::line.pass(ms * 1'000); }

int main() { return stand_in::live<arduino_stream>(value, trouble); }

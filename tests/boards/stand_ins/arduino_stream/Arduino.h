// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for Arduino.h of a core with arduino/ArduinoCore-API 1.5.2, of which it declares what the board's file calls.
// ../../facts/arduino_stream.cpp holds it to that.
#pragma once

#include <stddef.h>
#include <stdint.h>

#define SERIAL_8E1 (0x411ul)

namespace arduino {

typedef enum { LOW = 0, HIGH = 1 } PinStatus;
typedef enum { INPUT = 0, OUTPUT = 1 } PinMode;
typedef uint8_t pin_size_t;

class Print {
public:
    virtual size_t write(uint8_t) = 0;
    virtual size_t write(uint8_t const* buffer, size_t size) = 0;
    virtual void flush() {}
};
class Stream : public Print {
public:
    virtual int available() = 0;
    virtual int read() = 0;
};
class HardwareSerial : public Stream {
public:
    virtual void begin(unsigned long baudrate, uint16_t config) = 0;
};

} // namespace arduino

using namespace arduino;

extern HardwareSerial& Serial1;

extern "C" {
void pinMode(pin_size_t pin, PinMode mode);
void digitalWrite(pin_size_t pin, PinStatus status);
unsigned long micros();
void delay(unsigned long ms);
}
void setup();
void loop();

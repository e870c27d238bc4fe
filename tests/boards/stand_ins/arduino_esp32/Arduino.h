// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for Arduino.h of espressif/arduino-esp32 3, of which it declares what the board's file calls.
// ../../facts/arduino_esp32.cpp holds it to that.
#pragma once

#include <functional>

#include <stddef.h>
#include <stdint.h>

enum SerialConfig { SERIAL_8E1 = 0x800001e };
enum SerialMode { UART_MODE_UART = 0, UART_MODE_RS485_HALF_DUPLEX = 1 };
enum hardwareSerial_error_t {
    UART_NO_ERROR,
    UART_BREAK_ERROR,
    UART_BUFFER_FULL_ERROR,
    UART_FIFO_OVF_ERROR,
    UART_FRAME_ERROR,
    UART_PARITY_ERROR
};
typedef std::function<void(hardwareSerial_error_t)> OnReceiveErrorCb;

class HardwareSerial {
public:
    void begin(unsigned long baud, uint32_t config, int8_t rx = -1, int8_t tx = -1, bool invert = false,
               unsigned long timeout_ms = 20000UL, uint8_t threshold = 120);
    bool setPins(int8_t rx, int8_t tx, int8_t cts = -1, int8_t rts = -1);
    bool setMode(SerialMode mode);
    bool setRxFIFOFull(uint8_t bytes);
    void onReceiveError(OnReceiveErrorCb function);
    int available();
    int read();
    void flush();
    size_t write(uint8_t const* buffer, size_t size);
};
extern HardwareSerial Serial1;

extern "C" {
unsigned long micros();
void delay(uint32_t ms);
}
void setup();
void loop();

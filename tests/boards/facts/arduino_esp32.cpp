// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// espressif/arduino-esp32 3, cores/esp32/HardwareSerial.h, esp32-hal-uart.h and esp32-hal.h. Read; not compiled with these.
#include <Arduino.h>

#include "facts.hpp"

using std::int8_t, std::size_t, std::uint32_t, std::uint8_t;

METHOD(HardwareSerial, void, begin, unsigned long, uint32_t, int8_t, int8_t, bool, unsigned long, uint8_t);
METHOD(HardwareSerial, bool, setPins, int8_t, int8_t, int8_t, int8_t);
METHOD(HardwareSerial, bool, setMode, SerialMode);
METHOD(HardwareSerial, bool, setRxFIFOFull, uint8_t);
METHOD(HardwareSerial, void, onReceiveError, OnReceiveErrorCb);
METHOD(HardwareSerial, int, available, );
METHOD(HardwareSerial, int, read, );
METHOD(HardwareSerial, void, flush, );
METHOD(HardwareSerial, size_t, write, uint8_t const*, size_t);
static_assert(std::is_same_v<OnReceiveErrorCb, std::function<void(hardwareSerial_error_t)>>);
VALUE(UART_NO_ERROR, 0);
VALUE(UART_BREAK_ERROR, 1);
VALUE(UART_BUFFER_FULL_ERROR, 2);
VALUE(UART_FIFO_OVF_ERROR, 3);
VALUE(UART_FRAME_ERROR, 4);
VALUE(UART_PARITY_ERROR, 5);
VALUE(UART_MODE_UART, 0);
VALUE(UART_MODE_RS485_HALF_DUPLEX, 1);
VALUE(SERIAL_8E1, 0x800001E);
DECLARES(micros, unsigned long());
DECLARES(delay, void(uint32_t));
DECLARES(setup, void());
DECLARES(loop, void());
static_assert(std::is_same_v<decltype(Serial1), HardwareSerial>);

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// arduino/ArduinoCore-API 1.5.2, api/HardwareSerial.h, Stream.h, Print.h and Common.h; earlephilhower/arduino-pico has its Serial1.
#include <Arduino.h>

#include "facts.hpp"

using std::size_t, std::uint16_t, std::uint8_t;

static_assert(std::is_base_of_v<Stream, HardwareSerial> and std::is_base_of_v<Print, Stream>);
static_assert(std::is_convertible_v<decltype((Serial1)), Stream&>);
METHOD(HardwareSerial, void, begin, unsigned long, uint16_t);
METHOD(Stream, int, available, );
METHOD(Stream, int, read, );
METHOD(Print, void, flush, );
METHOD(Print, size_t, write, uint8_t);
METHOD(Print, size_t, write, uint8_t const*, size_t);
OVERLOAD(pinMode, void (*)(pin_size_t, PinMode));
OVERLOAD(digitalWrite, void (*)(pin_size_t, PinStatus));
DECLARES(micros, unsigned long());
DECLARES(delay, void(unsigned long));
DECLARES(setup, void());
DECLARES(loop, void());
static_assert(std::is_same_v<pin_size_t, uint8_t>);
VALUE(LOW, 0);
VALUE(HIGH, 1);
VALUE(INPUT, 0);
VALUE(OUTPUT, 1);
VALUE(SERIAL_8E1, 0x411);

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The few functions of Arduino that the page calls, with a simulated drive behind them.
#pragma once

#include "far_drive.hpp"

enum { OUTPUT, LOW, HIGH, SERIAL_8E1 };

struct serial_stand_in {
    void begin(unsigned long, int) {}
    [[nodiscard]] bool available() const { return stand_in::line.has_byte(); }
    int read() { return std::to_integer<int>(stand_in::line.take()); }
    void write(std::uint8_t const* bytes, std::size_t size)
    {
        std::array<std::byte, 256> frame{};
        for (std::size_t i = 0; i < size; ++i) {
            frame[i] = static_cast<std::byte>(bytes[i]);
        }
        stand_in::line.send(rtuwire::byte_view{frame}.first(size));
    }
    void flush() {}
};
inline serial_stand_in Serial1;

inline void pinMode(int, int) {}
inline void digitalWrite(int, int) {}
inline std::uint32_t micros() { return stand_in::line.now().microseconds; }

using stand_in::show; // what the page leaves to its reader

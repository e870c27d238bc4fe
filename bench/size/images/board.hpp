// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// As little of a board as an image needs to be a whole program: a UART, a clock, a console. What it
// costs is in empty.cpp too, and so in no difference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/time.hpp>

namespace board {

inline std::uint32_t volatile& at(std::uintptr_t address)
{
    return *reinterpret_cast<std::uint32_t volatile*>(address);
}
inline bool has_byte() { return (at(0x4000'4004) & 2U) != 0; }
inline bool is_damaged() { return (at(0x4000'4008) & 1U) != 0; }
inline std::byte byte() { return static_cast<std::byte>(at(0x4000'4000)); }
inline void put(std::byte byte)
{
    while ((at(0x4000'4004) & 1U) != 0) {
    }
    at(0x4000'4000) = static_cast<std::uint32_t>(byte);
}
inline void put(std::span<std::byte const> bytes)
{
    for (std::byte const each : bytes) {
        put(each);
    }
}
inline rtuwire::instant now() { return rtuwire::instant{at(0x4000'0008)}; }

/// Sets the timer that wakes the processor; without a time, only the UART wakes it.
inline void sleep_until(rtuwire::deadline const& next)
{
    at(0x4000'000C) = next ? next->microseconds : 0;
    at(0x4000'0010) = next ? 1 : 0;
}

/// Hands to a client or a server what the line did, and to the line what it says, and sleeps: the calls of
/// a firmware's loop. A function of its own, so that its stack is seen.
template <typename Engine> [[gnu::noinline]] void pass(Engine& engine)
{
    rtuwire::instant const now = board::now();
    if (has_byte()) {
        bool const is_good = not is_damaged();
        std::byte const byte = board::byte();
        if (is_good) {
            engine.receive(byte, now);
        } else {
            engine.receive_error(now);
        }
    }
    engine.advance(now);
    if (auto const frame = engine.poll_transmit(); not frame.empty()) {
        put(frame);
        engine.sent(board::now());
    }
    sleep_until(engine.poll_deadline());
}

} // namespace board

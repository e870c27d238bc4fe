// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The baseline: the CRC as most stacks have it, a byte at a time from one table for each half. And how a
// form is held against it.
#pragma once

#include <array>
#include <cstdint>

#include <benchmark/benchmark.h>

#include <rtuwire/core/crc16.hpp>

namespace bench {

struct two_tables {
    std::array<std::uint8_t, 256> low{};
    std::array<std::uint8_t, 256> high{};
};

constexpr two_tables make_two_tables()
{
    two_tables made;
    for (std::size_t i = 0; i < 256; ++i) {
        made.low[i] =
            static_cast<std::uint8_t>(rtuwire::detail::crc16_tables::of_byte(static_cast<std::uint32_t>(i)) & 0xFFU);
        made.high[i] =
            static_cast<std::uint8_t>(rtuwire::detail::crc16_tables::of_byte(static_cast<std::uint32_t>(i)) >> 8U);
    }
    return made;
}
inline constexpr two_tables halves = make_two_tables();

[[gnu::noinline]] inline std::uint16_t crc_by_two_tables(rtuwire::byte_view bytes)
{
    std::uint8_t low = 0xFF;
    std::uint8_t high = 0xFF;
    for (std::byte const byte : bytes) {
        std::size_t const index = low ^ rtuwire::detail::to_u8(byte);
        low = static_cast<std::uint8_t>(high ^ halves.low[index]);
        high = halves.high[index];
    }
    return static_cast<std::uint16_t>(low | high << 8U);
}

/// What the forms are run over.
inline std::array<std::byte, 4'096 + 8> bytes{};

/// Each call waits for the one before, as a receiver's does.
inline void latency(benchmark::State& state, std::uint16_t (*crc)(rtuwire::byte_view))
{
    auto const size = static_cast<std::size_t>(state.range(0));
    std::uint32_t last = 0;
    std::uint32_t none = 0;
    benchmark::DoNotOptimize(none);
    for (auto _ : state) {
        last = crc(rtuwire::byte_view{bytes}.subspan(last & none, size));
    }
    benchmark::DoNotOptimize(last);
}

} // namespace bench

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request to a bank of a thousand typed registers, so that its instructions can be counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "../compile/codes.hpp"

#include <rtuwire/core/crc16.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/typed_bank.hpp>

namespace operations {

using namespace rtuwire;
using namespace rtuwire::detail;

template <unsigned Address>
inline constexpr reg<decihertz> one{.code = code<Address>, .address = Address, .min = 0, .max = 5'000};
template <std::size_t... I> bank<one<100 + I>...> bank_of(std::index_sequence<I...>);

struct memory {
    decltype(bank_of(std::make_index_sequence<1'000>{})) bank{};
    std::array<std::byte, max_adu_size> frame{};
    std::size_t sum{0};
};
inline memory all;

/// Puts a read of 100 registers from address 256 on where a receiver would have left it.
[[gnu::noinline]] inline void receive_read_100()
{
    byte_writer out{all.frame};
    out.u16(0x0103);
    out.u16(256);
    out.u16(100);
    std::uint16_t const crc = crc16(out.written());
    out.u8(crc);
    out.u8(std::uint32_t{crc} >> 8U);
    asm volatile("" ::: "memory");
}
[[gnu::noinline]] inline void serve_read_100_of_1000()
{
    static constexpr server_profile profile{};
    receive_read_100();
    no_diagnostics none;
    all.sum = all.sum + response_frame(all.frame, 8, unit_id{1}, all.bank, profile, none).size();
}

/// Whether all 100 registers are answered.
inline bool are_right()
{
    all.sum = 0;
    serve_read_100_of_1000();
    return all.sum == 205;
}

struct operation {
    char const* name;
    void (*run)();
    void (*less)(); ///< what is measured with it and does not count
};

inline constexpr operation list[] = {{"serve_read_100_of_1000", serve_read_100_of_1000, receive_read_100}};

} // namespace operations

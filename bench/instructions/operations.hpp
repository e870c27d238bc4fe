// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a stack does all day, one function each, so that their instructions can be counted one by one. No
// compiler sees through them: they are not inlined, and their bytes are variables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/response.hpp>

namespace operations {

using namespace rtuwire;
using namespace rtuwire::detail;

inline constexpr unit_id address{1};
inline constexpr server_profile profile{};

inline constexpr auto read_4 = "01 03 00 01 00 04 15 C9"_hex;
inline constexpr auto write_4 = "01 10 00 01 00 04 08 00 01 00 02 00 03 00 04 D3 7A"_hex;
inline constexpr auto exchange_4 = "01 17 00 01 00 04 00 01 00 04 08 00 01 00 02 00 03 00 04 2B 29"_hex;

struct memory {
    std::array<std::byte, max_adu_size> frame{};
    std::array<std::byte, 13> response_4{};
    std::array<std::byte, 131> response_63{};
    std::array<std::uint16_t, 125> values{};
    word_bank<16> bank{};
    no_diagnostics line{};
    std::uint32_t sum{0};
    unit_id unit{address};
    std::uint16_t start{3201};
    std::uint16_t quantity{4};
};
inline memory all;

/// A response of function 03 with as many registers as fit.
template <std::size_t Size> void fill(std::array<std::byte, Size>& response)
{
    response[0] = std::byte{1};
    response[1] = std::byte{3};
    response[2] = static_cast<std::byte>(Size - 5);
    static_cast<void>(append_crc(response, Size - adu_overhead));
}

inline void prepare()
{
    fill(all.response_4);
    fill(all.response_63);
}

/// Nothing: what a call costs.
[[gnu::noinline]] inline void nothing() { asm volatile("" ::: "memory"); }

[[gnu::noinline]] inline void encode_read()
{
    auto const frame = encode_into(all.frame, all.unit, read_holding_registers{all.start, all.quantity});
    all.sum = all.sum + (frame ? 1U : 0U);
}

/// A request known when compiling is an array.
[[gnu::noinline]] inline byte_view encode_known()
{
    static constexpr auto frame = *encode(address, read_holding_registers{3201, 4});
    return frame;
}

[[gnu::noinline]] inline void decode(byte_view bytes)
{
    auto const response = decode_adu(bytes);
    if (not response) {
        return;
    }
    auto const read = read_holding_registers_response::decode(response->pdu());
    if (not read) {
        return;
    }
    all.sum = all.sum + read->registers.copy_to(all.values);
}
[[gnu::noinline]] inline void decode_4() { decode(all.response_4); }
[[gnu::noinline]] inline void decode_63() { decode(all.response_63); }

/// Puts a request where a receiver would have left it.
template <std::size_t Size> void receive(std::array<std::byte, Size> const& request)
{
    for (std::size_t i = 0; i < Size; ++i) {
        all.frame[i] = request[i];
    }
    asm volatile("" ::: "memory");
}
template <std::size_t Size> void serve(std::array<std::byte, Size> const& request)
{
    receive(request);
    byte_view const response = response_frame(all.frame, Size, address, all.bank, profile, all.line);
    all.sum = all.sum + response.size();
}
[[gnu::noinline]] inline void receive_read_4() { receive(read_4); }
[[gnu::noinline]] inline void receive_write_4() { receive(write_4); }
[[gnu::noinline]] inline void receive_exchange_4() { receive(exchange_4); }
[[gnu::noinline]] inline void serve_read_4() { serve(read_4); }
[[gnu::noinline]] inline void serve_write_4() { serve(write_4); }
[[gnu::noinline]] inline void serve_exchange_4() { serve(exchange_4); }

[[gnu::noinline]] inline void crc_of_253() { all.sum = all.sum + crc16(byte_view{all.frame}.first(253)); }

/// Whether each does what its name says: a count of refusals would be a low one.
inline bool are_right()
{
    prepare();
    all.sum = 0;
    encode_read();
    serve_read_4();
    serve_write_4();
    serve_exchange_4();
    bool const is_served = all.sum == 1 + 13 + 8 + 13 and all.bank.get(4) == 4;
    fill(all.response_4);
    all.response_4[4] = std::byte{7};
    static_cast<void>(append_crc(all.response_4, 10));
    all.sum = 0;
    decode_4();
    bool const is_read = all.sum == 4 and all.values[0] == 7;
    decode_63();
    return is_served and is_read and all.sum == 4 + 63 and all.values[62] == 0 and
           same_bytes(encode_known().first(3), "01 03 0C"_hex);
}

struct operation {
    char const* name;
    void (*run)();
    void (*less)(); ///< what is measured with it and does not count
};

inline constexpr operation list[] = {
    {"encode_read", encode_read, nothing},
    {"encode_known", [] { static_cast<void>(encode_known()); }, nothing},
    {"decode_4", decode_4, nothing},
    {"decode_63", decode_63, nothing},
    {"serve_read_4", serve_read_4, receive_read_4},
    {"serve_write_4", serve_write_4, receive_write_4},
    {"serve_exchange_4", serve_exchange_4, receive_exchange_4},
    {"crc_of_253", crc_of_253, nothing},
};

} // namespace operations

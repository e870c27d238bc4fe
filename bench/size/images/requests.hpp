// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The five requests of the client images, and what comes of their responses.
#pragma once

#include "board.hpp"

#include <array>

#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/response.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

inline constexpr rtuwire::unit_id address{1};
inline constexpr rtuwire::register_block<4> words{1, 2, 3, 4};

/// The five as constants.
namespace known {
using namespace rtuwire;
using namespace rtuwire::detail;
inline constexpr auto read = constant_frame([] { return encode(address, read_holding_registers{3201, 4}); });
inline constexpr auto write = constant_frame([] { return encode(address, write_single_register{8501, 6}); });
inline constexpr auto write_4 = constant_frame([] { return encode(address, write_multiple_registers{8501, words}); });
inline constexpr auto exchange = constant_frame([] {
    return encode(address, read_write_multiple_registers{3201, 4, 8501, words});
});
inline constexpr auto identify = constant_frame([] { return encode(address, read_device_identification{}); });
inline constexpr byte_view requests[] = {read, write, write_4, exchange, identify};
} // namespace known

/// The number of the request that comes after another one.
constexpr unsigned next(unsigned number) { return number < 4 ? number + 1 : 0; }

/// Writes one of the five into a place of 32 bytes.
[[gnu::noinline]] inline rtuwire::byte_view request(rtuwire::byte_span place, unsigned number)
{
    using namespace rtuwire;
    switch (number) {
    case 0: return *encode_into(place, address, read_holding_registers{3201, 4});
    case 1: return *encode_into(place, address, write_single_register{8501, 6});
    case 2: return *encode_into(place, address, write_multiple_registers{8501, words});
    case 3: return *encode_into(place, address, read_write_multiple_registers{3201, 4, 8501, words});
    default: break;
    }
    return *encode_into(place, address, read_device_identification{});
}

/// A value out of a response that was held against its request.
[[gnu::noinline]] inline std::uint32_t value_in(rtuwire::byte_view pdu, unsigned number)
{
    using namespace rtuwire;
    if (number == 0) {
        auto const read = read_holding_registers_response::decode(pdu);
        return read ? read->registers[0] : 0U;
    }
    if (number == 3) {
        auto const read = read_write_multiple_registers_response::decode(pdu);
        return read ? read->registers[0] : 0U;
    }
    if (number == 4) {
        auto const page = device_identification::decode(pdu);
        auto const first = page ? page->first() : std::nullopt;
        return first ? first->value.size() : 0U;
    }
    return 0;
}

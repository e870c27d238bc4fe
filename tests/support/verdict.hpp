// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client's check says of a response.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/wire/response.hpp>

namespace rtuwire::test {

using namespace detail;

/// Of a response whose CRC nobody looks at any more.
constexpr errc verdict(byte_view request, byte_view response_pdu, std::uint8_t unit = 2)
{
    std::array<std::byte, max_adu_size> place{};
    byte_writer out{place};
    out.u8(unit);
    out.bytes(response_pdu);
    return check_response(request, adu{byte_view{place}.first(response_pdu.size() + adu_overhead)});
}

} // namespace rtuwire::test

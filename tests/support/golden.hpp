// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Golden frames: octets against the value they stand for, both ways.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/wire/adu.hpp>

namespace rtuwire::test {

/// Whether a value encodes to exactly these octets, and they decode to a value that encodes to them.
template <typename To, pdu P, std::size_t Size>
constexpr bool encodes(To to, P const& value, std::array<std::byte, Size> const& octets)
{
    auto const taken = decode_adu(octets);
    if (not taken or not(encode(to, value) == octets)) {
        return false;
    }
    auto const again = P::decode(taken->pdu);
    return again and encode(to, *again) == octets;
}

} // namespace rtuwire::test

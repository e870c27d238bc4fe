// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Encoding into every size of place: what fits is written whole, what does not fit or is not
// allowed leaves every byte as it was.
#pragma once

#include <cstddef>

#include "support/exact.hpp"

#include <rtuwire/wire/adu.hpp>

namespace rtuwire::test {

using namespace detail;

/// Whether a value is refused with this error in a place of this size, which stays untouched.
template <pdu P> constexpr bool is_refused(P const& value, errc expected, std::size_t room = 256)
{
    constexpr std::byte before{0xA5};
    exact_bytes place{room, before};
    if (encode_into(place.span(), unit_id{2}, value).error() != expected) {
        return false;
    }
    for (std::byte const byte : place.view()) {
        if (byte != before) {
            return false;
        }
    }
    return true;
}

/// Whether a value of this size on the line needs exactly that much room: every smaller place is
/// refused, and behind the frame nothing changes.
template <pdu P> constexpr bool needs_room(P const& value, std::size_t size)
{
    constexpr std::byte behind{0x5A};
    for (std::size_t room = 0; room < size; ++room) {
        if (not is_refused(value, errc::buffer_too_small, room)) {
            return false;
        }
    }
    exact_bytes fits{size};
    exact_bytes roomy{size + 1, behind};
    auto const first = encode_into(fits.span(), unit_id{2}, value);
    auto const second = encode_into(roomy.span(), unit_id{2}, value);
    return first and second and first->size() == size and same_bytes(*first, *second) and roomy.view()[size] == behind;
}

/// Whether a value survives the line: the frame decodes, and to a value for which `is_same` holds.
template <pdu P, typename Same> constexpr bool survives(P const& value, Same is_same)
{
    exact_bytes frame{value.size() + adu_overhead};
    if (not encode_into(frame.span(), unit_id{2}, value)) {
        return false;
    }
    auto const taken = decode_adu(frame.view());
    if (not taken or taken->unit() != 2) {
        return false;
    }
    exact_bytes const pdu{taken->pdu()};
    auto const again = P::decode(pdu.view());
    return again and is_same(*again);
}

} // namespace rtuwire::test

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Facts that hold of several functions' requests and responses: their sizes, quantities and byte counts.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "support/encode_space.hpp"
#include "support/random.hpp"

namespace rtuwire::test {

/// Random bytes, and views of their beginning.
struct sample {
    std::array<std::byte, 264> bytes{};

    explicit constexpr sample(std::uint32_t seed) { random{seed}.fill(bytes); }
    [[nodiscard]] constexpr byte_view first(std::size_t size) const { return byte_view{bytes}.first(size); }
};

/// Whether a value goes there and back, and needs a place of exactly its size.
template <pdu P>
    requires std::equality_comparable<P>
constexpr bool goes_there_and_back(P const& value)
{
    return survives(value, [&](auto const& read) { return read == value; }) and
           needs_room(value, value.size() + adu_overhead);
}

/// Whether of these bytes the first `size` are a PDU, and no more and no fewer of them.
template <typename P> constexpr bool has_size(byte_view bytes, std::size_t size)
{
    for (std::size_t taken = 0; taken <= bytes.size(); ++taken) {
        exact_bytes const part{bytes.first(taken)};
        errc const expected = taken == 0 ? errc::wrong_function : taken == size ? errc::none : errc::wrong_length;
        if (P::decode(part.view()).error() != expected) {
            return false;
        }
    }
    return true;
}

/// Whether PDUs of a start and a quantity are written with 1 to `most`, and with no other quantity.
template <pdu P> constexpr bool counts_to(std::uint32_t most)
{
    for (std::uint32_t const count : {0U, 1U, 2U, most - 1, most, most + 1, 0x7FFFU, 0x8000U, 0xFFFFU}) {
        P const value{0, static_cast<std::uint16_t>(count)};
        bool const is_right =
            count >= 1 and count <= most ? goes_there_and_back(value) : is_refused(value, errc::invalid_quantity);
        if (not is_right) {
            return false;
        }
    }
    return true;
}

/// Whether a request reaches address 65535 and nothing past it.
template <pdu P> constexpr bool reaches_the_last_address(std::uint32_t most)
{
    for (std::uint32_t count = 1; count <= most; ++count) {
        auto const quantity = static_cast<std::uint16_t>(count);
        P const last{static_cast<std::uint16_t>(0x1'0000 - count), quantity};
        P const past{static_cast<std::uint16_t>(0x1'0001 - count), quantity};
        if (last.check() != errc::none or (count > 1 and past.check() != errc::invalid_address_range)) {
            return false;
        }
    }
    return true;
}

/// Of how many quantities, of all 65536, a PDU of start and quantity is read otherwise than it should be.
template <typename P> unsigned misread_quantities(std::uint32_t most)
{
    unsigned wrong = 0;
    for (std::uint32_t count = 0; count <= 0xFFFF; ++count) {
        std::array<std::byte, 5> const pdu{to_byte(to_u8(P::code)), {}, {}, to_byte(count >> 8U), to_byte(count)};
        errc const expected = count >= 1 and count <= most ? errc::none : errc::invalid_quantity;
        wrong += P::decode(pdu).error() == expected ? 0U : 1U;
    }
    return wrong;
}

/// How many PDUs of a byte count and bytes are read otherwise than `expected(byte count, PDU)` says, at every byte
/// count and every size. Where size and byte count disagree, it is `wrong_length`.
template <typename P, typename Expected> unsigned misread_byte_counts(sample some, Expected expected)
{
    some.bytes[0] = to_byte(to_u8(P::code));
    unsigned wrong = 0;
    for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
        some.bytes[1] = to_byte(byte_count);
        for (std::size_t size = 1; size <= some.bytes.size(); ++size) {
            exact_bytes const pdu{some.first(size)};
            errc const told = size == 2 + byte_count ? expected(byte_count, pdu.view()) : errc::wrong_length;
            wrong += P::decode(pdu.view()).error() == told ? 0U : 1U;
        }
    }
    return wrong;
}

} // namespace rtuwire::test

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the server's half of several functions has in common. Such a half is a template over what the server gives it:
// the request's memory, which the response replaces, and `at` with the server's bank, counters, profile and a writer.
// What it appends to the writer is the response behind a byte count, which the server writes; where it appends nothing,
// the response stands in the memory. It returns the exception to send, or none. The request has the size that the
// function's length rule tells, where it tells one.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Answers a request for bits, from the bank that has them. One body for functions 01 and 02, since it is no template
/// over the request.
template <typename Bits>
[[nodiscard]] constexpr errc respond_with_bits(byte_view pdu, Bits& bank, byte_writer& out) noexcept
{
    std::uint16_t const start = u16_at(pdu, 1);
    std::uint16_t const count = u16_at(pdu, 3);
    if (not is_quantity(count, max_bit_quantity)) {
        return errc::illegal_data_value;
    }
    if (errc const wrong = bank.check_read(start, count); wrong != errc::none) {
        return wrong;
    }
    while (out.size() < bytes_of_bits(count)) {
        out.u8(0);
    }
    return bank.read(start, count, out.written());
}

/// Executes a write of bits, whose address stands first. The first five bytes of the request are its response.
template <typename Memory, typename Bits>
[[nodiscard]] constexpr errc write_bits_into(Bits& bank, Memory& pdu, std::size_t values_at, std::size_t count) noexcept
{
    constexpr std::size_t repeated = 5;
    std::uint16_t const start = u16_at(pdu.bytes, 1);
    bit_view const values{pdu.view().subspan(values_at), count};
    if (errc const wrong = bank.check_write(start, values); wrong != errc::none) {
        return wrong;
    }
    pdu.size = repeated;
    return bank.write(start, values);
}

} // namespace rtuwire

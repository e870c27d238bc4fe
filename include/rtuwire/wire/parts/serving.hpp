// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the server's half of several functions has in common. Such a half is a template over what the server gives it:
// the request's memory, which the response replaces, and `at` with the server's bank, counters and profile. It returns
// the exception to send, or none.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Replaces a request for registers by its response, from the bank that has them.
template <typename Request, typename Memory, typename Registers>
[[nodiscard]] constexpr errc respond_with_registers(Memory& pdu, Registers& bank) noexcept
{
    constexpr std::size_t head = 2;
    auto const asked = Request::decode(pdu.view());
    if (not asked) {
        return errc::illegal_data_value;
    }
    if (errc const wrong = bank.check_read(asked->start, asked->count); wrong != errc::none) {
        return wrong;
    }
    byte_writer out{pdu.bytes.subspan(head)};
    if (errc const wrong = bank.read(asked->start, asked->count, out); wrong != errc::none) {
        return wrong;
    }
    pdu.bytes[1] = to_byte(static_cast<std::uint32_t>(out.size()));
    pdu.size = head + out.size();
    return out.size() == std::size_t{2} * asked->count ? errc::none : errc::server_device_failure;
}

/// The same for bits.
template <typename Request, typename Memory, typename Bits>
[[nodiscard]] constexpr errc respond_with_bits(Memory& pdu, Bits& bank) noexcept
{
    constexpr std::size_t head = 2;
    auto const asked = Request::decode(pdu.view());
    if (not asked) {
        return errc::illegal_data_value;
    }
    if (errc const wrong = bank.check_read(asked->start, asked->count); wrong != errc::none) {
        return wrong;
    }
    std::size_t const size = bytes_of_bits(asked->count);
    byte_span const out = byte_span{pdu.bytes}.subspan(head, size);
    for (std::byte& each : out) {
        each = std::byte{0};
    }
    pdu.bytes[1] = to_byte(static_cast<std::uint32_t>(size));
    pdu.size = head + size;
    return bank.read(asked->start, asked->count, out);
}

/// Executes a write of bits. The first five bytes of the request are its response.
template <typename Memory, typename Bits>
[[nodiscard]] constexpr errc write_into(Memory& pdu, Bits& bank, std::uint16_t start, bit_view values) noexcept
{
    constexpr std::size_t repeated = 5;
    if (errc const wrong = bank.check_write(start, values); wrong != errc::none) {
        return wrong;
    }
    errc const wrong = bank.write(start, values);
    pdu.size = repeated;
    return wrong;
}

} // namespace rtuwire

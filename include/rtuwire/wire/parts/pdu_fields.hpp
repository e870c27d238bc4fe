// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What several functions' PDUs have in common: two fields behind the function, and a run of registers or bits behind a
// byte count.
// Internal: may change with any version.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether a run of `count` from `start` may be asked: `invalid_quantity`, `invalid_address_range` or none.
[[nodiscard]] constexpr errc check_run(std::uint16_t start, std::size_t count, std::size_t most) noexcept
{
    if (not is_quantity(count, most)) {
        return errc::invalid_quantity;
    }
    return is_address_range(start, count) ? errc::none : errc::invalid_address_range;
}

/// Whether a PDU is of this function and size: `wrong_function`, `wrong_length` or none.
[[nodiscard]] constexpr errc check_size(byte_view pdu, function_code code, std::size_t size) noexcept
{
    if (not is_pdu_of(pdu, code)) {
        return errc::wrong_function;
    }
    return pdu.size() == size ? errc::none : errc::wrong_length;
}

/// A decoded PDU, or what its own check finds.
template <typename Pdu> [[nodiscard]] constexpr result<Pdu> checked_pdu(Pdu const& read) noexcept
{
    if (errc const wrong = read.check(); wrong != errc::none) {
        return wrong;
    }
    return read;
}

/// Reads a request of two fields, a start and a quantity of 1..most. Errors: those of `check_size`, and
/// `invalid_quantity`.
template <typename Request> [[nodiscard]] constexpr result<Request> decode_run(byte_view pdu, std::size_t most) noexcept
{
    if (errc const wrong = check_size(pdu, Request::code, Request::max_size); wrong != errc::none) {
        return wrong;
    }
    std::uint16_t const count = u16_at(pdu, 3);
    if (not is_quantity(count, most)) {
        return errc::invalid_quantity;
    }
    return Request{u16_at(pdu, 1), count};
}

/// The bytes behind a byte count that is all there is: function, count, bytes. Errors: `wrong_function`, `wrong_length`.
[[nodiscard]] constexpr result<byte_view> decode_counted(byte_view pdu, function_code code) noexcept
{
    constexpr std::size_t head = 2;
    if (not is_pdu_of(pdu, code)) {
        return errc::wrong_function;
    }
    if (pdu.size() < head or pdu.size() != head + to_u8(pdu[1])) {
        return errc::wrong_length;
    }
    return byte_view{pdu.data() + head, pdu.size() - head};
}

/// Writes a function, a byte count and the bytes.
constexpr void write_counted(byte_writer& out, function_code code, byte_view bytes) noexcept
{
    out.u8(to_u8(code));
    out.u8(static_cast<std::uint32_t>(bytes.size()));
    out.bytes(bytes);
}

/// Writes a byte count and bits; what is left of the last byte is 0.
constexpr void write_bits(byte_writer& out, bit_view bits) noexcept
{
    std::size_t const size = bytes_of_bits(bits.size());
    std::byte* const at = out.take(1 + size);
    if (at == nullptr) {
        return;
    }
    at[0] = to_byte(static_cast<std::uint32_t>(size));
    for (std::size_t i = 0; i < size; ++i) {
        at[1 + i] = bits.bytes()[i];
    }
    for (std::size_t i = bits.size(); i < 8 * size; ++i) {
        put_bit(byte_span{at + 1, size}, i, false);
    }
}

/// The same behind a function.
constexpr void write_bits(byte_writer& out, function_code code, bit_view bits) noexcept
{
    out.u8(to_u8(code));
    write_bits(out, bits);
}

/// The most bytes that a request's bits can have; see `bytes_at_most`.
template <typename Bits> inline constexpr std::size_t bytes_of_bits_at_most = bytes_of_bits(max_bit_write_quantity);
template <std::size_t Count>
inline constexpr std::size_t bytes_of_bits_at_most<bit_block<Count>> = bytes_of_bits(Count < max_bit_write_quantity
                                                                                         ? Count
                                                                                         : max_bit_write_quantity);

/// Reads a response of bits: the eightfold of its bytes, of which the request counted at least one in the last byte.
/// Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
template <typename Response> [[nodiscard]] constexpr result<Response> decode_bits(byte_view pdu) noexcept
{
    auto const bytes = decode_counted(pdu, Response::code);
    if (not bytes) {
        return bytes.error();
    }
    if (not is_quantity(bytes->size(), bytes_of_bits(max_bit_quantity))) {
        return errc::invalid_quantity;
    }
    return Response{bit_view{*bytes, 8 * bytes->size()}};
}

} // namespace rtuwire

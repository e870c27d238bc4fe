// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What several functions' PDUs have in common: two fields behind the function, bytes behind a byte count, and the
// responses that have one form: registers that were read, and a run that was written. Each function has a type of its
// own of them.
//
// A function's `respond` is the server's half, a template over what the server gives it: the request's memory, which
// the response replaces, and `at` with the server's bank, counters, profile and a writer. What it appends to the writer
// is the response behind a byte count, which the server writes; where it appends nothing, the response stands in the
// memory. It returns the exception to send, or none. The request has the size that the function's length rule tells,
// where it tells one.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

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

/// Decodes the response of function 03, 04 or 23 in a PDU: a byte count and as many bytes, two for each of 1..125
/// registers. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
template <typename Response>
[[nodiscard]] constexpr result<Response> decode_registers(byte_view pdu, function_code function) noexcept
{
    constexpr std::size_t head = 2;
    if (not is_pdu_of(pdu, function)) {
        return errc::wrong_function;
    }
    std::size_t const bytes = pdu.size() < head ? 1U : to_u8(pdu[1]);
    if (pdu.size() != head + bytes or bytes % 2 != 0) {
        return errc::wrong_length;
    }
    if (not is_quantity(bytes / 2, max_read_quantity)) {
        return errc::invalid_quantity;
    }
    return Response{register_view{byte_view{pdu.data() + head, bytes}}};
}

} // namespace detail

static_assert(max_exchange_read_quantity == max_read_quantity, "functions 03 and 23 read as many registers");

namespace detail {

/// A response to function 03, 04 or 23: 1 to 125 registers behind a byte count.
template <function_code Function> struct registers_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 2U + 2U * max_read_quantity;

    /// In wire order; after decoding, a view of the received bytes.
    register_view registers;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(registers.size(), max_read_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + registers.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, registers.bytes()); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<registers_response> decode(byte_view pdu) noexcept
    {
        return decode_registers<registers_response>(pdu, code);
    }
};

/// A response to function 15 or 16: what was written where, without the values; at most `Most`.
template <function_code Function, std::uint16_t Most> struct written_run_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..Most

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(count, Most) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<written_run_response> decode(byte_view pdu) noexcept
    {
        return decode_run<written_run_response>(pdu, Most);
    }

    friend constexpr bool operator==(written_run_response const&, written_run_response const&) = default;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

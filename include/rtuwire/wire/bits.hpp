// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The functions of bits (AP 6.1, 6.2, 6.5, 6.11): 01 and 02, read coils and discrete inputs; 05 and 15, write one coil
// and several.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

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

/// Writes a function, a byte count and bits.
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

} // namespace detail

/// The response to function 01: coils in whole bytes, so there may be up to seven more than were requested.
struct read_coils_response {
    static constexpr function_code code = function_code::read_coils;
    static constexpr std::size_t max_size = 2U + detail::bytes_of_bits(max_bit_quantity);

    /// In wire order; after decoding, a view of the received bytes.
    bit_view coils;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::is_quantity(coils.size(), max_bit_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + coils.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { detail::write_bits(out, code, coils); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_coils_response> decode(byte_view pdu) noexcept
    {
        return detail::decode_bits<read_coils_response>(pdu);
    }
};

/// Reads `count` coils of one unit from address `start`.
struct read_coils {
    using response = read_coils_response;
    static constexpr function_code code = function_code::read_coils;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::byte_count, 5),
                                               detail::answer_rule::bits};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..2000

    [[nodiscard]] constexpr errc check() const noexcept { return detail::check_run(start, count, max_bit_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_coils> decode(byte_view pdu) noexcept
    {
        return detail::decode_run<read_coils>(pdu, max_bit_quantity);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.coils(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 01 needs a bank with coils()");
        return detail::respond_with_bits(pdu.view(), at.bank.coils(), at.out);
    }

    friend constexpr bool operator==(read_coils const&, read_coils const&) = default;
};

/// The response to function 02: discrete inputs in whole bytes, so there may be up to seven more than were requested.
struct read_discrete_inputs_response {
    static constexpr function_code code = function_code::read_discrete_inputs;
    static constexpr std::size_t max_size = 2U + detail::bytes_of_bits(max_bit_quantity);

    /// In wire order; after decoding, a view of the received bytes.
    bit_view inputs;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::is_quantity(inputs.size(), max_bit_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + inputs.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { detail::write_bits(out, code, inputs); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_discrete_inputs_response> decode(byte_view pdu) noexcept
    {
        return detail::decode_bits<read_discrete_inputs_response>(pdu);
    }
};

/// Reads `count` discrete inputs of one unit from address `start`.
struct read_discrete_inputs {
    using response = read_discrete_inputs_response;
    static constexpr function_code code = function_code::read_discrete_inputs;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::byte_count, 5),
                                               detail::answer_rule::bits};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..2000

    [[nodiscard]] constexpr errc check() const noexcept { return detail::check_run(start, count, max_bit_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_discrete_inputs> decode(byte_view pdu) noexcept
    {
        return detail::decode_run<read_discrete_inputs>(pdu, max_bit_quantity);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.discrete_inputs(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 02 needs a bank with discrete_inputs()");
        return detail::respond_with_bits(pdu.view(), at.bank.discrete_inputs(), at.out);
    }

    friend constexpr bool operator==(read_discrete_inputs const&, read_discrete_inputs const&) = default;
};

/// Switches one coil of one unit or of all; the response repeats it.
struct write_single_coil {
    using response = write_single_coil;
    static constexpr function_code code = function_code::write_single_coil;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::fixed, 8), detail::answer_rule::head};
    static constexpr std::size_t max_size = 5;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    bool value;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, address, value ? on : 0U); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for a value other than FF00 and 0000.
    [[nodiscard]] static constexpr result<write_single_coil> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        std::uint16_t const value = detail::u16_at(pdu, 3);
        if (not is_value(value)) {
            return errc::malformed;
        }
        return write_single_coil{detail::u16_at(pdu, 1), value == on};
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.coils(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 05 needs a bank with coils()");
        constexpr std::size_t value_at = 3;
        std::uint16_t const value = detail::u16_at(pdu.bytes, value_at);
        if (not is_value(value)) {
            return errc::illegal_data_value;
        }
        // The first bit of FF or of 00.
        return detail::write_bits_into(at.bank.coils(), pdu, value_at, 1);
    }

    friend constexpr bool operator==(write_single_coil const&, write_single_coil const&) = default;

private:
    static constexpr std::uint16_t on = 0xFF00;

    static constexpr bool is_value(std::uint16_t value) noexcept { return value == on or value == 0; }
};

/// The response to function 15: `start` and `count` of what was written, without the values.
using write_multiple_coils_response =
    detail::written_run_response<function_code::write_multiple_coils, max_bit_write_quantity>;

/// Switches coils from address `start` on, of one unit or of all. Made of a block, it owns that block; made of a view,
/// its bits are stored elsewhere.
template <typename Bits = bit_view> struct write_multiple_coils {
    using response = write_multiple_coils_response;
    static constexpr function_code code = function_code::write_multiple_coils;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::byte_count, 9),
                                               detail::sized(detail::length_rule::fixed, 8), detail::answer_rule::head};
    static constexpr std::size_t max_size = 6U + detail::bytes_of_bits_at_most<Bits>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t start;
    /// 1..1968 in wire order; after decoding, a view of the received bytes.
    Bits values;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::check_run(start, values.size(), max_bit_write_quantity);
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 6 + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, code, start, static_cast<std::uint32_t>(values.size()));
        detail::write_bits(out, bit_view{values});
    }

    /// Reads a PDU; quantity, byte count and size must all agree. Errors: `wrong_function`, `wrong_length`,
    /// `invalid_quantity`.
    [[nodiscard]] static constexpr result<write_multiple_coils<>> decode(byte_view pdu) noexcept
    {
        if (not detail::is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != head + detail::to_u8(pdu[5])) {
            return errc::wrong_length;
        }
        if (errc const wrong = check_quantity(pdu); wrong != errc::none) {
            return wrong;
        }
        return write_multiple_coils<>{detail::u16_at(pdu, 1), bit_view{pdu.subspan(head), detail::u16_at(pdu, 3)}};
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.coils(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 15 needs a bank with coils()");
        if (check_quantity(pdu.view()) != errc::none) {
            return errc::illegal_data_value;
        }
        return detail::write_bits_into(at.bank.coils(), pdu, head, detail::u16_at(pdu.bytes, 3));
    }

private:
    static constexpr std::size_t head = 6;

    /// Whether the quantity of a PDU of at least the head is allowed, and is that of its bytes.
    static constexpr errc check_quantity(byte_view pdu) noexcept
    {
        std::size_t const count = detail::u16_at(pdu, 3);
        if (not detail::is_quantity(count, max_bit_write_quantity)) {
            return errc::invalid_quantity;
        }
        return pdu.size() == head + detail::bytes_of_bits(count) ? errc::none : errc::wrong_length;
    }
};

write_multiple_coils(std::uint16_t, bit_view)->write_multiple_coils<>;
template <std::size_t Count>
write_multiple_coils(std::uint16_t, bit_block<Count>) -> write_multiple_coils<bit_block<Count>>;

template <typename Left, typename Right>
constexpr bool operator==(write_multiple_coils<Left> const& left, write_multiple_coils<Right> const& right) noexcept
{
    return left.start == right.start and bit_view{left.values} == bit_view{right.values};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

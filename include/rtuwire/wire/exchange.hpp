// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 23, read/write multiple registers (AP 6.17): the server writes first, then reads.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/pdu_fields.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The response to function 23: the `registers` read after the write.
using read_write_multiple_registers_response = detail::registers_response<function_code::read_write_multiple_registers>;

/// Writes registers of one unit from `write_start`, then reads `read_count` from `read_start`. Made of a block,
/// it owns that block; made of a view, its words are stored elsewhere.
template <typename Words = register_view> struct read_write_multiple_registers {
    using response = read_write_multiple_registers_response;
    static constexpr function_code code = function_code::read_write_multiple_registers;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::byte_count, 13),
                                               detail::sized(detail::length_rule::byte_count, 5),
                                               detail::answer_rule::registers};
    static constexpr std::size_t max_size = 10U + detail::bytes_at_most<Words, max_exchange_write_quantity>;

    std::uint16_t read_start;
    std::uint16_t read_count; ///< 1..125
    std::uint16_t write_start;
    /// 1..121 in wire order; after decoding, a view of the received bytes.
    Words values;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (not detail::is_quantity(read_count, max_exchange_read_quantity) or
            not detail::is_quantity(values.size(), max_exchange_write_quantity)) {
            return errc::invalid_quantity;
        }
        return detail::is_address_range(read_start, read_count) and detail::is_address_range(write_start, values.size())
                   ? errc::none
                   : errc::invalid_address_range;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 10 + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, function_code::read_write_multiple_registers, read_start, read_count);
        out.u16(write_start);
        out.u16(static_cast<std::uint32_t>(values.size()));
        out.u8(static_cast<std::uint32_t>(values.bytes().size()));
        out.bytes(values.bytes());
    }

    /// Reads a PDU; both quantities, byte count and size must all agree. Errors: `wrong_function`,
    /// `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_write_multiple_registers<>> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 10;
        if (not detail::is_pdu_of(pdu, function_code::read_write_multiple_registers)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != head + detail::to_u8(pdu[9])) {
            return errc::wrong_length;
        }
        std::size_t const write_count = detail::u16_at(pdu, 7);
        std::uint16_t const read_count = detail::u16_at(pdu, 3);
        if (not detail::is_quantity(read_count, max_exchange_read_quantity) or
            not detail::is_quantity(write_count, max_exchange_write_quantity)) {
            return errc::invalid_quantity;
        }
        if (pdu.size() != head + 2 * write_count) {
            return errc::wrong_length;
        }
        return read_write_multiple_registers<>{detail::u16_at(pdu, 1), read_count, detail::u16_at(pdu, 5),
                                               register_view{pdu.subspan(head)}};
    }
};

read_write_multiple_registers(std::uint16_t, std::uint16_t, std::uint16_t, register_view)
    ->read_write_multiple_registers<>;
template <std::size_t Count>
read_write_multiple_registers(std::uint16_t, std::uint16_t, std::uint16_t, register_block<Count>)
    -> read_write_multiple_registers<register_block<Count>>;

template <typename Left, typename Right>
constexpr bool operator==(read_write_multiple_registers<Left> const& left,
                          read_write_multiple_registers<Right> const& right) noexcept
{
    return left.read_start == right.read_start and left.read_count == right.read_count and
           left.write_start == right.write_start and detail::same_bytes(left.values.bytes(), right.values.bytes());
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 16, write multiple registers (AP 6.12).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/shared_responses.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 16: `start` and `count` of what was written, without the values.
using write_multiple_registers_response =
    written_run_response<function_code::write_multiple_registers, max_write_quantity>;

/// Writes registers from address `start` on, of one unit or of all. Made of a block, it owns that block; made
/// of a view, its words are stored elsewhere.
template <typename Words = register_view> struct write_multiple_registers {
    using response = write_multiple_registers_response;
    static constexpr function_code code = function_code::write_multiple_registers;
    static constexpr frame_rules rules{sized(length_rule::byte_count, 9), sized(length_rule::fixed, 8),
                                       answer_rule::head};
    static constexpr std::size_t max_size = 6U + bytes_at_most<Words, max_write_quantity>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t start;
    /// 1..123 in wire order; after decoding, a view of the received bytes.
    Words values;

    [[nodiscard]] constexpr errc check() const noexcept { return check_run(start, values.size(), max_write_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 6 + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        write_head(out, code, start, static_cast<std::uint32_t>(values.size()));
        out.u8(static_cast<std::uint32_t>(values.bytes().size()));
        out.bytes(values.bytes());
    }

    /// Reads a PDU; quantity, byte count and size must all agree. Errors: `wrong_function`,
    /// `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<write_multiple_registers<>> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 6;
        if (not is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != head + to_u8(pdu[5])) {
            return errc::wrong_length;
        }
        std::size_t const count = u16_at(pdu, 3);
        if (not is_quantity(count, max_write_quantity)) {
            return errc::invalid_quantity;
        }
        if (pdu.size() != head + 2 * count) {
            return errc::wrong_length;
        }
        return write_multiple_registers<>{u16_at(pdu, 1), register_view{pdu.subspan(head)}};
    }
};

write_multiple_registers(std::uint16_t, register_view)->write_multiple_registers<>;
template <std::size_t Count>
write_multiple_registers(std::uint16_t, register_block<Count>) -> write_multiple_registers<register_block<Count>>;

template <typename Left, typename Right>
constexpr bool operator==(write_multiple_registers<Left> const& left,
                          write_multiple_registers<Right> const& right) noexcept
{
    return left.start == right.start and same_bytes(left.values.bytes(), right.values.bytes());
}

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 15, write multiple coils (AP 6.11).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/serving.hpp>
#include <rtuwire/wire/parts/shared_responses.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 15: `start` and `count` of what was written, without the values.
using write_multiple_coils_response = written_run_response<function_code::write_multiple_coils, max_bit_write_quantity>;

/// Switches coils from address `start` on, of one unit or of all. Made of a block, it owns that block; made of a view,
/// its bits are stored elsewhere.
template <typename Bits = bit_view> struct write_multiple_coils {
    using response = write_multiple_coils_response;
    static constexpr function_code code = function_code::write_multiple_coils;
    static constexpr frame_rules rules{sized(length_rule::byte_count, 9), sized(length_rule::fixed, 8),
                                       answer_rule::head};
    static constexpr std::size_t max_size = 6U + bytes_of_bits_at_most<Bits>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t start;
    /// 1..1968 in wire order; after decoding, a view of the received bytes.
    Bits values;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return check_run(start, values.size(), max_bit_write_quantity);
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 6 + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        write_head(out, code, start, static_cast<std::uint32_t>(values.size()));
        write_bits(out, bit_view{values});
    }

    /// Reads a PDU; quantity, byte count and size must all agree. Errors: `wrong_function`, `wrong_length`,
    /// `invalid_quantity`.
    [[nodiscard]] static constexpr result<write_multiple_coils<>> decode(byte_view pdu) noexcept
    {
        if (not is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != head + to_u8(pdu[5])) {
            return errc::wrong_length;
        }
        if (errc const wrong = check_quantity(pdu); wrong != errc::none) {
            return wrong;
        }
        return write_multiple_coils<>{u16_at(pdu, 1), bit_view{pdu.subspan(head), u16_at(pdu, 3)}};
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
        return write_bits_into(at.bank.coils(), pdu, head, u16_at(pdu.bytes, 3));
    }

private:
    static constexpr std::size_t head = 6;

    /// Whether the quantity of a PDU of at least the head is allowed, and is that of its bytes.
    static constexpr errc check_quantity(byte_view pdu) noexcept
    {
        std::size_t const count = u16_at(pdu, 3);
        if (not is_quantity(count, max_bit_write_quantity)) {
            return errc::invalid_quantity;
        }
        return pdu.size() == head + bytes_of_bits(count) ? errc::none : errc::wrong_length;
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

} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The functions of registers (AP 6.3, 6.4, 6.6, 6.12): 03 and 04, read holding and input registers; 06 and 16, write
// one register and several; 22, change bits of one (AP 6.16); 23, write several, then read several (AP 6.17).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The response to function 03: as many `registers` as were requested.
using read_holding_registers_response = detail::registers_response<function_code::read_holding_registers>;

/// Reads `count` registers of one unit from address `start`.
struct read_holding_registers {
    using response = read_holding_registers_response;
    static constexpr function_code code = function_code::read_holding_registers;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::byte_count, 5),
                                               detail::answer_rule::registers};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..125

    [[nodiscard]] constexpr errc check() const noexcept { return detail::check_run(start, count, max_read_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_holding_registers> decode(byte_view pdu) noexcept
    {
        return detail::decode_run<read_holding_registers>(pdu, max_read_quantity);
    }

    friend constexpr bool operator==(read_holding_registers const&, read_holding_registers const&) = default;
};

/// The response to function 04: as many `registers` as were requested.
using read_input_registers_response = detail::registers_response<function_code::read_input_registers>;

/// Reads `count` input registers of one unit from address `start`.
struct read_input_registers {
    using response = read_input_registers_response;
    static constexpr function_code code = function_code::read_input_registers;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::byte_count, 5),
                                               detail::answer_rule::registers};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..125

    [[nodiscard]] constexpr errc check() const noexcept { return detail::check_run(start, count, max_read_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_input_registers> decode(byte_view pdu) noexcept
    {
        return detail::decode_run<read_input_registers>(pdu, max_read_quantity);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.input_registers(); };

    friend constexpr bool operator==(read_input_registers const&, read_input_registers const&) = default;
};

/// Writes one register of one unit or of all; the response repeats it.
struct write_single_register {
    using response = write_single_register;
    static constexpr function_code code = function_code::write_single_register;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 8),
                                               detail::sized(detail::length_rule::fixed, 8), detail::answer_rule::head};
    static constexpr std::size_t max_size = 5;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    std::uint16_t value;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, address, value); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<write_single_register> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return write_single_register{detail::u16_at(pdu, 1), detail::u16_at(pdu, 3)};
    }

    friend constexpr bool operator==(write_single_register const&, write_single_register const&) = default;
};

/// The response to function 16: `start` and `count` of what was written, without the values.
using write_multiple_registers_response =
    detail::written_run_response<function_code::write_multiple_registers, max_write_quantity>;

/// Writes registers from address `start` on, of one unit or of all. Made of a block, it owns that block; made
/// of a view, its words are stored elsewhere.
template <typename Words = register_view> struct write_multiple_registers {
    using response = write_multiple_registers_response;
    static constexpr function_code code = function_code::write_multiple_registers;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::byte_count, 9),
                                               detail::sized(detail::length_rule::fixed, 8), detail::answer_rule::head};
    static constexpr std::size_t max_size = 6U + detail::bytes_at_most<Words, max_write_quantity>;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t start;
    /// 1..123 in wire order; after decoding, a view of the received bytes.
    Words values;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::check_run(start, values.size(), max_write_quantity);
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 6 + values.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, code, start, static_cast<std::uint32_t>(values.size()));
        out.u8(static_cast<std::uint32_t>(values.bytes().size()));
        out.bytes(values.bytes());
    }

    /// Reads a PDU; quantity, byte count and size must all agree. Errors: `wrong_function`,
    /// `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<write_multiple_registers<>> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 6;
        if (not detail::is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or pdu.size() != head + detail::to_u8(pdu[5])) {
            return errc::wrong_length;
        }
        std::size_t const count = detail::u16_at(pdu, 3);
        if (not detail::is_quantity(count, max_write_quantity)) {
            return errc::invalid_quantity;
        }
        if (pdu.size() != head + 2 * count) {
            return errc::wrong_length;
        }
        return write_multiple_registers<>{detail::u16_at(pdu, 1), register_view{pdu.subspan(head)}};
    }
};

write_multiple_registers(std::uint16_t, register_view)->write_multiple_registers<>;
template <std::size_t Count>
write_multiple_registers(std::uint16_t, register_block<Count>) -> write_multiple_registers<register_block<Count>>;

template <typename Left, typename Right>
constexpr bool operator==(write_multiple_registers<Left> const& left,
                          write_multiple_registers<Right> const& right) noexcept
{
    return left.start == right.start and detail::same_bytes(left.values.bytes(), right.values.bytes());
}

/// Changes single bits of one register of one unit or of all, in one transaction: the register becomes
/// (its value AND `and_mask`) OR (`or_mask` AND NOT `and_mask`). The response repeats the request.
struct mask_write_register {
    using response = mask_write_register;
    static constexpr function_code code = function_code::mask_write_register;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 10),
                                               detail::sized(detail::length_rule::fixed, 10),
                                               detail::answer_rule::whole};
    static constexpr std::size_t max_size = 7;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    std::uint16_t and_mask; ///< 1: the bit stays
    std::uint16_t or_mask;  ///< what a bit that does not stay becomes

    /// The register's value after the write.
    [[nodiscard]] constexpr std::uint16_t applied_to(std::uint16_t value) const noexcept
    {
        return static_cast<std::uint16_t>((value & and_mask) | (or_mask & ~std::uint32_t{and_mask}));
    }

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, code, address, and_mask);
        out.u16(or_mask);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<mask_write_register> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return mask_write_register{detail::u16_at(pdu, 1), detail::u16_at(pdu, 3), detail::u16_at(pdu, 5)};
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        std::uint16_t const address = detail::u16_at(pdu.bytes, 1);
        if (errc const wrong = at.bank.check_read(address, 1); wrong != errc::none) {
            return wrong;
        }
        // The register stands behind the request, which is the response.
        auto const place = pdu.bytes.template subspan<max_size, 2>();
        byte_writer out{place};
        if (errc const wrong = at.bank.read(address, 1, out); wrong != errc::none) {
            return wrong;
        }
        if (out.size() != place.size()) {
            return errc::server_device_failure;
        }
        mask_write_register const asked{address, detail::u16_at(pdu.bytes, 3), detail::u16_at(pdu.bytes, 5)};
        detail::put_u16(place.data(), asked.applied_to(detail::u16_at(place, 0)));
        register_view const value{place};
        if (errc const wrong = at.bank.check_write(address, value); wrong != errc::none) {
            return wrong;
        }
        return at.bank.write(address, value);
    }

    friend constexpr bool operator==(mask_write_register const&, mask_write_register const&) = default;
};

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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 01, read coils (AP 6.1).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/serving.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 01: coils in whole bytes, so there may be up to seven more than were requested.
struct read_coils_response {
    static constexpr function_code code = function_code::read_coils;
    static constexpr std::size_t max_size = 2U + bytes_of_bits(max_bit_quantity);

    /// In wire order; after decoding, a view of the received bytes.
    bit_view coils;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(coils.size(), max_bit_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + coils.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { write_bits(out, code, coils); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_coils_response> decode(byte_view pdu) noexcept
    {
        return decode_bits<read_coils_response>(pdu);
    }
};

/// Reads `count` coils of one unit from address `start`.
struct read_coils {
    using response = read_coils_response;
    static constexpr function_code code = function_code::read_coils;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::byte_count, 5),
                                       answer_rule::bits};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..2000

    [[nodiscard]] constexpr errc check() const noexcept { return check_run(start, count, max_bit_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_coils> decode(byte_view pdu) noexcept
    {
        return decode_run<read_coils>(pdu, max_bit_quantity);
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
        return respond_with_bits(pdu.view(), at.bank.coils(), at.out);
    }

    friend constexpr bool operator==(read_coils const&, read_coils const&) = default;
};

} // namespace rtuwire

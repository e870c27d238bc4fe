// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 02, read discrete inputs (AP 6.2).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/serving.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 02: discrete inputs in whole bytes, so there may be up to seven more than were requested.
struct read_discrete_inputs_response {
    static constexpr function_code code = function_code::read_discrete_inputs;
    static constexpr std::size_t max_size = 2U + bytes_of_bits(max_bit_quantity);

    /// In wire order; after decoding, a view of the received bytes.
    bit_view inputs;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(inputs.size(), max_bit_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + inputs.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { write_bits(out, code, inputs); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_discrete_inputs_response> decode(byte_view pdu) noexcept
    {
        return decode_bits<read_discrete_inputs_response>(pdu);
    }
};

/// Reads `count` discrete inputs of one unit from address `start`.
struct read_discrete_inputs {
    using response = read_discrete_inputs_response;
    static constexpr function_code code = function_code::read_discrete_inputs;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::byte_count, 5),
                                       answer_rule::bits};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..2000

    [[nodiscard]] constexpr errc check() const noexcept { return check_run(start, count, max_bit_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_discrete_inputs> decode(byte_view pdu) noexcept
    {
        return decode_run<read_discrete_inputs>(pdu, max_bit_quantity);
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
        return respond_with_bits(pdu.view(), at.bank.discrete_inputs(), at.out);
    }

    friend constexpr bool operator==(read_discrete_inputs const&, read_discrete_inputs const&) = default;
};

} // namespace rtuwire

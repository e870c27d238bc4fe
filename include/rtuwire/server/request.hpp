// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A request as a server sees it: decoded, and held against what this server can do. The order of the
// checks is that of the specification's diagrams: the function, then its quantities (AP 7).
#pragma once

#include <cstdint>

#include <rtuwire/server/identification.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire {

/// What a server can do. The specification's limits and every function that rtuwire answers, unless
/// a device's manual says less.
struct server_profile {
    function_set functions{all_functions};
    device_limits limits{};
    device_objects identity{}; ///< without objects, function 43 is not supported

    /// Whether the function is one that this server answers.
    [[nodiscard]] constexpr bool supports(function_code function) const noexcept
    {
        bool const can_identify =
            function != function_code::encapsulated_interface or not identity.empty();
        return functions.contains(function) and all_functions.contains(function) and can_identify;
    }
};

/// The registers that a request reads and writes, of functions 03, 06, 16 and 23. A half that the
/// function does not have has quantity 0.
struct register_access {
    std::uint16_t read_start{0};
    std::uint16_t read_count{0};
    std::uint16_t write_start{0};
    register_view values{}; ///< a view of the request's octets

    /// Whether both quantities are within a device's limits.
    [[nodiscard]] constexpr bool is_within(std::uint16_t most_read,
                                           std::uint16_t most_written) const noexcept
    {
        return read_count <= most_read and values.size() <= most_written;
    }
};

/// Decodes functions 03, 06, 16 and 23. Errors: `illegal_data_value` when quantity, byte count and
/// size do not agree or a limit of the device is exceeded.
[[nodiscard]] constexpr result<register_access> decode_access(byte_view pdu,
                                                              device_limits const& limits) noexcept
{
    register_access access;
    bool is_legal = false;
    switch (static_cast<function_code>(to_u8(pdu[0]))) {
    case function_code::read_holding_registers:
        if (auto const asked = read_holding_registers::decode(pdu)) {
            access = {.read_start = asked->start, .read_count = asked->count};
            is_legal = access.is_within(limits.read, 0);
        }
        break;
    case function_code::write_single_register:
        if (write_single_register::decode(pdu)) {
            access = {.write_start = u16_at(pdu, 1), .values = register_view{pdu.subspan(3)}};
            is_legal = true;
        }
        break;
    case function_code::write_multiple_registers:
        if (auto const asked = write_multiple_registers::decode(pdu)) {
            access = {.write_start = asked->start, .values = asked->values};
            is_legal = access.is_within(0, limits.write);
        }
        break;
    case function_code::read_write_multiple_registers:
        if (auto const asked = read_write_multiple_registers::decode(pdu)) {
            access = {asked->read_start, asked->read_count, asked->write_start, asked->values};
            is_legal = access.is_within(limits.exchange_read, limits.exchange_write);
        }
        break;
    case function_code::diagnostics:
    case function_code::encapsulated_interface: break;
    }
    if (not is_legal) {
        return errc::illegal_data_value;
    }
    return access;
}

} // namespace rtuwire

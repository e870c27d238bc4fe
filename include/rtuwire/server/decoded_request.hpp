// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A request as a server sees it: the memory that its response is written over, its head, and the registers that it names,
// decoded and checked against what a device allows: first the function, then its quantities (AP 7).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Holds a request PDU, then its response. A function that responds first reads what it needs of `bytes`, then writes
/// into them and sets `size`; for an error, `execute` does that.
struct pdu_buffer {
    std::span<std::byte, max_pdu_size> bytes;
    std::size_t size; ///< of the request, then of the response: 0 where none is due

    [[nodiscard]] constexpr byte_view view() const noexcept { return bytes.first(size); }
};

/// Whether a request of this function may go to every unit, of these functions.
template <typename... Functions>
[[nodiscard]] constexpr bool may_be_broadcast(function_list<Functions...>, function_code code) noexcept
{
    return ((broadcastable<Functions> and code == Functions::code) or ...);
}

/// The head of a request, decoded once: what executes, refuses and counts it takes this, and reads no byte again.
struct request_head {
    function_code function;
    bool is_broadcast; ///< to every unit: no response is sent

    /// Whether it has an effect on a server of these functions: a broadcast has one with writes only.
    template <typename Functions> [[nodiscard]] constexpr bool has_effect() const noexcept
    {
        return not is_broadcast or may_be_broadcast(Functions{}, function);
    }
};

/// The registers that a request of function 03, 04, 06, 16 or 23 reads and writes. A half that the function does not have
/// has quantity 0.
struct register_access {
    register_view values{}; ///< a view of the request's bytes
    std::size_t read_count{0};
    std::uint16_t write_start{0};
    std::uint16_t read_start{1}; ///< any, without a quantity; GCC zeroes members that are all 0 by a call of memset

    static constexpr std::size_t read_half_size = 4;

    /// Decodes the half that is read: start and quantity.
    constexpr bool take_read(byte_view half, std::size_t limit) noexcept
    {
        if (half.size() < read_half_size) {
            return false;
        }
        read_start = u16_at(half, 0);
        read_count = u16_at(half, 2);
        return is_quantity(read_count, limit);
    }

    /// Decodes one value and its address.
    constexpr bool take_value(byte_view fields) noexcept
    {
        if (fields.size() != 4) {
            return false;
        }
        write_start = u16_at(fields, 0);
        values = register_view{fields.subspan(2)};
        return true;
    }

    /// Decodes the half that is written: start, quantity, byte count, values to the end.
    constexpr bool take_written(byte_view half, std::size_t limit) noexcept
    {
        constexpr std::size_t head = 5;
        if (half.size() < head) {
            return false;
        }
        std::size_t const bytes = half.size() - head;
        write_start = u16_at(half, 0);
        values = register_view{half.subspan(head)};
        // The byte count is a single byte, so the first byte of the quantity is 0.
        return bytes == to_u8(half[4]) and half[2] == std::byte{0} and bytes == 2U * to_u8(half[3]) and
               is_quantity(bytes / 2, limit);
    }
};

/// Decodes the fields of a request of functions 03, 04, 06, 16 and 23, which follow the function, into `access`.
/// `illegal_function` for any other function and for one with a limit of 0; `illegal_data_value` when quantity, byte
/// count and size do not agree or a limit of the device is exceeded; `access` is then undefined.
template <typename Functions>
[[nodiscard]] constexpr errc decode_access(function_code function, byte_view fields, device_limits const& limits,
                                           register_access& access) noexcept
{
    bool const is_input =
        Functions::template contains<read_input_registers> and function == function_code::read_input_registers;
    bool const is_read = function == function_code::read_holding_registers or is_input;
    std::size_t write_limit = 0;
    if (function == function_code::write_single_register) {
        return access.take_value(fields) ? errc::none : errc::illegal_data_value;
    }
    if (is_read or function == function_code::read_write_multiple_registers) {
        std::size_t limit = is_input ? max_read_quantity : limits.read;
        if (not is_read) {
            write_limit = limits.exchange_write;
            limit = write_limit == 0 ? 0 : limits.exchange_read;
        }
        if (limit == 0) {
            return errc::illegal_function;
        }
        if (not access.take_read(fields, limit)) {
            return errc::illegal_data_value;
        }
        fields = fields.subspan(register_access::read_half_size);
        if (is_read) {
            return fields.empty() ? errc::none : errc::illegal_data_value;
        }
    } else {
        write_limit = function == function_code::write_multiple_registers ? limits.write : 0;
        if (write_limit == 0) {
            return errc::illegal_function;
        }
    }
    return access.take_written(fields, write_limit) ? errc::none : errc::illegal_data_value;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

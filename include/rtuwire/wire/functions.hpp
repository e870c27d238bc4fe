// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one list of the functions. A line here makes a function known to the length rules, to the check of responses, to
// broadcasts, to the tests and to the fuzz targets; all that belongs to it alone is in its own file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>
#include <rtuwire/wire/pdu/get_comm_event_counter.hpp>
#include <rtuwire/wire/pdu/get_comm_event_log.hpp>
#include <rtuwire/wire/pdu/mask_write_register.hpp>
#include <rtuwire/wire/pdu/read_coils.hpp>
#include <rtuwire/wire/pdu/read_discrete_inputs.hpp>
#include <rtuwire/wire/pdu/read_exception_status.hpp>
#include <rtuwire/wire/pdu/read_fifo_queue.hpp>
#include <rtuwire/wire/pdu/read_file_record.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_input_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/report_server_id.hpp>
#include <rtuwire/wire/pdu/write_file_record.hpp>
#include <rtuwire/wire/pdu/write_multiple_coils.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_coil.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Functions, each by the type of its request.
template <typename... Functions> struct function_list {
    static constexpr function_set codes{Functions::code...};

    /// Whether a function is in the list.
    template <typename Function> static constexpr bool contains = ((Functions::code == Function::code) or ...);
};

/// Whether a list has a function with this code.
/// Internal.
template <typename... Functions>
[[nodiscard]] constexpr bool is_among(function_list<Functions...>, std::uint8_t code) noexcept
{
    return ((code == to_u8(Functions::code)) or ...);
}

/// The public functions (AP 6).
using public_functions =
    function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                  write_single_register, read_exception_status, diagnostics<>, get_comm_event_counter,
                  get_comm_event_log, write_multiple_coils<>, write_multiple_registers<>, report_server_id,
                  read_file_record<>, write_file_record<>, mask_write_register, read_write_multiple_registers<>,
                  read_fifo_queue, read_device_identification>;

/// Their codes.
inline constexpr function_set all_functions = public_functions::codes;

/// What a function with this code says of a response, where it knows more of it than the client compares.
/// Internal.
template <typename... Functions>
[[nodiscard]] constexpr errc check_beside_client(function_list<Functions...>, byte_view request_pdu,
                                                 byte_view response_pdu) noexcept
{
    errc found = errc::none;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (checks_response<Function>) {
            if (is_pdu_of(request_pdu, Function::code)) {
                found = Function::check_response(request_pdu, response_pdu);
            }
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return found;
}

} // namespace rtuwire

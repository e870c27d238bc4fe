// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/function_text.hpp"

#include <cstddef>
#include <string_view>

#include "frame/hex_text.hpp"

namespace tool {

namespace {

/// Empty for one that is not public.
std::string_view public_name(rtuwire::function_code code)
{
    using enum rtuwire::function_code;
    switch (code) {
    case read_coils: return "read coils";
    case read_discrete_inputs: return "read discrete inputs";
    case read_holding_registers: return "read holding registers";
    case read_input_registers: return "read input registers";
    case write_single_coil: return "write single coil";
    case write_single_register: return "write single register";
    case read_exception_status: return "read exception status";
    case diagnostics: return "diagnostics";
    case get_comm_event_counter: return "get comm event counter";
    case get_comm_event_log: return "get comm event log";
    case write_multiple_coils: return "write multiple coils";
    case write_multiple_registers: return "write multiple registers";
    case report_server_id: return "report server ID";
    case read_file_record: return "read file record";
    case write_file_record: return "write file record";
    case mask_write_register: return "mask write register";
    case read_write_multiple_registers: return "read/write multiple registers";
    case read_fifo_queue: return "read FIFO queue";
    case encapsulated_interface: return "encapsulated interface transport";
    }
    return {};
}

} // namespace

std::string function_text(rtuwire::function_code code)
{
    std::string_view const name = public_name(code);
    return name.empty() ? "function " + function_number(code) : std::string{name};
}

std::string function_number(rtuwire::function_code code)
{
    auto const number = static_cast<std::byte>(code);
    std::string text = std::to_string(std::to_integer<unsigned>(number));
    if (text.size() == 1) {
        return text.insert(0, 1, '0');
    }
    return text.append(" (0x").append(hex_of({&number, 1})).append(")");
}

std::string subfunction_text(rtuwire::subfunction what)
{
    using enum rtuwire::subfunction;
    switch (what) {
    case return_query_data: return "return query data";
    case restart_communications: return "restart communications option";
    case return_diagnostic_register: return "return diagnostic register";
    case change_ascii_delimiter: return "change ASCII input delimiter";
    case force_listen_only: return "force listen only mode";
    case clear_counters: return "clear counters and diagnostic register";
    case bus_message_count: return "return bus message count";
    case bus_communication_error_count: return "return bus communication error count";
    case bus_exception_error_count: return "return bus exception error count";
    case server_message_count: return "return server message count";
    case server_no_response_count: return "return server no response count";
    case server_nak_count: return "return server NAK count";
    case server_busy_count: return "return server busy count";
    case bus_character_overrun_count: return "return bus character overrun count";
    case clear_overrun_counter: return "clear overrun counter and flag";
    }
    return "sub-function " + std::to_string(static_cast<unsigned>(what));
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/layout_parts.hpp"

namespace tool {

namespace {

using rtuwire::function_code;

void read_counted(field_reader& from, function_code code, std::optional<asked_run> const& asked)
{
    using enum function_code;
    unsigned const bytes = from.number(1, "byte count");
    auto const first = asked ? std::optional{asked->first} : std::nullopt;
    if (code == read_coils or code == read_discrete_inputs) {
        // What fills the last byte is no bit that was asked for.
        from.bits(bytes, asked ? asked->count : 8U * bytes, first, bits_of_function(code), space_of(code));
    } else if (code == report_server_id) {
        from.raw(bytes, "data");
    } else {
        from.registers(bytes / 2, first, space_of(code));
        from.raw(bytes % 2, "half a register");
    }
}

void read_log(field_reader& from)
{
    unsigned const bytes = from.number(1, "byte count");
    from.number(2, "status", [](unsigned status) {
        return status == 0xFFFFU ? std::string{"busy"} : status == 0 ? std::string{"ready"} : std::to_string(status);
    });
    from.number(2, "event count");
    from.number(2, "message count");
    from.raw(bytes > 6 ? bytes - 6 : 0, "events, the latest first");
}

void read_records(field_reader& from)
{
    unsigned const bytes = from.number(1, "byte count");
    std::size_t const end = from.size() + bytes;
    while (from.size() < end and not from.is_short()) {
        unsigned const size = from.number(1, "length of the run");
        from.number(1, "reference type");
        for (unsigned i = 1; i + 1 < size and not from.is_short(); i += 2) {
            from.number(2, "record");
        }
    }
}

} // namespace

void read_response(field_reader& from, function_code code, std::optional<asked_run> const& asked)
{
    using enum function_code;
    if (code == write_multiple_coils or code == write_multiple_registers) {
        from.address(code == write_multiple_coils ? "first coil" : "first register", space_of(code));
        from.number(2, "quantity");
    } else if (code == read_exception_status) {
        from.bits(1, 8, std::nullopt, "output", register_space::coil);
    } else if (code == get_comm_event_counter) {
        from.number(2, "status");
        from.number(2, "event count");
    } else if (code == get_comm_event_log) {
        read_log(from);
    } else if (code == read_file_record) {
        read_records(from);
    } else if (code == read_fifo_queue) {
        from.number(2, "byte count");
        from.registers(from.number(2, "registers in the queue"), std::nullopt, register_space::holding);
    } else {
        read_counted(from, code, asked);
    }
}

} // namespace tool

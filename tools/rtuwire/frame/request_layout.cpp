// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/layout_parts.hpp"

namespace tool {

using rtuwire::function_code;

void read_request(field_reader& from, function_code code)
{
    using enum function_code;
    if (code == read_coils or code == read_discrete_inputs) {
        from.address("first " + bits_of_function(code), space_of(code));
        from.number(2, "quantity");
    } else if (code == read_holding_registers or code == read_input_registers) {
        from.address(code == read_input_registers ? "first input register" : "first register", space_of(code));
        from.number(2, "quantity");
    } else if (code == write_multiple_coils) {
        unsigned const first = from.address("first coil", space_of(code));
        unsigned const count = from.number(2, "quantity");
        from.bits(from.number(1, "byte count"), count, first, "coil", space_of(code));
    } else if (code == write_multiple_registers or code == read_write_multiple_registers) {
        if (code == read_write_multiple_registers) {
            from.address("first register to read", space_of(code));
            from.number(2, "quantity to read");
        }
        bool const is_both = code == read_write_multiple_registers;
        unsigned const first = from.address(is_both ? "first register to write" : "first register", space_of(code));
        from.number(2, is_both ? "quantity to write" : "quantity");
        unsigned const bytes = from.number(1, "byte count");
        from.registers(bytes / 2, first, space_of(code));
        from.raw(bytes % 2, "half a register");
    } else if (code == read_file_record) {
        read_runs(from, false);
    } else if (code == read_fifo_queue) {
        from.number(2, "pointer of the queue");
    }
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/function_text.hpp"
#include "frame/layout_parts.hpp"

namespace tool {

namespace {

using rtuwire::function_code;

void write_single(field_reader& from, function_code code)
{
    if (code == function_code::write_single_register) {
        from.registers(1, from.address("register", space_of(code)), space_of(code));
        return;
    }
    unsigned const address = from.address("coil", space_of(code));
    unsigned const sent = from.number(2, "value", [](unsigned value) {
        return value == 0xFF00U ? std::string{"on"}
               : value == 0     ? std::string{"off"}
                                : std::to_string(value) + ", which is neither on nor off";
    });
    if (not from.is_short() and (sent == 0xFF00U or sent == 0)) {
        from.named_coil(address, sent != 0);
    }
}

void read_diagnostics(field_reader& from)
{
    unsigned const what = from.number(
        2, "sub-function", [](unsigned value) { return subfunction_text(static_cast<rtuwire::subfunction>(value)); });
    bool const is_any = what == static_cast<unsigned>(rtuwire::subfunction::return_query_data);
    for (std::size_t words = is_any ? from.left() / 2 : 1; words > 0; --words) {
        from.number(2, "data");
    }
}

void read_mask(field_reader& from)
{
    from.address("register", register_space::holding);
    from.number(2, "AND mask");
    from.number(2, "OR mask");
}

} // namespace

register_space space_of(function_code code)
{
    using enum function_code;
    bool const is_coil = code == read_coils or code == write_single_coil or code == write_multiple_coils;
    return is_coil                        ? register_space::coil
           : code == read_discrete_inputs ? register_space::discrete
           : code == read_input_registers ? register_space::input
                                          : register_space::holding;
}

std::string bits_of_function(function_code code)
{
    return code == function_code::read_discrete_inputs ? "discrete input" : "coil";
}

void read_runs(field_reader& from, bool with_records)
{
    unsigned const bytes = from.number(1, "byte count");
    std::size_t const end = from.size() + bytes;
    while (from.size() < end and not from.is_short()) {
        from.number(1, "reference type");
        from.number(2, "file");
        unsigned const record = from.number(2, "first record");
        unsigned const count = from.number(2, "records");
        if (with_records) {
            for (unsigned i = 0; i < count and not from.is_short(); ++i) {
                from.number(2, "record " + std::to_string(record + i));
            }
        }
    }
}

bool read_either(field_reader& from, function_code code)
{
    using enum function_code;
    if (code == write_single_coil or code == write_single_register) {
        write_single(from, code);
    } else if (code == diagnostics) {
        read_diagnostics(from);
    } else if (code == mask_write_register) {
        read_mask(from);
    } else if (code == write_file_record) {
        read_runs(from, true);
    } else {
        return false;
    }
    return true;
}

} // namespace tool

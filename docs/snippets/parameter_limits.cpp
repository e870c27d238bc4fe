// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of all parameters shows of looking one up, and of its limits. Takes a mnemonic; without one, several.
#include <iostream>
#include <string_view>

#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

//! [limits]
void show_limit(bound const& limit, parameter const& row)
{
    if (limit.is_open()) {
        std::cout << "open"; // the drive decides
    } else if (limit.is_number()) {
        std::cout << double(limit.raw()) * row.type->step_numerator / row.type->step_denominator << ' '
                  << row.type->unit;
    } else {
        std::cout << "what " << limit.code() << " holds"; // times numerator() / denominator(), and factor()'s count
    }
}

bool show_limits(std::string_view code) // as somebody typed it, in upper case
{
    parameter const* const row = atv320::parameters.by_code(code);
    if (row == nullptr) {
        std::cout << code << ": no such parameter\n";
        return false;
    }
    std::cout << row->code << ": from ";
    show_limit(row->min, *row);
    std::cout << " to ";
    show_limit(row->max, *row);
    std::cout << '\n';
    return true;
}
//! [limits]

} // namespace

int main(int argc, char** argv)
{
    if (argc > 1) {
        return show_limits(argv[1]) ? 0 : 1;
    }
    //! [typed]
    std::cout << decihertz{highest<atv320::parameter<"SP2">>()} << '\n'; // 599.0 Hz: of a register with a type
    //! [typed]
    bool const is_unknown = not show_limits("SP99");
    return show_limits("SP2") and show_limits("HSP") and is_unknown ? 0 : 1;
}

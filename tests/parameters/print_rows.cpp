// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Prints the parameters of a drive, a line each, as they stand in the array that a program walks: for compare.py.
//     print_rows atv12|atv310|atv320
#include <cstdio>
#include <iostream>
#include <string_view>

#include "parameters/maps.hpp"

namespace {

using namespace rtuwire;
using namespace rtuwire::altivar;

std::string_view text(access mode)
{
    return mode == access::read_only ? "r" : mode == access::configuration ? "conf" : "rw";
}

std::string_view text(provenance source)
{
    return source == provenance::documented ? "documented" : source == provenance::inferred ? "inferred" : "doubtful";
}

std::string_view text(parameter_kind kind)
{
    switch (kind) {
    case parameter_kind::number: return "u16";
    case parameter_kind::signed_number: return "i16";
    case parameter_kind::bits: return "bits";
    case parameter_kind::enumeration: return "enum";
    }
    return "?";
}

void print(bound const& limit)
{
    if (limit.is_number()) {
        std::cout << limit.raw();
    } else if (not limit.is_open()) {
        std::cout << std::string_view{limit.code()};
    }
}

void print(std::span<choice const> all, literal choice::*name)
{
    bool is_first = true;
    for (choice const& each : all) {
        if ((each.*name).size() != 0) {
            std::cout << (is_first ? "" : ";") << each.word << '=' << std::string_view{each.*name};
            is_first = false;
        }
    }
}

void print(parameter_map const& map, std::string_view part)
{
    map.for_each([part](parameter const& row, parameter_group const& group) {
        parameter_type const& type = *row.type.operator->();
        std::cout << part << '\t' << std::string_view{group.name} << '\t' << std::string_view{row.code} << '\t'
                  << row.address << '\t' << text(row.mode()) << '\t' << text(row.source()) << '\t' << text(type.kind)
                  << '\t' << std::string_view{type.unit} << '\t' << type.step_numerator << '/' << type.step_denominator
                  << '\t';
        print(row.min);
        std::cout << '\t';
        print(row.max);
        std::cout << '\t';
        if (row.factory) {
            std::cout << *row.factory;
        }
        std::cout << '\t';
        print(row.listed(), &choice::mnemonic);
        std::cout << '\t';
        print(row.choices(), &choice::meaning);
        std::cout << '\t' << std::string_view{row.steps_set_by} << '\t' << std::string_view{row.name} << '\n';
    });
}

} // namespace

int main(int count, char** arguments)
{
    std::string_view const drive = count == 2 ? arguments[1] : "";
    maps_of const* const maps = maps_named(drive);
    if (maps == nullptr) {
        std::cerr << "print_rows: \"" << drive << "\" is none of atv12, atv310, atv320\n";
        return 2;
    }
    print(*maps->parameters, "parameter");
    if (maps->unverified != nullptr) {
        print(*maps->unverified, "unverified");
    }
    return std::cout.flush() ? 0 : 1;
}

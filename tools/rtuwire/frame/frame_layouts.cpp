// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_layouts.hpp"

#include "frame/function_text.hpp"
#include "frame/layout_parts.hpp"

namespace tool {

namespace {

using rtuwire::frame_role;
using rtuwire::function_code;

void read_identification_request(field_reader& from)
{
    from.number(1, "access", [](unsigned access) {
        constexpr char const* words[] = {"basic", "regular", "extended", "single object"};
        return access >= 1 and access <= 4 ? std::string{words[access - 1]} : std::to_string(access);
    });
}

void read_objects(field_reader& from)
{
    from.number(1, "conformity");
    from.number(1, "more follows", [](unsigned more) {
        return more == 0xFFU ? std::string{"yes"} : more == 0 ? std::string{"no"} : std::to_string(more);
    });
    from.number(1, "next object");
    for (unsigned left = from.number(1, "objects"); left > 0 and not from.is_short(); --left) {
        unsigned const id = from.number(1, "object", [](unsigned number) {
            constexpr char const* words[] = {"vendor name",  "product code", "revision",        "vendor URL",
                                             "product name", "model name",   "application name"};
            return std::to_string(number) + (number < 7 ? std::string{": "} + words[number] : std::string{});
        });
        from.text(from.number(1, "length"), "object " + std::to_string(id));
    }
}

void read_interface(field_reader& from, frame_role role)
{
    unsigned const type = from.number(1, "type", [](unsigned value) {
        return value == 14 ? std::string{"read device identification"} : std::to_string(value);
    });
    if (type != 14) {
        return from.raw(from.left(), "data");
    }
    read_identification_request(from);
    if (role == frame_role::request) {
        from.number(1, "first object");
    } else {
        read_objects(from);
    }
}

} // namespace

void read_fields(field_reader& from, frame_role role, std::optional<asked_run> const& asked)
{
    using enum function_code;
    constexpr unsigned exception_bit = 0x80;
    unsigned const wire = from.number(1, "function", [](unsigned value) {
        std::string const text = function_text(static_cast<function_code>(value & 0x7FU));
        return value >= exception_bit ? text + ", refused" : text;
    });
    auto const code = static_cast<function_code>(wire & 0x7FU);
    if (wire >= exception_bit) {
        from.number(1, "exception", [](unsigned value) {
            return rtuwire::exception_response{function_code{}, static_cast<std::uint8_t>(value)}.error() ==
                           rtuwire::errc::unlisted_exception
                       ? "an exception with an unlisted code"
                       : std::string{rtuwire::name(static_cast<rtuwire::errc>(value))};
        });
    } else if (not rtuwire::all_functions.contains(code)) {
        from.raw(from.left(), "data");
    } else if (code == encapsulated_interface) {
        read_interface(from, role);
    } else if (read_either(from, code)) {
        return;
    } else if (role == frame_role::request) {
        read_request(from, code);
    } else {
        read_response(from, code, asked);
    }
}

} // namespace tool

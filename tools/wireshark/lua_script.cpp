// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Register tables as tables of Lua.
#include "lua_script.hpp"

#include <string>
#include <type_traits>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>

#include "lua_code.hpp"

namespace wireshark {
namespace {

std::string quoted(std::string const& text)
{
    std::string in_quotes = "\"";
    for (char const each : text) {
        in_quotes += each == '"' or each == '\\' ? std::string{'\\', each} : std::string{each};
    }
    return in_quotes + "\"";
}

std::string string_of(auto const& text) { return {text.begin(), text.end()}; }

/// The values of an enumeration that have names: `{[4]="SLF1: Modbus interrupted"}`
template <typename E> std::string names_of()
{
    std::string list;
    for (unsigned word = 0; word <= 0xFFFFU; ++word) {
        std::string const name = string_of(rtuwire::text_of(static_cast<E>(word)));
        if (name[0] != '#') {
            list += "[" + std::to_string(word) + "]=" + quoted(name) + ",";
        }
    }
    return "{" + list + "}";
}

/// How many digits stand behind the point of an amount.
std::size_t decimals_of(std::string const& amount)
{
    auto const point = amount.find('.');
    auto const end = amount.find(' ');
    return point == std::string::npos ? 0 : (end == std::string::npos ? amount.size() : end) - point - 1;
}

/// How a register's words are shown. An amount as a format of its value and the size of its steps.
template <auto const& R> std::string form_of_register()
{
    using value = rtuwire::value_of<R>;
    if constexpr (rtuwire::bit_field<value>) {
        return "bits=true";
    } else if constexpr (rtuwire::register_enumeration<value>) {
        return "names=" + names_of<value>();
    } else {
        std::string const sign = std::is_signed_v<typename value::rep> ? ",signed=true" : "";
        if (R.steps_set_by.size() > 0) {
            return "format=" + quoted("%d steps of " + string_of(R.steps_set_by)) + ",step=1" + sign;
        }
        std::string unit = value::dimension::symbol;
        unit = unit.empty() ? "" : unit == "%" ? " %%" : " " + unit;
        std::string const digits = std::to_string(decimals_of(string_of(rtuwire::text_of(value{1}))));
        return "format=" + quoted("%." + digits + "f" + unit) + ",step=" + std::to_string(value::scale::num) + "/" +
               std::to_string(value::scale::den) + sign;
    }
}

template <typename Drive> void write_drive(std::ostream& out)
{
    out << "drives[" << quoted(string_of(Drive::name)) << "] = {\n";
    Drive::registers::for_each([&]<auto const & R>() {
        out << "  [" << R.address << "] = {code=" << quoted(string_of(R.code)) << "," << form_of_register<R>()
            << "},\n";
    });
    out << "}\n";
}

} // namespace

void write_lua_script(std::ostream& out)
{
    out << lua_head;
    rtuwire::altivar::all_drives::for_each([&]<typename Drive>() {
        out << "known[#known + 1] = " << quoted(string_of(Drive::name)) << "\n";
        write_drive<Drive>(out);
    });
    out << lua_code;
}

} // namespace wireshark

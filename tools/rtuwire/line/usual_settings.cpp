// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/usual_settings.hpp"

#include <variant>

#include "exit_status.hpp"
#include "line/scan_log.hpp"
#include "port/port_word.hpp"

namespace tool {

std::vector<line_setting> const& usual_settings()
{
    constexpr auto even = rtuwire::character_format::even_8_1;
    constexpr auto odd = rtuwire::character_format::odd_8_1;
    constexpr auto none = rtuwire::character_format::none_8_2;
    static std::vector<line_setting> const all{
        {19'200, even}, {9'600, none},  {9'600, even}, {19'200, none},  {38'400, none}, {115'200, none},
        {38'400, even}, {57'600, none}, {4'800, none}, {115'200, even}, {57'600, even}, {4'800, even},
        {2'400, none},  {2'400, even},  {9'600, odd},  {19'200, odd},   {38'400, odd},  {115'200, odd},
        {57'600, odd},  {1'200, none},  {1'200, even}, {4'800, odd},    {2'400, odd},   {1'200, odd}};
    return all;
}

bool is_same_setting(line_setting const& one, line_setting const& other)
{
    return one.baud == other.baud and one.format == other.format;
}

std::string words_of(line_setting const& how) { return std::to_string(how.baud) + ' ' + name_of_format(how.format); }

std::string typed_rate(line_setting const& how)
{
    return " -b " + std::to_string(how.baud) + " -f " + name_of_format(how.format);
}

std::string note_of_format(line_setting const& how)
{
    return how.format == rtuwire::character_format::none_8_2 ? "8N2 does for 8N1 as well" : "";
}

bool has_rate(line_choices const& line)
{
    port_choice const which = read_port_word(line.port);
    return not which.refused and std::holds_alternative<serial_device>(which.port);
}

bool is_modbus_tcp(line_choices const& line)
{
    port_choice const which = read_port_word(line.port);
    return not which.refused and std::holds_alternative<mbap_address>(which.port);
}

void refuse_without_rate(line_choices const& line, std::string const& option)
{
    port_choice const which = read_port_word(line.port);
    if (not line.port.empty() and not which.refused and not has_rate(line)) {
        refuse_word(
            option + ": " + line.port +
            " has no bit rate that this program sets: there is none to find (a serial device server has its own)");
    }
}

} // namespace tool

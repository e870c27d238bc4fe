// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Fifty registers read by address. Twin of fifty_typed.cpp.
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

void ask(byte_view frame);

template <std::uint16_t Address> void read_one(unit_id unit)
{
    single_request const conversation{unit, read_holding_registers{Address, 1}};
    ask(conversation.next()->frame());
}

template <std::uint16_t... Addresses> void read_each(unit_id unit) { (read_one<Addresses>(unit), ...); }

void read_all(unit_id unit)
{
    read_each<3011, 3012, 3017, 3102, 3103, 3104, 3105, 3201, 3202, 3203, 3204, 3205, 3206, 3207, 3208, 3209, 3211,
              3231, 3233, 3240, 3302, 6001, 6003, 6004, 6005, 7010, 7121, 7130, 7200, 7201, 7202, 7203, 7204, 7205,
              7206, 7207, 7208, 8401, 8413, 8414, 8423, 8424, 8431, 8501, 8502, 8503, 8504, 8602, 8603, 8604>(unit);
}

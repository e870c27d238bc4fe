// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of function 03 that writes by function 06.
// EXPECT: this client's list of functions lacks one that the conversation asks: add it to its client_needs
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{3}};
inline constexpr client_needs<function_list<read_holding_registers>> only_reads{};

void act(basic_client<only_reads>& link, instant now)
{
#ifdef REFUSED
    auto conversation = write<atv12::acc>(drive, 3_s);
#else
    auto conversation = read<atv12::acc>(drive);
#endif
    link.converse(conversation, now);
}

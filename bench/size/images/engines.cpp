// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Not an image: each variable is as large as what its name says, for `nm` to read.
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/server/server.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

constexpr line_timing timing{19'200, character_format::even_8_1};

char size_of_server[sizeof(server)];
char size_of_client[sizeof(client)];
char size_of_fixed_client[sizeof(static_client<timing>)];
char size_of_counting_client[sizeof(basic_client<observed_by<line_statistics>>)];
char size_of_bus_of_4[sizeof(bus<4>)];
char size_of_framer[sizeof(framer<direction::response>)];

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two values of a function are the same where all their parts are: a difference in one of them is one.

#include "support/proof.hpp"

#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

using namespace rtuwire;

namespace {

constexpr register_block<2> values{1, 2};
constexpr register_block<2> others{1, 3};

constexpr bool tells_exchanges_apart()
{
    read_write_multiple_registers const one{10, 4, 20, values};
    return one == read_write_multiple_registers{10, 4, 20, values} and
           not(one == read_write_multiple_registers{11, 4, 20, values}) and
           not(one == read_write_multiple_registers{10, 5, 20, values}) and
           not(one == read_write_multiple_registers{10, 4, 21, values}) and
           not(one == read_write_multiple_registers{10, 4, 20, others});
}
PROOF("requests of function 23 differ by each of their parts", tells_exchanges_apart)

constexpr bool tells_diagnostics_apart()
{
    diagnostics const one{subfunction::return_query_data, values};
    return one == diagnostics{subfunction::return_query_data, values} and
           not(one == diagnostics{subfunction::return_query_data, others}) and
           not(one == diagnostics{subfunction::return_diagnostic_register, values});
}
PROOF("requests of function 08 differ by each of their parts", tells_diagnostics_apart)

constexpr bool tells_writes_apart()
{
    write_multiple_registers const one{10, values};
    return one == write_multiple_registers{10, values} and not(one == write_multiple_registers{11, values}) and
           not(one == write_multiple_registers{10, others});
}
PROOF("requests of function 16 differ by each of their parts", tells_writes_apart)

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The other of two files that include the single header: without the parts for a host.
#include <rtuwire.hpp>

rtuwire::byte_view frame_of_the_other();

rtuwire::byte_view frame_of_the_other()
{
    using namespace rtuwire;
    static constexpr auto frame = encode(unit_id{2}, read_holding_registers{.start = 3102, .count = 4});
    return frame;
}

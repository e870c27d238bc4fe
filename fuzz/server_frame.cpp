// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any PDU to a server as a pure function: the response fits, is of the function asked, and a refusal changed
// nothing.
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/whole_bank.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

namespace {

constexpr device_object objects[] = {{0, "vendor"}, {1, "code"}, {2, "0100"}};
constexpr server_profile wide{.identity = identity_of<objects>};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    static constexpr server_profile narrow{.limits = {7, 7, 0, 0}};
    test::whole_bank bank;
    bank.queued = size % bank.queue.size();
    serial_diagnostics line;
    fuzz::input in{data, size};
    while (not in.is_empty()) {
        bool const is_wide = (in.u8() & 1U) != 0;
        byte_view const asked = in.some(in.u8());
        std::array<std::byte, max_pdu_size> place{};
        unsigned const before = bank.all_writes();
        byte_view const response = respond<public_functions>(asked, bank, is_wide ? wide : narrow, place, line);
        if (response.empty()) {
            continue;
        }
        require(response.size() <= max_pdu_size and not asked.empty());
        require((to_u8(response[0]) & 0x7FU) == to_u8(asked[0]));
        if (to_u8(response[0]) >= 0x80) {
            require(response.size() == 2 and to_u8(response[1]) >= 1 and to_u8(response[1]) <= 4);
            require(bank.all_writes() == before);
        }
    }
    return 0;
}

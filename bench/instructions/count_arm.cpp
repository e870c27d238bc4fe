// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Counts instructions on an emulated board whose clock ticks once for 40 of them (-icount shift=0).
#include "board.hpp"

#include <rtuwire/client.hpp>

#include RTUWIRE_OPERATIONS

namespace {

constexpr std::int32_t rounds = 4'000;
constexpr std::int32_t instructions_a_tick = 40;
constexpr std::uint32_t wrap = 0x100'0000;

std::uint32_t ticks_of(void (*run)())
{
    std::uint32_t const before = board::at(0xE000'E018);
    for (std::int32_t round = 0; round < rounds; ++round) {
        run();
    }
    return (before - board::at(0xE000'E018)) % wrap;
}

} // namespace

int main()
{
    board::at(0xE000'E014) = wrap - 1;
    board::at(0xE000'E018) = 0;
    board::at(0xE000'E010) = 0x5; // counts, without its interrupt
    if (not operations::are_right()) {
        return 1;
    }
    for (operations::operation const& each : operations::list) {
        // A tick more or less is chance; where both cost the same, the difference may be below zero.
        auto const ticks = static_cast<std::int32_t>(ticks_of(each.run) - ticks_of(each.less));
        for (char const* c = each.name; *c != '\0'; ++c) {
            board::console_uart::put(static_cast<std::byte>(*c));
        }
        board::print(" ");
        board::print(rtuwire::quantity<rtuwire::dimensionless, std::int32_t>{ticks * instructions_a_tick / rounds});
        board::print("\n");
    }
    return 0;
}

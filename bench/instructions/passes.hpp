// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A pass of a bus while a response is awaited, so that its instructions can be counted: `advance`, `converse` for each
// slot, `poll_transmit`, `poll_deadline`; and the same where the loop asks `has_turn` first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

namespace operations {

using namespace rtuwire;
using namespace rtuwire::detail;

struct memory {
    std::size_t sum{0};
};
inline memory all;

/// Nothing: what a call costs.
[[gnu::noinline]] inline void nothing() { asm volatile("" ::: "memory"); }

/// Reads without end.
struct read_on : asker {
    frame_of<read_holding_registers> frame = *encode(unit_id{1}, read_holding_registers{1, 4});

    std::optional<request_frame> next() const noexcept { return request_frame{frame}; }
    static void accept(result<response> const&) noexcept {}
    static constexpr bool settled() noexcept { return false; }
};

/// A bus with a reader in each slot, and a unit that takes its time.
template <std::size_t Slots> struct line_of {
    bus<Slots> link{line_timing{19'200, character_format::even_8_1}};
    std::array<read_on, Slots> readers{};
    instant now{0};

    line_of()
    {
        slot_options const patient{.with = {.response_timeout = milliseconds(1'000'000)}};
        for (std::size_t i = 0; i < Slots; ++i) {
            link.set(i, patient);
        }
        for (unsigned i = 0; i < 6; ++i) {
            now = now + milliseconds(5);
            link.advance(now);
            visit_all();
            if (not link.poll_transmit().empty()) {
                link.sent(now);
            }
        }
    }
    void visit_all()
    {
        instant const at = now; // a constant of the pass, as in a loop of `main`
        for (std::size_t i = 0; i < Slots; ++i) {
            link.converse(i, readers[i], at);
        }
    }
    void end_pass() { all.sum = all.sum + link.poll_transmit().size() + (link.poll_deadline() ? 1U : 0U); }
};

/// Made when it is first needed: nothing runs before `main`.
template <std::size_t Slots> line_of<Slots>& line()
{
    static line_of<Slots> made;
    return made;
}

template <std::size_t Slots> [[gnu::noinline]] void pass(line_of<Slots>& all_slots)
{
    all_slots.now = all_slots.now + microseconds(100);
    all_slots.link.advance(all_slots.now);
    all_slots.visit_all();
    all_slots.end_pass();
}
template <std::size_t Slots> [[gnu::noinline]] void asking_pass(line_of<Slots>& all_slots)
{
    all_slots.now = all_slots.now + microseconds(100);
    all_slots.link.advance(all_slots.now);
    if (all_slots.link.has_turn()) {
        all_slots.visit_all();
    }
    all_slots.end_pass();
}
inline void bus_pass_1() { pass(line<1>()); }
inline void bus_pass_30() { pass(line<30>()); }
inline void bus_pass_247() { pass(line<247>()); }
inline void asking_pass_30() { asking_pass(line<30>()); }
inline void asking_pass_247() { asking_pass(line<247>()); }

/// Whether each does what its name says: a response is awaited, and nothing leaves.
inline bool are_right()
{
    bool const awaits =
        line<1>().link.has_turn() and not line<30>().link.has_turn() and not line<247>().link.has_turn();
    all.sum = 0;
    bus_pass_1();
    bus_pass_30();
    bus_pass_247();
    asking_pass_247();
    return awaits and all.sum == 4;
}

struct operation {
    char const* name;
    void (*run)();
    void (*less)(); ///< what is measured with it and does not count
};

inline constexpr operation list[] = {
    {"bus_pass_1", bus_pass_1, nothing},           {"bus_pass_30", bus_pass_30, nothing},
    {"bus_pass_247", bus_pass_247, nothing},       {"asking_pass_30", asking_pass_30, nothing},
    {"asking_pass_247", asking_pass_247, nothing},
};

} // namespace operations

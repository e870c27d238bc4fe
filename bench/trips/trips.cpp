// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One `ask`, one `start` and one served request: prints the address of each function that each of them enters. Compiled
// with -O0 -finstrument-functions, which also calls what could be computed before. What the far end does is left out.
#include <algorithm>
#include <cstdio>
#include <set>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

std::set<void*>* entered = nullptr; // null: nothing is noted

/// A port to a simulated drive.
struct port_to_drive {
    sim::unit<atv320::device> unit{unit_id{7}, {19'200, character_format::even_8_1}, instant{0}};
    instant clock{0};

    [[nodiscard]] instant now() const { return clock; }
    result<void> write(byte_view frame, instant /*until*/)
    {
        auto* const noting = std::exchange(entered, nullptr);
        unit.receive(frame, clock);
        entered = noting;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        auto* const noting = std::exchange(entered, nullptr);
        byte_view frame;
        for (; frame.empty() and not reached(clock, until); clock = clock + milliseconds(10)) {
            unit.advance(clock);
            frame = unit.poll_transmit();
            std::ranges::copy(frame, place.begin());
            unit.sent(clock);
        }
        entered = noting;
        return place.first(frame.size());
    }
};

/// Prints what an act enters, and returns whether it ended as it should.
template <typename Act> bool follow(char const* name, Act act)
{
    std::set<void*> found;
    entered = &found;
    bool const is_done = act();
    entered = nullptr;
    for (void const* const function : found) {
        std::printf("%s %p\n", name, function);
    }
    return is_done;
}

} // namespace

extern "C" [[gnu::no_instrument_function]] void __cyg_profile_func_enter(void* function, void* /*caller*/)
{
    if (auto* const noting = entered) {
        entered = nullptr; // what notes it is entered, too
        noting->insert(function);
        entered = noting;
    }
}
extern "C" [[gnu::no_instrument_function]] void __cyg_profile_func_exit(void* /*function*/, void* /*caller*/) {}

int main()
{
    station<atv320::device> const drive{unit_id{7}};
    line_timing const timing{19'200, character_format::even_8_1};
    read_holding_registers const request{.start = 3201, .count = 1};
    port_to_drive port;
    blocking_client line{port, timing};
    server node{drive.unit(), timing};
    word_bank<4'000> registers;
    auto const frame = *encode(drive.unit(), request);
    node.advance(instant{5'000});                                                     // hears from here on
    static_cast<void>(line.run(broadcast_setting<atv320::device, atv320::tto>(3_s))); // else it is not started

    unit_id const unit = drive.unit();
    bool is_done = follow("ask", [&] { return line.ask(unit, request).has_value(); });
    is_done &= follow("start", [&] {
        start go{drive, 50_Hz};
        return line.run(go).kind == outcome_kind::succeeded;
    });
    is_done &= follow("served", [&] {
        node.receive(frame, instant{100'000});
        node.serve(registers, instant{110'000});
        node.advance(instant{120'000});
        return not node.poll_transmit().empty();
    });
    return is_done ? 0 : 1;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server's table of phases, each with each event. Phases are told apart by what a server does next.
#include <rtuwire/server/server.hpp>

#include "server/phase_table.hpp"
#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace test::server_table;

namespace {

constexpr auto read_1 = "01 03 00 01 00 01 D5 CA"_hex;
constexpr auto everyone_writes_3 = "00 06 00 01 00 03 99 DA"_hex;
constexpr auto noise = "55"_hex;

using unit_1 = test::server_on_a_line<>;

constexpr void bring(unit_1& to, phase wanted, byte_view asked)
{
    if (wanted == phase::listening) {
        return;
    }
    to.receive(asked);
    if (wanted == phase::asked) {
        return;
    }
    to.pass({});
    if (wanted == phase::transmitting) {
        to.sleep(to.line.t3_5());
        static_cast<void>(to.node.poll_transmit());
    }
}

constexpr void apply(unit_1& to, event what)
{
    switch (what) {
    case event::request: to.receive(read_1); break;
    case event::byte: to.receive(noise); break;
    case event::damaged_byte: to.node.receive_error(to.now); break;
    case event::serve:
    case event::serve_broadcast: to.pass({}); break;
    case event::poll_after_t3_5: to.sleep(to.line.t3_5()); [[fallthrough]];
    case event::poll_before: static_cast<void>(to.node.poll_transmit()); break;
    case event::sent: to.node.sent(to.now); break;
    case event::time_limit: to.sleep(milliseconds(500)); break;
    }
}

/// The phase that a server was in; it goes on from there.
constexpr phase take_phase(unit_1& of)
{
    if (of.node.is_asked()) {
        return phase::asked;
    }
    of.sleep(of.line.frame_end());
    if (not of.node.poll_transmit().empty()) {
        return phase::responding;
    }
    of.receive(read_1);
    return of.node.is_asked() ? phase::listening : phase::transmitting;
}

/// Whether an event leads from a phase to the one that the table says.
constexpr bool holds(phase from, event what)
{
    bool const is_broadcast = from == phase::asked and what == event::serve_broadcast;
    byte_view const asked = is_broadcast ? byte_view{everyone_writes_3} : byte_view{read_1};
    unit_1 before;
    bring(before, from, asked);
    unit_1 it;
    bring(it, from, asked);
    apply(it, what);
    return take_phase(before) == from and
           take_phase(it) == next[static_cast<std::size_t>(from)][static_cast<std::size_t>(what)];
}

template <std::size_t From> constexpr bool row_holds()
{
    for (std::size_t what = 0; what < events; ++what) {
        if (not holds(static_cast<phase>(From), static_cast<event>(what))) {
            return false;
        }
    }
    return true;
}
PROOF("listening: only a whole request leads on", row_holds<0>)
PROOF("asked: serve answers, bytes and the time limit drop the request", row_holds<1>)
PROOF("responding: the response leaves after t3.5, or is dropped", row_holds<2>)
PROOF("transmitting: only its end or its time limit leads on", row_holds<3>)

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Firmware in small: a client and a server that use every function, with a buffer for a UART.
#include <rtuwire/rtuwire.hpp>

namespace {

constexpr rtuwire::device_object objects[] = {{0, "vendor"}, {1, "code"}, {2, "0100"}};
constexpr rtuwire::server_profile profile{.identity = rtuwire::identity_of<objects>};

template <typename Request> std::size_t ask(rtuwire::client& link, Request const& request, rtuwire::instant now)
{
    rtuwire::single_request conversation{rtuwire::unit_id{7}, request};
    link.converse(conversation, now);
    link.advance(now);
    return link.poll_transmit().size();
}

/// Shared with interrupts.
constinit rtuwire::interrupt_queue<> line_events;
constinit rtuwire::interrupt_queue<256> many_events;

void interrupt(rtuwire::byte_view bytes, rtuwire::instant now)
{
    line_events.receive(bytes, now);
    line_events.receive_error(now);
    line_events.sent(now);
    many_events.receive(bytes, now);
}

} // namespace

std::size_t exercise(rtuwire::byte_view bytes, rtuwire::instant now);

std::size_t exercise(rtuwire::byte_view bytes, rtuwire::instant now)
{
    using namespace rtuwire;
    line_timing const line{19'200, character_format::even_8_1};
    client link{line};
    server node{unit_id{7}, line, profile};
    word_bank<16> bank;
    link.receive(bytes, now);
    link.sent(now);
    node.receive(bytes, now);
    node.receive_error(now);
    node.serve(bank, now);
    node.sent(now);
    interrupt(bytes, now);
    line_events.deliver_to(link, now);
    many_events.deliver_to(node, now);
    register_block<2> const values{1, 2};
    return ask(link, read_holding_registers{0, 4}, now) + ask(link, write_single_register{0, 1}, now) +
           ask(link, write_multiple_registers{0, values}, now) +
           ask(link, read_write_multiple_registers{0, 2, 0, values}, now) +
           ask(link, diagnostics{subfunction::return_query_data, values}, now) +
           ask(link, read_device_identification{}, now) + node.poll_transmit().size();
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write plan is run request by request, and ends at the first refusal.
#include <rtuwire/ask/plan_writer.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using ramps = write_plan<atv12::device, atv12::acc, atv12::dec, atv12::ac2>;
constexpr ramps values{2_s, 3_s, 5_s};
constexpr station<atv12::device> drive{unit_id{2}};

constexpr bool writes_both_requests()
{
    test::manual_unit unit;
    plan_writer<ramps> conversation{drive, values};
    unit.link.converse(conversation, unit.now);
    bool const first = same_bytes(unit.link.poll_transmit(), "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex);
    unit.link.sent(unit.now);
    unit.say("02 10 23 29 00 02 9B B7"_hex);
    unit.link.converse(conversation, unit.now);
    bool const waits =
        not conversation.settled() and conversation.outcome() == errc::busy and conversation.written() == 1;
    unit.run(conversation, milliseconds(10));
    unit.say("02 10 23 34 00 01 4B B0"_hex);
    unit.link.converse(conversation, unit.now);
    return first and waits and conversation.outcome() and conversation.written() == 2;
}
PROOF("a plan of two requests is written in order", writes_both_requests)

constexpr bool ends_at_a_refusal()
{
    test::manual_unit unit;
    plan_writer<ramps> conversation{drive, values};
    unit.link.converse(conversation, unit.now);
    unit.transmit();
    unit.say("02 90 03 FC 01"_hex);
    unit.link.converse(conversation, unit.now);
    return conversation.outcome() == errc::illegal_data_value and conversation.written() == 0 and
           not unit.link.is_busy();
}
PROOF("a refusal ends the plan and is told", ends_at_a_refusal)

/// A plan with a request that writes nothing.
struct hollow_plan {
    using device = atv12::device;
    static constexpr std::size_t register_count = 1;
    [[maybe_unused]] static constexpr std::size_t request_count = 1;
    static constexpr std::array<address_block, 1> requests() { return {address_block{9'001, 0}}; }
    static constexpr std::span<std::uint16_t const> words(std::size_t) { return {}; }
};

constexpr bool ends_where_nothing_can_be_written()
{
    plan_writer<hollow_plan> const conversation{drive, {}};
    return conversation.settled() and not conversation.next() and conversation.outcome() == errc::invalid_quantity and
           conversation.written() == 0;
}
PROOF("a plan that makes no frame ends with the error, and asks nothing", ends_where_nothing_can_be_written)

} // namespace

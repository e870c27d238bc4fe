// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What every conversation that ends says of its end: nothing too early, the outcome after it, and nothing again where
// it begins anew.
#include <rtuwire/ask/conversation.hpp>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/inspection/identify.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/plan_writer.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/words_read.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv12::device> drive{unit_id{2}};
using ramps = write_plan<atv12::device, atv12::acc, atv12::dec>;
using panel = read_plan<atv12::device, atv12::rfr, atv12::lcr>;

/// Asks each kind of conversation that ends the same question. `what` takes a new one.
template <typename What> constexpr bool holds_for_all(What what)
{
    return what(read<atv12::rfr>(drive)) and what(write<atv12::acc>(drive, 2_s)) and
           what(write_all<atv12::acc, atv12::dec>(drive, 2_s, 3_s)) and what(poller<panel>{drive}) and
           what(plan_writer<ramps>{drive, ramps{2_s, 3_s}}) and what(line_echo_probe{unit_id{2}}) and
           what(identify<atv320::device>{station<atv320::device>{unit_id{2}}});
}

constexpr bool is_no_success_too_early()
{
    return holds_for_all(
        [](auto conversation) { return not conversation.settled() and conversation.outcome() == errc::busy; });
}
PROOF("before its end a conversation is not settled, and its outcome is no success", is_no_success_too_early)

constexpr bool tells_its_failure()
{
    return holds_for_all([](auto conversation) {
        conversation.accept(errc::timed_out);
        return conversation.settled() and conversation.outcome() == errc::timed_out and not conversation.next();
    });
}
PROOF("a failure ends it, and is its outcome", tells_its_failure)

constexpr bool ends_by_any_error()
{
    return holds_for_all([](auto conversation) {
        conversation.accept(errc::busy);
        return conversation.settled() and conversation.outcome() == errc::busy and not conversation.next();
    });
}
PROOF("any error ends it, also the one that stands for no outcome yet", ends_by_any_error)

constexpr bool begins_anew()
{
    return holds_for_all([](auto conversation) {
        conversation.accept(errc::timed_out);
        if constexpr (requires { conversation.again(); }) {
            conversation.again();
            return not conversation.settled() and conversation.outcome() == errc::busy and conversation.next();
        }
        return true;
    });
}
PROOF("one that begins anew is not settled again", begins_anew)

constexpr bool keeps_what_cannot_be_sent()
{
    sized_request<10, 5> request{unit_id{2}, write_multiple_registers{1, register_block{1}}};
    request.again();
    return request.settled() and request.outcome() == errc::buffer_too_small and not request.next();
}
PROOF("a request that could not be encoded does not begin anew", keeps_what_cannot_be_sent)

// Beside its frame of 8 bytes a read holds the word and two bytes of this base.
STATIC_CHECK(sizeof(word_read) <= sizeof(asker) + 8 + sizeof(void*));

} // namespace

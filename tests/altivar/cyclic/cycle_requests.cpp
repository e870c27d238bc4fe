// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The requests of a cycle: what the client is told about each, which words it moves on which drive, and what it asks
// where a drive does not have a register or was rearranged.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "motion_law/plant.hpp"
#include "support/drives.hpp"
#include "support/proof.hpp"

#include <algorithm>
#include <cstddef>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using cycle = cycle_by_hand<atv12::device>;

/// What the request that comes a period later does to the motor.
constexpr effect effect_later(cycle& it)
{
    it.now = it.now + milliseconds(100);
    it.loop.advance(it.now);
    return it.loop.intent();
}

constexpr bool tells_what_an_exchange_does()
{
    cycle it;
    bool ok = it.begins(ready) and effect_later(it) == effect::none and it.exchange(ready);
    ok = ok and it.loop.run(1'500_rpm) and effect_later(it) == effect::enabling;
    ok = ok and it.asks_at_once() and it.exchanges(0x0007, 1'500);
    it.miss();
    ok = ok and effect_later(it) == effect::none; // a look
    ok = ok and it.asks_at_once() and it.reads(eta_address);
    it.loop.stop();
    return ok and it.loop.intent() == effect::stopping;
}
PROOF("an exchange with an order may move the motor, a look never does, whatever is ordered",
      tells_what_an_exchange_does)

constexpr bool tells_what_each_half_does()
{
    cycle it{{.by_function_23 = false}};
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm);
    ok = ok and effect_later(it) == effect::none;
    ok = ok and it.asks_at_once() and it.reads(inputs_address, 4);
    it.hear({ready, 0, 0, 0});
    ok = ok and it.loop.intent() == effect::enabling;
    return ok and it.asks_at_once() and it.asked[1] == std::byte{16};
}
PROOF("of an exchange in two halves the one that writes may move the motor", tells_what_each_half_does)

constexpr bool tells_of_a_reset()
{
    cycle it;
    bool ok = it.begins() and it.exchange(in_fault) and it.asks() and it.reads(lft_address);
    it.hear({9});
    ok = ok and effect_later(it) == effect::none and it.loop.reset_fault();
    return ok and it.loop.intent() == effect::resetting;
}
PROOF("an exchange that resets a fault is called so", tells_of_a_reset)

/// A cycle whose drive does not have SLL, the first register of a check without limits but for what a hertz is in rpm.
constexpr bool is_without_sll(cycle& it, bool has_slots = true)
{
    bool ok = it.asks();
    it.hear({switch_on_disabled});
    ok = ok and it.asks();
    it.hear({0});
    if (has_slots) {
        ok = ok and it.tells_its_slots();
    } else {
        ok = ok and it.asks() and it.reads(first_slot_address, 4);
        it.miss(errc::illegal_data_address);
    }
    ok = ok and it.asks() and it.reads(9'602);
    it.hear({500});
    ok = ok and it.asks() and it.reads(9'604);
    it.hear({1'440});
    ok = ok and it.asks() and it.reads(7'010);
    it.miss(errc::illegal_data_address);
    return ok;
}
constexpr bool refuses_who_has_no_register()
{
    cycle it{{.supervision = {.beyond = beyond_limits::limit}}};
    bool ok = is_without_sll(it) and it.loop.link_lost() and not it.loop.run(1'500_rpm);
    ok = ok and it.loop.control().reason().kind == outcome_kind::unknown_register;
    return ok and it.loop.supervision().address == 7'010;
}
PROOF("a drive that does not have a register of the check is not ordered, and the register is named",
      refuses_who_has_no_register)

constexpr bool accepts_who_has_no_register()
{
    cyclic_options const options{
        .supervision = {.risks = {.accept_unknown_registers = true}, .beyond = beyond_limits::limit}};
    cycle it{options};
    bool ok = is_without_sll(it) and it.is_checked() and it.loop.run(1'500_rpm);
    cycle other{options};
    ok = ok and is_without_sll(other, false) and it.loop.control().reason().kind == outcome_kind::pending;
    return ok and other.is_checked() and other.loop.control().reason().kind == outcome_kind::misconfigured;
}
PROOF("that risk can be accepted; a scanner that does not tell its slots cannot", accepts_who_has_no_register)

constexpr bool moves_four_words_of_eight()
{
    cycle_by_hand<atv320::device> it;
    bool ok = it.begins() and it.asks() and it.exchanges(0x0000, 0);
    return ok and it.word(4) == 4 and it.word(8) == 4;
}
PROOF("of an ATV320's eight scanner words four go each way, in one exchange", moves_four_words_of_eight)

constexpr bool writes_two_words_without_a_scanner()
{
    constexpr std::uint16_t eta = 458, cmd = 400, first_input = 452;
    cycle_by_hand<atv28::device> it{{.supervision = {.beyond = beyond_limits::limit}}};
    bool ok = it.asks() and it.reads(eta);
    while (ok and it.word(4) == 1) { // the check
        it.hear({it.word(2) == eta ? switch_on_disabled : std::uint16_t{0}});
        ok = it.asks();
    }
    ok = ok and it.reads(first_input, 7) and it.loop.run(50_Hz);
    it.hear({0, 0, 0, 0, 0, 0, switch_on_disabled});
    ok = ok and it.asks_at_once() and it.asked[1] == std::byte{16};
    ok = ok and it.word(2) == cmd and it.word(4) == 2;
    return ok and it.word(7) == 0x0006 and it.word(9) == 500;
}
PROOF("an ATV28 is written its command and reference, and not CMI behind them", writes_two_words_without_a_scanner)

/// The steps of a cycle without its clock, so that the drive may be said to be rearranged.
struct steps_by_hand {
    cycle_steps<atv12::device> steps{unit_id{3}, cyclic_options{}};
    byte_view asked{};

    constexpr std::uint16_t asks(bool was_rearranged = false)
    {
        asked = steps.ask(was_rearranged, true);
        return u16_at(asked, 2);
    }
    constexpr void hear(std::initializer_list<std::uint16_t> read)
    {
        std::array<std::byte, 10> pdu{std::byte{3}, std::byte{8}};
        std::size_t at = 2;
        for (std::uint16_t const each : read) {
            pdu[at++] = to_byte(static_cast<std::uint32_t>(each >> 8U));
            pdu[at++] = to_byte(each);
        }
        steps.take(response{byte_view{pdu}});
    }
    /// All that is read before an exchange, which it has asked then.
    constexpr bool is_known()
    {
        hear({switch_on_disabled});
        bool ok = asks() == lft_address;
        hear({0});
        ok = ok and asks() == first_slot_address;
        hear({eta_address, rfrd_address, 0, 0});
        static_cast<void>(asks());
        hear({cmd_address, lfrd_address, 0, 0});
        while (ok and asks() < inputs_address) {
            hear({commissioned_word(u16_at(asked, 2))});
        }
        return ok and asked[1] == std::byte{23};
    }
};

constexpr bool reads_all_anew_where_it_was_rearranged()
{
    steps_by_hand it;
    bool ok = it.asks() == eta_address and it.is_known();
    it.hear({switch_on_disabled, 0, 0, 0});
    ok = ok and it.steps.intent(true) == effect::none and it.asks(true) == eta_address;
    return ok and it.is_known();
}
PROOF("a drive that somebody rearranged is looked at, and its scanner is read, before it is written "
      "to again",
      reads_all_anew_where_it_was_rearranged)

} // namespace

TEST_CASE("the longest frames of a cycle are as long as its type says, on each drive")
{
    test::all_drives::for_each([]<typename Device>() {
        std::size_t request = 0, response = 0;
        plant<Device> it;
        it.disturb([&](frame_bytes& frame, bool is_request) {
            std::size_t& longest = is_request ? request : response;
            longest = std::max(longest, frame.size());
        });
        cyclic<Device> loop{it.drive};
        static_cast<void>(it.watch(loop, milliseconds(2'000)));
        CHECK(cyclic<Device>::longest_frames.request == request);
        CHECK(cyclic<Device>::longest_frames.response == response);
    });
}

namespace {

/// Scanners of which a cycle moves more words one way than the other.
struct of_many_inputs : atv12::device {
    static constexpr cycle_registers cycle{.by = function_code::read_write_multiple_registers,
                                           .reads = {atv12::eta.address, atv12::rfrd.address, 0, 0},
                                           .writes = {atv12::cmd.address, atv12::lfrd.address},
                                           .speed = atv12::rfrd.address,
                                           .by_scanner = true};
};
struct of_many_outputs : atv12::device {
    static constexpr cycle_registers cycle{.by = function_code::read_write_multiple_registers,
                                           .reads = {atv12::eta.address, atv12::rfrd.address},
                                           .writes = {atv12::cmd.address, atv12::lfrd.address, 0, 0},
                                           .speed = atv12::rfrd.address,
                                           .by_scanner = true};
};

STATIC_CHECK(cyclic<of_many_inputs>::longest_frames.request == 17);
STATIC_CHECK(cyclic<of_many_inputs>::longest_frames.response == 13);
STATIC_CHECK(cyclic<of_many_outputs>::longest_frames.request == 21);
STATIC_CHECK(cyclic<of_many_outputs>::longest_frames.response == 13); // the slots of its outputs

} // namespace

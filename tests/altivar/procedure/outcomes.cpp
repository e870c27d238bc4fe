// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How conversations end that go wrong: refused, silent, in local control, at their limit.
#include <string>

#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/known_words.hpp"
#include "support/proof.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/inspection/identify.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
using scanned = configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd>>;

constexpr station<device> drive{unit_id{7}};
constexpr response nothing{};

/// A start of a drive that was checked before.
start started(duration limit = milliseconds(3'000))
{
    return start{drive, 50_Hz, run_direction::forward, limit, test::commissioned()};
}

/// A conversation at its next request; the clock is run on by the pauses between.
template <typename Conversation> struct by_hand {
    Conversation conversation;
    instant now{0xFFFF'0000U};

    /// Whether it asks for something within a second.
    bool asks()
    {
        for (unsigned i = 0; i < 100; ++i) {
            conversation.advance(now);
            if (conversation.next() or conversation.settled()) {
                return not conversation.settled();
            }
            now = now + milliseconds(10);
        }
        return false;
    }
    void hear(errc error)
    {
        REQUIRE(asks());
        if (error != errc::none) {
            conversation.accept(error);
        }
    }
    void hear_word(std::uint16_t word)
    {
        REQUIRE(asks());
        bool const are_two = conversation.next()->frame()[5] == std::byte{2};
        are_two ? hear_words({word, 0}) : hear_words({word});
    }
    void hear_words(std::initializer_list<std::uint16_t> words)
    {
        std::vector<std::byte> pdu{std::byte{3}, to_byte(static_cast<std::uint8_t>(2 * words.size()))};
        for (std::uint16_t const each : words) {
            pdu.insert(pdu.end(), {to_byte(each >> 8U), to_byte(each)});
        }
        conversation.accept(result<response>{response{pdu}});
    }
    void confirm()
    {
        REQUIRE(asks());
        conversation.accept(result<response>{nothing});
    }
};

/// A drive whose words stay as they are, whatever it is told; the last word written.
struct stubborn {
    std::uint16_t status;
    std::uint16_t frequency{0};
    std::uint16_t control{0};
    std::uint16_t written{0xFFFF};

    /// Answers the next request; false where none comes.
    template <typename Conversation> bool response(by_hand<Conversation>& it)
    {
        if (not it.asks()) {
            return false;
        }
        byte_view const frame = it.conversation.next()->frame();
        std::uint16_t const address = u16_at(frame, 2);
        if (frame[1] == std::byte{6}) {
            written = u16_at(frame, 4);
            it.confirm();
        } else {
            auto const word_at = [this](std::uint16_t where) {
                return where == device::layout.eta   ? status
                       : where == device::layout.rfr ? frequency
                       : where == device::layout.cmd ? control
                       : where == meaning_register   ? std::uint16_t{1}
                                                     : std::uint16_t{9};
            };
            bool const are_two = u16_at(frame, 4) == 2;
            are_two ? it.hear_words({word_at(address), word_at(static_cast<std::uint16_t>(address + 1))})
                    : it.hear_word(word_at(address));
        }
        return true;
    }
};

/// Answers all requests by one error, to the end.
template <typename Conversation> reason to_the_end(Conversation conversation, errc error)
{
    by_hand<Conversation> it{conversation};
    while (it.asks()) {
        it.hear(error);
        it.now = it.now + milliseconds(5);
    }
    return it.conversation.reason();
}

template <typename Conversation> reason silent(Conversation conversation)
{
    by_hand<Conversation> it{conversation};
    it.hear(errc::timed_out);
    CHECK(it.conversation.settled());
    CHECK_FALSE(it.conversation.next());
    it.conversation.accept(errc::timed_out); // nothing more changes
    it.conversation.advance(it.now);
    return it.conversation.reason();
}

/// Gives the same action again and again.
struct tireless : procedure {
    action_kind what;

    constexpr explicit tireless(action_kind wanted) noexcept : procedure{device::layout}, what{wanted} {}
    constexpr action step(event) const noexcept
    {
        return what == action_kind::pause ? to_pause(status_period) : within(to_read(0), status_period);
    }
};

template <typename Conversation> reason refused(Conversation conversation)
{
    by_hand<Conversation> it{conversation};
    it.hear(errc::illegal_data_address);
    return it.conversation.reason();
}

} // namespace

TEST_CASE("a drive that does not answer is silent, one that refuses refuses")
{
    for (reason const& told :
         {silent(start{drive, 50_Hz}), to_the_end(stop{drive}, errc::timed_out), silent(reset_fault{drive}),
          silent(change_reference{drive, 50_Hz}), silent(save_to_eeprom{drive}), silent(scanned{drive})}) {
        CHECK(told.kind == outcome_kind::silent);
        CHECK(told.error == errc::timed_out);
    }
    for (reason const& told : {refused(started()), refused(reset_fault{drive}), refused(change_reference{drive, 50_Hz}),
                               refused(save_to_eeprom{drive}), refused(scanned{drive})}) {
        CHECK(told.kind == outcome_kind::refused);
        CHECK(told.error == errc::illegal_data_address);
    }
    auto const busy = to_the_end(stop{drive}, errc::server_device_busy);
    CHECK(busy.kind == outcome_kind::refused);
    CHECK(busy.error == errc::server_device_busy);
    CHECK(to_the_end(stop{drive}, errc::illegal_data_address).kind == outcome_kind::other_family);
}

TEST_CASE("a response that is no word is a failure")
{
    by_hand<reset_fault> it{reset_fault{drive}};
    it.confirm();
    CHECK(it.conversation.reason().error == errc::wrong_length);
}

TEST_CASE("a conversation nobody began settles nothing, and one cannot be late before it")
{
    stop const conversation{drive};
    CHECK_FALSE(conversation.settled());
    CHECK_FALSE(conversation.poll_deadline());
    CHECK(conversation.reason().kind == outcome_kind::pending);
}

TEST_CASE("at their limits all end, and none leaves a command behind")
{
    constexpr std::uint16_t enabled = 0x0637, ready = 0x0631, tripping = 0x063F, in_local = 0x0437;
    by_hand<stop> stopping{stop{drive, stop_by::ramp, milliseconds(200)}};
    stubborn running{.status = enabled, .frequency = 300};
    while (running.response(stopping)) {
    }
    CHECK(stopping.conversation.reason().kind == outcome_kind::state_timeout);

    by_hand<stop> slowing{stop{drive, stop_by::ramp, milliseconds(200)}};
    while (running.response(slowing)) {
        --running.frequency;
    }
    CHECK(slowing.conversation.reason().kind == outcome_kind::unconfirmed);

    by_hand<stop> unseen{stop{drive, stop_by::ramp, milliseconds(200)}};
    unseen.confirm();
    while (unseen.asks()) {
        bool const is_write = unseen.conversation.next()->frame()[1] == std::byte{6};
        is_write ? unseen.confirm() : unseen.hear(errc::timed_out);
    }
    CHECK(unseen.conversation.reason().kind == outcome_kind::unconfirmed);

    by_hand<stop> foreign{stop{drive}};
    foreign.confirm();
    foreign.hear_word(in_local);
    CHECK(foreign.conversation.reason().kind == outcome_kind::local_control);

    by_hand<change_reference> other{change_reference{drive, 50_Hz}};
    other.hear_word(in_local);
    CHECK(other.conversation.reason().kind == outcome_kind::local_control);

    by_hand<reset_fault> resetting{reset_fault{drive, milliseconds(120)}};
    resetting.hear_word(tripping);
    resetting.hear_word(tripping);
    resetting.hear_word(tripping);
    resetting.hear_word(9); // its fault, once it is late
    CHECK(resetting.conversation.reason().kind == outcome_kind::in_fault);
    CHECK(resetting.conversation.reason().fault == 9);

    by_hand<start> starting{started(milliseconds(200))};
    stubborn waiting{.status = ready};
    while (waiting.response(starting)) {
    }
    CHECK(starting.conversation.reason().kind == outcome_kind::state_timeout);
    CHECK(waiting.written == 0);

    by_hand<scanned> hasty{scanned{drive, milliseconds(0)}};
    CHECK_FALSE(hasty.asks());
    CHECK(hasty.conversation.reason().kind == outcome_kind::aborted);
    CHECK(hasty.conversation.reason().error == errc::none); // nothing was asked
}

TEST_CASE("a script that wishes on after its limit gets one request, and no pause")
{
    by_hand<procedure_runner<tireless>> register_read{{unit_id{7}, milliseconds(100), action_kind::read}};
    register_read.hear_word(0); // in time
    register_read.now = register_read.now + milliseconds(200);
    register_read.hear_word(0); // the one that is granted
    CHECK(register_read.conversation.settled());
    CHECK(register_read.conversation.reason().kind == outcome_kind::aborted);

    by_hand<procedure_runner<tireless>> pausing{{unit_id{7}, milliseconds(100), action_kind::pause}};
    CHECK_FALSE(pausing.asks());
    CHECK(pausing.conversation.settled());
    CHECK(pausing.conversation.reason().kind == outcome_kind::aborted);
}

TEST_CASE("a state that nobody knows is looked at again")
{
    constexpr std::uint16_t unknown = 0x0667, gone = 0x0250, enabled = 0x0637, on = 0x0633;
    for (stop_by const mode : {stop_by::quick_stop, stop_by::halt}) {
        by_hand<stop> stopping{test::with_known_words(stop{drive, mode})};
        stubborn puzzling{.status = unknown};
        REQUIRE(puzzling.response(stopping));
        REQUIRE(puzzling.response(stopping));
        REQUIRE(puzzling.response(stopping));
        // What nobody understands may be operation: the word of this stop, or the ramp for one in place.
        CHECK(puzzling.written == (mode == stop_by::halt ? 7 : 2));
        CHECK(stopping.conversation.reason().kind == outcome_kind::pending);
        stubborn standing{.status = on};
        while (standing.written == 0xFFFF) {
            REQUIRE(standing.response(stopping));
        }
        while (standing.written != 0) {
            REQUIRE(standing.response(stopping)); // "switched on" is one word away from running
        }
        stopping.hear_word(gone);
        CHECK(stopping.conversation.succeeded());
        CHECK(stopping.conversation.reason().is_other_stop == (mode == stop_by::halt));
    }

    by_hand<reset_fault> resetting{reset_fault{drive}};
    resetting.hear_word(unknown);
    CHECK_FALSE(resetting.conversation.settled());
    resetting.hear_word(gone);
    CHECK_FALSE(resetting.conversation.settled()); // it looks once more
    resetting.hear_word(gone);
    CHECK(resetting.conversation.succeeded());

    by_hand<start> starting{started()};
    starting.hear_word(unknown);
    CHECK_FALSE(starting.conversation.settled());
    starting.hear_word(enabled);
    starting.hear_word(0x000F);                                      // its control word, for the direction
    CHECK(starting.conversation.next()->frame()[1] == std::byte{6}); // the reference first
    CHECK(u16_at(starting.conversation.next()->frame(), 2) == atv320::lfr.address);
}

TEST_CASE("an outcome that a procedure did not ask for, before its first visit or behind its end, changes nothing")
{
    by_hand<reset_fault> it{reset_fault{drive}};
    it.conversation.accept(errc::timed_out);
    it.hear_word(0x0250); // in no fault: it begins all the same
    it.hear_word(0x0250);
    REQUIRE(it.conversation.succeeded());
    for (errc const told : {errc::none, errc::timed_out, errc::overruled}) {
        it.conversation.accept(told == errc::none ? result<response>{nothing} : result<response>{told});
        CHECK((it.conversation.succeeded() and not it.conversation.has_request()));
    }
}

TEST_CASE("a conversation that is late has no deadline, and is not late twice")
{
    by_hand<reset_fault> it{reset_fault{drive, milliseconds(120)}};
    CHECK_FALSE(it.conversation.next());
    it.hear_word(0x063F);
    CHECK(it.conversation.poll_deadline());
    it.now = it.now + milliseconds(500);
    it.conversation.advance(it.now); // one request more is granted: for the fault
    CHECK_FALSE(it.conversation.settled());
    CHECK_FALSE(it.conversation.poll_deadline());
    it.conversation.advance(it.now);
    it.hear_word(9);
    CHECK(it.conversation.reason().fault == 9);
}

TEST_CASE("a save that fails half way is taken back, and is a failure still")
{
    by_hand<save_to_eeprom> it{save_to_eeprom{drive}};
    it.hear_word(0x0670);
    it.hear_word(0x4000);
    it.hear(errc::timed_out);
    REQUIRE(it.asks());
    CHECK(same_bytes(it.conversation.next()->frame().first(6), "07 06 21 38 40 00"_hex));
    it.confirm();
    CHECK(it.conversation.reason().kind == outcome_kind::silent);

    by_hand<save_to_eeprom> slow{save_to_eeprom{drive, milliseconds(300)}};
    slow.hear_word(0x0670);
    slow.hear_word(0);
    slow.confirm();
    for (unsigned i = 0; i < 20 and not slow.conversation.settled() and slow.asks(); ++i) {
        bool const is_read = slow.conversation.next()->frame()[1] == std::byte{3};
        is_read ? slow.hear_word(1) : slow.confirm();
    }
    CHECK(slow.conversation.reason().kind == outcome_kind::state_timeout);
}

TEST_CASE("pages of identification that do not fit are errors")
{
    constexpr std::uint8_t more = 0xFF;
    auto const page = [](std::uint8_t follows, std::uint8_t next, std::uint8_t id, std::size_t size) {
        fixed_buffer<253> pdu;
        byte_writer out{pdu.storage()};
        for (std::uint32_t const byte : {0x2BU, 0x0EU, 0x01U, 0x01U, std::uint32_t{follows}, std::uint32_t{next}, 1U,
                                         std::uint32_t{id}, static_cast<std::uint32_t>(size)}) {
            out.u8(byte);
        }
        for (std::size_t i = 0; i < size; ++i) {
            out.u8('x');
        }
        pdu.resize(out.size());
        return pdu;
    };
    auto const hear = [](identify<device>& who, auto const& pdu) { who.accept(result<response>{response{pdu}}); };
    identify<device> whole{drive};
    hear(whole, page(more, 1, 0, 6));
    CHECK_FALSE(whole.settled());
    CHECK(whole.next()->frame()[4] == std::byte{1});
    hear(whole, page(0, 0, 0x42, 3)); // an object that nobody asked for
    CHECK(whole.outcome()->vendor.size() == 6);
    CHECK_FALSE(whole.next());

    identify<device> circle{drive};
    hear(circle, page(more, 1, 0, 6));
    hear(circle, page(more, 1, 1, 6));
    CHECK(circle.outcome() == errc::malformed);

    identify<device> longest_name{drive};
    hear(longest_name, page(0, 0, 0, 48));
    REQUIRE(longest_name.outcome());
    CHECK(longest_name.outcome()->vendor.size() == 48);

    identify<device> long_name{drive};
    hear(long_name, page(0, 0, 0, 49));
    CHECK(long_name.outcome() == errc::buffer_too_small);

    identify<device> silent_drive{drive};
    silent_drive.accept(errc::timed_out);
    CHECK(silent_drive.outcome() == errc::timed_out);

    identify<device> nonsense{drive};
    nonsense.accept(result<response>{nothing});
    CHECK_FALSE(nonsense.outcome());
}

TEST_CASE("a cycle ramps a motor down whose state it cannot read, and drops an order that takes too long")
{
    cyclic_control law;
    law.note_status(0x0240, true); // known, remote
    REQUIRE(law.run(1'500));
    law.note_late();
    CHECK(law.reason().kind == outcome_kind::state_timeout);
    CHECK_FALSE(law.is_ordered());
    law.note_status(0x0267, false); // a state that there is not
    CHECK(law.state() == cia402::state::unknown);
    CHECK(law.next_command() == cia402::word_of(cia402::command::switch_on));
    CHECK(law.status() == 0x0267);
    CHECK_FALSE(law.run(1'500));
    law.note_status(0x0240, true);
    REQUIRE(law.run(1'500));
    law.note_status(0x0220, true); // not ready to switch on: nothing to say
    CHECK(law.next_command() == 0);
    REQUIRE(law.run(1'500));
    CHECK(law.next_command() == 0);
    law.note_status(0x0240, true);
    CHECK(law.next_command() == 6);
}

TEST_CASE("everything that is told has a name")
{
    auto const is_named = [](literal name) { return name.size() > 0; };
    for (unsigned i = 0; i <= static_cast<unsigned>(outcome_kind::started_by_terminals); ++i) {
        CHECK(is_named(name_of(static_cast<outcome_kind>(i))));
    }
    CHECK(name_of(static_cast<outcome_kind>(99)) == literal{"unknown"});
    for (unsigned i = 0; i <= static_cast<unsigned>(cia402::state::fault); ++i) {
        CHECK(is_named(cia402::name_of(static_cast<cia402::state>(i))));
    }
    for (unsigned i = 0; i <= static_cast<unsigned>(cia402::command::fault_reset); ++i) {
        CHECK(is_named(cia402::name_of(static_cast<cia402::command>(i))));
        CHECK(cia402::word_of(static_cast<cia402::command>(i)) <= 0x80);
    }
}

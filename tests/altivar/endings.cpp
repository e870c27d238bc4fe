// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How conversations end that go wrong: refused, silent, in local control, at their limit.
#include <string>

#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/party_line.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/change_reference.hpp>
#include <rtuwire/altivar/configure_scanner.hpp>
#include <rtuwire/altivar/cyclic_control.hpp>
#include <rtuwire/altivar/identify.hpp>
#include <rtuwire/altivar/reset_fault.hpp>
#include <rtuwire/altivar/save_to_eeprom.hpp>
#include <rtuwire/altivar/start.hpp>
#include <rtuwire/altivar/stop.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
using scanned = configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd>>;

constexpr station<device> drive{unit_id{7}};
constexpr response nothing{};

/// A start of a drive that was checked before.
start started(duration limit = milliseconds(3'000))
{
    return start{drive, 50_Hz, heading::forward, limit, test::commissioned()};
}

/// A conversation at its next question; the clock is run on by the pauses between.
template <typename Talk> struct by_hand {
    Talk talk;
    instant now{0xFFFF'0000U};

    /// Whether it asks for something within a second.
    bool asks()
    {
        for (unsigned i = 0; i < 100; ++i) {
            talk.advance(now);
            if (talk.next() or talk.settled()) {
                return not talk.settled();
            }
            now = now + milliseconds(10);
        }
        return false;
    }
    void hear(errc error)
    {
        REQUIRE(asks());
        if (error != errc::none) {
            talk.accept(error);
        }
    }
    void hear_word(std::uint16_t word)
    {
        REQUIRE(asks());
        std::array<std::byte, 4> const pdu{std::byte{3}, std::byte{2}, to_byte(word >> 8U),
                                           to_byte(word)};
        talk.accept(result<response>{response{pdu}});
    }
    void confirm()
    {
        REQUIRE(asks());
        talk.accept(result<response>{nothing});
    }
};

/// A drive whose words stay as they are, whatever it is told; the last word written.
struct stubborn {
    std::uint16_t status;
    std::uint16_t frequency{0};
    std::uint16_t control{0};
    std::uint16_t written{0xFFFF};

    /// Answers the next question; false where none comes.
    template <typename Talk> bool answer(by_hand<Talk>& it)
    {
        if (not it.asks()) {
            return false;
        }
        byte_view const frame = it.talk.next()->frame();
        std::uint16_t const address = u16_at(frame, 2);
        if (frame[1] == std::byte{6}) {
            written = u16_at(frame, 4);
            it.confirm();
        } else {
            it.hear_word(address == device::profile.eta   ? status
                         : address == device::profile.rfr ? frequency
                         : address == device::profile.cmd ? control
                                                          : std::uint16_t{9});
        }
        return true;
    }
};

/// Answers all questions by one error, to the end.
template <typename Talk> reason to_the_end(Talk talk, errc error)
{
    by_hand<Talk> it{talk};
    while (it.asks()) {
        it.hear(error);
        it.now = it.now + milliseconds(5);
    }
    return it.talk.reason();
}

template <typename Talk> reason silent(Talk talk)
{
    by_hand<Talk> it{talk};
    it.hear(errc::timed_out);
    CHECK(it.talk.settled());
    CHECK_FALSE(it.talk.next());
    it.talk.accept(errc::timed_out); // nothing more changes
    it.talk.advance(it.now);
    return it.talk.reason();
}

/// Wishes the same again and again.
struct tireless : script {
    wish::kind what;

    constexpr explicit tireless(wish::kind wanted) noexcept : script{device::profile}, what{wanted}
    {}
    constexpr wish step(event const&) const noexcept { return {what, 0, 0, look_period}; }
};

template <typename Talk> reason refused(Talk talk)
{
    by_hand<Talk> it{talk};
    it.hear(errc::illegal_data_address);
    return it.talk.reason();
}

} // namespace

TEST_CASE("a drive that does not answer is silent, one that refuses refuses")
{
    for (reason const& told : {silent(start{drive, 50_Hz}), to_the_end(stop{drive}, errc::timed_out),
                               silent(reset_fault{drive}), silent(change_reference{drive, 50_Hz}),
                               silent(save_to_eeprom{drive}), silent(scanned{drive})}) {
        CHECK(told.how == ending::silent);
        CHECK(told.error == errc::timed_out);
    }
    for (reason const& told : {refused(started()),
                               to_the_end(stop{drive}, errc::illegal_data_address),
                               refused(reset_fault{drive}), refused(change_reference{drive, 50_Hz}),
                               refused(save_to_eeprom{drive}), refused(scanned{drive})}) {
        CHECK(told.how == ending::refused);
        CHECK(told.error == errc::illegal_data_address);
    }
}

TEST_CASE("an answer that is no word is a failure")
{
    by_hand<reset_fault> it{reset_fault{drive}};
    it.confirm();
    CHECK(it.talk.reason().error == errc::wrong_length);
}

TEST_CASE("a conversation nobody began settles nothing, and one cannot be late before it")
{
    stop const talk{drive};
    CHECK_FALSE(talk.settled());
    CHECK_FALSE(talk.poll_deadline());
    CHECK(talk.reason().how == ending::pending);
}

TEST_CASE("at their limits all end, and none leaves a command behind")
{
    constexpr std::uint16_t enabled = 0x0637, ready = 0x0631, tripping = 0x063F, in_local = 0x0437;
    by_hand<stop> stopping{stop{drive, stop_by::ramp, milliseconds(200)}};
    stubborn running{.status = enabled, .frequency = 300};
    while (running.answer(stopping)) {}
    CHECK(stopping.talk.reason().how == ending::stuck);

    by_hand<stop> slowing{stop{drive, stop_by::ramp, milliseconds(200)}};
    while (running.answer(slowing)) {
        --running.frequency;
    }
    CHECK(slowing.talk.reason().how == ending::unconfirmed);

    by_hand<stop> unseen{stop{drive, stop_by::ramp, milliseconds(200)}};
    unseen.confirm();
    while (unseen.asks()) {
        bool const is_write = unseen.talk.next()->frame()[1] == std::byte{6};
        is_write ? unseen.confirm() : unseen.hear(errc::timed_out);
    }
    CHECK(unseen.talk.reason().how == ending::unconfirmed);

    by_hand<stop> foreign{stop{drive}};
    foreign.confirm();
    foreign.hear_word(in_local);
    CHECK(foreign.talk.reason().how == ending::local_control);

    by_hand<change_reference> other{change_reference{drive, 50_Hz}};
    other.hear_word(in_local);
    CHECK(other.talk.reason().how == ending::local_control);

    by_hand<reset_fault> resetting{reset_fault{drive, milliseconds(120)}};
    resetting.hear_word(tripping);
    resetting.hear_word(tripping);
    resetting.hear_word(tripping);
    resetting.hear_word(9); // its fault, once it is late
    CHECK(resetting.talk.reason().how == ending::in_fault);
    CHECK(resetting.talk.reason().fault == 9);

    by_hand<start> starting{started(milliseconds(200))};
    stubborn waiting{.status = ready};
    while (waiting.answer(starting)) {}
    CHECK(starting.talk.reason().how == ending::stuck);
    CHECK(waiting.written == 0);

    by_hand<scanned> hasty{scanned{drive, milliseconds(0)}};
    CHECK_FALSE(hasty.asks());
    CHECK(hasty.talk.reason().how == ending::silent);
    CHECK(hasty.talk.reason().error == errc::timed_out);
}

TEST_CASE("a script that wishes on after its limit gets one question, and no pause")
{
    by_hand<drive_talk<tireless>> reading{
        {unit_id{7}, tireless{wish::kind::read}, milliseconds(100)}};
    reading.hear_word(0); // in time
    reading.now = reading.now + milliseconds(200);
    reading.hear_word(0); // the one that is granted
    CHECK(reading.talk.settled());
    CHECK(reading.talk.reason().how == ending::stuck);

    by_hand<drive_talk<tireless>> pausing{
        {unit_id{7}, tireless{wish::kind::pause}, milliseconds(100)}};
    CHECK_FALSE(pausing.asks());
    CHECK(pausing.talk.settled());
    CHECK(pausing.talk.reason().how == ending::stuck);
}

TEST_CASE("a state that nobody knows is looked at again")
{
    constexpr std::uint16_t unknown = 0x0667, gone = 0x0250, enabled = 0x0637, on = 0x0633;
    for (stop_by const mode : {stop_by::quick_stop, stop_by::halt}) {
        by_hand<stop> stopping{stop{drive, mode, milliseconds(30'000), word_meaning::drive_profile}};
        stubborn puzzling{.status = unknown};
        REQUIRE(puzzling.answer(stopping));
        REQUIRE(puzzling.answer(stopping));
        REQUIRE(puzzling.answer(stopping));
        // What nobody understands may be operation: the word of this stop, or the ramp for one in place.
        CHECK(puzzling.written == (mode == stop_by::halt ? 7 : 2));
        CHECK(stopping.talk.reason().how == ending::pending);
        stubborn standing{.status = on};
        while (standing.written == 0xFFFF) {
            REQUIRE(standing.answer(stopping));
        }
        while (standing.written != 0) {
            REQUIRE(standing.answer(stopping)); // "switched on" is one word away from running
        }
        stopping.hear_word(gone);
        CHECK(stopping.talk.succeeded());
        CHECK(stopping.talk.reason().is_other_stop == (mode == stop_by::halt));
    }

    by_hand<reset_fault> resetting{reset_fault{drive}};
    resetting.hear_word(unknown);
    CHECK_FALSE(resetting.talk.settled());
    resetting.hear_word(gone);
    CHECK(resetting.talk.succeeded());

    by_hand<start> starting{started()};
    starting.hear_word(unknown);
    CHECK_FALSE(starting.talk.settled());
    starting.hear_word(enabled);
    starting.hear_word(0x000F);                              // its control word, for the direction
    CHECK(starting.talk.next()->frame()[1] == std::byte{6}); // the reference first
    CHECK(u16_at(starting.talk.next()->frame(), 2) == atv320::lfr.address);
}

TEST_CASE("a conversation that is late has no deadline, and is not late twice")
{
    by_hand<reset_fault> it{reset_fault{drive, milliseconds(120)}};
    CHECK_FALSE(it.talk.next());
    it.hear_word(0x063F);
    CHECK(it.talk.poll_deadline());
    it.now = it.now + milliseconds(500);
    it.talk.advance(it.now); // one question more is granted: for the fault
    CHECK_FALSE(it.talk.settled());
    CHECK_FALSE(it.talk.poll_deadline());
    it.talk.advance(it.now);
    it.hear_word(9);
    CHECK(it.talk.reason().fault == 9);
}

TEST_CASE("a save that fails half way is taken back, and is a failure still")
{
    by_hand<save_to_eeprom> it{save_to_eeprom{drive}};
    it.hear_word(0x0670);
    it.hear_word(0x4000);
    it.hear(errc::timed_out);
    REQUIRE(it.asks());
    CHECK(same_bytes(it.talk.next()->frame().first(6), "07 06 21 38 40 00"_hex));
    it.confirm();
    CHECK(it.talk.reason().how == ending::silent);

    by_hand<save_to_eeprom> slow{save_to_eeprom{drive, milliseconds(300)}};
    slow.hear_word(0x0670);
    slow.hear_word(0);
    slow.confirm();
    for (unsigned i = 0; i < 20 and not slow.talk.settled() and slow.asks(); ++i) {
        bool const is_read = slow.talk.next()->frame()[1] == std::byte{3};
        is_read ? slow.hear_word(1) : slow.confirm();
    }
    CHECK(slow.talk.reason().how == ending::silent);
}

TEST_CASE("pages of identification that do not fit are errors")
{
    constexpr std::uint8_t more = 0xFF;
    auto const page = [](std::uint8_t follows, std::uint8_t next, std::uint8_t id,
                         std::size_t size) {
        fixed_buffer<253> pdu;
        byte_writer out{pdu.storage()};
        for (std::uint32_t const octet :
             {0x2BU, 0x0EU, 0x01U, 0x01U, std::uint32_t{follows}, std::uint32_t{next}, 1U,
              std::uint32_t{id}, static_cast<std::uint32_t>(size)}) {
            out.u8(octet);
        }
        for (std::size_t i = 0; i < size; ++i) {
            out.u8('x');
        }
        pdu.resize(out.size());
        return pdu;
    };
    auto const hear = [](identify<device>& who, auto const& pdu) {
        who.accept(result<response>{response{pdu}});
    };
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

TEST_CASE(
    "a cycle ramps a motor down whose state it cannot read, and drops an order that takes too long")
{
    cyclic_control law;
    law.note_status(0x0240, true); // known, remote
    REQUIRE(law.run(1'500));
    law.note_late();
    CHECK(law.reason().how == ending::stuck);
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
    auto const is_named = [](text name) { return name.size() > 0; };
    for (unsigned i = 0; i <= static_cast<unsigned>(ending::started_by_terminals); ++i) {
        CHECK(is_named(name_of(static_cast<ending>(i))));
    }
    CHECK(name_of(static_cast<ending>(99)) == text{"unknown"});
    for (unsigned i = 0; i <= static_cast<unsigned>(cia402::state::fault); ++i) {
        CHECK(is_named(cia402::name_of(static_cast<cia402::state>(i))));
    }
    for (unsigned i = 0; i <= static_cast<unsigned>(cia402::command::fault_reset); ++i) {
        CHECK(is_named(cia402::name_of(static_cast<cia402::command>(i))));
        CHECK(cia402::word_of(static_cast<cia402::command>(i)) <= 0x80);
    }
}

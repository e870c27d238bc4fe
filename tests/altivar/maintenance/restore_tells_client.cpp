// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a restore tells its client of the motor, and what it hears of it: a motor without power, a fault, and an order of
// another conversation while a motor that the terminals started is told to stop.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include <array>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"

#include <rtuwire/client/orders.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

constexpr std::uint16_t cd1 = 8423;
constexpr instant now{1'000};

constexpr auto ignore = [](parameter_group const&, parameter const&, restore_report const&) {};

/// Somebody who orders the unit to run.
struct runner : commander {
    explicit constexpr runner(unit_id unit) noexcept : commander{unit} { note_order_to_run(); }
};

/// A restore of one word, each of its requests answered by hand, and what its client knows of the unit.
struct by_hand {
    word_list words{{"CD1", 1}};
    paper_drive drive = small_drive();
    orders<1> known{};
    decltype(altivar::restore{paper_station, small_map, wanted_settings{drive_family{}, words_by_code{nullptr}}, ignore,
                              all_of_it}) conversation{
        paper_station, small_map, wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, ignore,
        all_of_it};
    std::uint16_t asked{0};  ///< the address of the last request
    std::uint16_t second{0}; ///< how many words it read, or the word that it wrote

    /// Visits it; whether it asks something.
    bool asks()
    {
        conversation.advance(now);
        static_cast<void>(known.take_note_of(conversation, now));
        auto const request = conversation.next();
        if (not request) {
            return false;
        }
        std::array<std::byte, 2 + 2 * 63> pdu{};
        byte_view const frame = request->frame();
        asked = u16_at(frame, 2);
        second = u16_at(frame, 4);
        if (frame[1] == std::byte{0x2B}) {
            conversation.accept(errc::illegal_function);
        } else if (frame[1] == std::byte{6}) {
            drive.set(asked, second);
            asked == cd1 ? drive.run() : void();
            conversation.accept(result<response>{response{frame.subspan(1, 5)}});
        } else {
            pdu[0] = std::byte{3};
            pdu[1] = to_byte(second * 2U);
            for (std::size_t i = 0; i < second; ++i) {
                std::uint16_t const word = drive.word(static_cast<std::uint16_t>(asked + i));
                pdu[2 + 2 * i] = to_byte(word >> 8U);
                pdu[3 + 2 * i] = to_byte(word);
            }
            conversation.accept(result<response>{response{byte_view{pdu}.first(2 + 2U * second)}});
        }
        static_cast<void>(known.take_note_of(conversation, now));
        return true;
    }
    /// Until it has read this word alone, or written 1 there.
    void ask_until(std::uint16_t address)
    {
        while (asked != address or second != 1) {
            REQUIRE(asks());
        }
    }

    void order(runner& who) { static_cast<void>(known.take_note_of(who, now)); }
    void enable(runner& who) { known.note_asked(who, effect::enabling, milliseconds(10'000), 1); }
};

} // namespace

TEST_CASE("a status without power that a restore reads ends the order to run of its unit")
{
    by_hand it;
    runner who{paper_station.unit()};
    it.order(who);
    it.enable(who);
    CHECK(it.known.is_ordered(7));
    it.ask_until(paper_drive::status);
    CHECK_FALSE(it.known.is_ordered(7));
}

TEST_CASE("behind a fault that a restore reads no order counts that was given before")
{
    for (std::uint16_t const status : {std::uint16_t{0x0250}, std::uint16_t{0x0238}}) {
        by_hand it;
        it.drive.set(paper_drive::status, status);
        runner who{paper_station.unit()};
        it.order(who);
        CHECK(it.known.check(who, effect::enabling) == errc::none);
        it.ask_until(paper_drive::status);
        CHECK((it.known.check(who, effect::enabling) == errc::none) == (status == 0x0250));
    }
}

TEST_CASE("a motor that another conversation has ordered to run meanwhile is not stopped")
{
    for (bool const is_ordered : {false, true}) {
        by_hand it;
        it.ask_until(cd1);
        while (it.conversation.intent() != effect::stopping) {
            it.conversation.advance(now + milliseconds(60));
            REQUIRE(it.asks());
        }
        runner who{paper_station.unit()};
        if (is_ordered) {
            it.order(who);
            it.enable(who);
        }
        it.known.tell(it.conversation);
        it.conversation.advance(now);
        CHECK(it.conversation.settled() == is_ordered);
        CHECK((it.conversation.reason().kind == outcome_kind::overruled) == is_ordered);
        CHECK(it.conversation.next().has_value() == not is_ordered);
    }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client needs, in one constant: functions by choice, frames by size, counts; each kind of client takes it.
#include <rtuwire/client/needs.hpp>

#include <array>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/wire/raw.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

using four = function_list<read_holding_registers, write_single_register, write_multiple_registers<>,
                           read_write_multiple_registers<>>;
constexpr client_needs<four> of_four{};
constexpr client_needs<public_functions, line_statistics> small{.longest_frame = 40, .request_room = 12};
constexpr client_needs<four, line_statistics> panel{.timing = test::line, .longest_frame = 64, .motors = 1};

template <auto const& Needs> using hand_of = test::basic_manual_unit<basic_client<Needs>>;

constexpr errc start(auto& unit, byte_view frame) { return unit.link.start(request_frame{frame}, unit.now).error(); }

constexpr auto read_one = "01 03 0C 81 00 01 D7 72"_hex;
constexpr auto read_input = "01 04 0C 81 00 01 62 B2"_hex;
constexpr auto function_65 = "01 41 C0 10"_hex;

/// A request of this many registers, and its unit's response.
frame_of<read_holding_registers> reading(std::uint16_t count)
{
    return *encode(unit_id{1}, read_holding_registers{0, count});
}
std::array<std::byte, max_adu_size> respond_with(std::uint8_t count, std::size_t& size)
{
    std::array<std::byte, max_adu_size> frame{std::byte{1}, std::byte{3},
                                              std::byte{static_cast<std::uint8_t>(2 * count)}};
    size = 5U + 2U * count;
    append_crc(frame, size - adu_overhead);
    return frame;
}

} // namespace

TEST_CASE("client needs: what is not in the list of functions is refused before it leaves")
{
    hand_of<of_four> it;
    SECTION("a public function") { CHECK(start(it, read_input) == errc::invalid_function); }
    SECTION("one of a user") { CHECK(start(it, function_65) == errc::invalid_function); }
    SECTION("an exception's code") { CHECK(start(it, "01 83 02 C0 F1"_hex) == errc::invalid_function); }
    CHECK(it.link.poll_transmit().empty());
    CHECK_FALSE(it.link.is_busy());
    CHECK(start(it, read_one) == errc::none);
}

TEST_CASE("client needs: a client of all functions asks those of a user, too")
{
    hand_of<usual_needs> it;
    CHECK(start(it, read_input) == errc::none);
    hand_of<usual_needs> other;
    CHECK(start(other, function_65) == errc::none);
}

TEST_CASE("client needs: with a list of functions each response is checked as without")
{
    // The same bytes to both: a response, one of another size, one of another function, an exception, a damaged one.
    static constexpr auto longer = "01 03 04 12 34 56 78 81 07"_hex;
    static constexpr auto other = "01 04 02 12 34 B4 47"_hex;
    static constexpr auto refusal = "01 83 02 C0 F1"_hex;
    static constexpr auto damaged = "01 03 02 12 34 B5 32"_hex;
    constexpr std::array<byte_view, 6> said{test::response_1234, longer, other, refusal, damaged, read_one};
    for (byte_view const& each : said) {
        hand_of<of_four> one;
        hand_of<usual_needs> all;
        REQUIRE(one.ask(read_one));
        REQUIRE(all.ask(read_one));
        for (int i = 0; i < 4; ++i) {
            one.say(each);
            all.say(each);
            // One of a function that it does not know ends by silence, not by its length.
            CHECK((each[1] == std::byte{4} or one.link.poll_deadline() == all.link.poll_deadline()));
            one.run(milliseconds(400));
            all.run(milliseconds(400));
        }
        CHECK(one.fault() == all.fault());
        CHECK(one.transmissions == all.transmissions);
    }
}

TEST_CASE("client needs: a response that may be longer than its frame is refused before the request leaves")
{
    for (std::uint16_t count = 1; count <= 125; ++count) {
        hand_of<small> it;
        errc const wanted = 5 + 2 * count <= 40 ? errc::none : errc::buffer_too_small;
        auto const asked = reading(count);
        CHECK(start(it, asked) == wanted);
        CHECK(it.link.is_busy() == (wanted == errc::none));
    }
}

TEST_CASE("client needs: a long request takes room from its response, and one with no room is refused")
{
    std::array<std::byte, max_adu_size> frame{std::byte{1}, std::byte{16}};
    for (std::uint16_t words = 1; words <= 123; ++words) {
        frame[5] = static_cast<std::byte>(words);
        frame[6] = static_cast<std::byte>(2 * words);
        std::size_t const size = 9U + 2U * words;
        append_crc(frame, size - adu_overhead);
        std::size_t const room = size > 12 ? 52 - size : 40; // of 40 + 12 bytes
        errc const wanted = size <= 52 and room >= 8 ? errc::none : errc::buffer_too_small;
        hand_of<small> it;
        CHECK(start(it, byte_view{frame}.first(size)) == wanted);
    }
    hand_of<small> it;
    CHECK(start(it, frame) == errc::buffer_too_small);
}

TEST_CASE("client needs: the longest response fits, and longer frames of others do no harm")
{
    hand_of<small> it;
    std::size_t size = 0;
    auto const foreign = respond_with(125, size);
    auto const asked = reading(17);
    REQUIRE(it.ask(asked));
    it.say(byte_view{foreign}.first(size)); // of another master's request, to the same unit
    CHECK(it.none_yet());
    it.run(milliseconds(50));
    auto const own = respond_with(17, size);
    REQUIRE(size == 39);
    it.say(byte_view{own}.first(size));
    CHECK(it.fault() == errc::none);
    CHECK(it.link.statistics().line()[line_event::length] == 1);
}

TEST_CASE("client needs: smaller frames take less memory")
{
    CHECK(sizeof(basic_client<small>) + 256 + 8 == sizeof(basic_client<observed_by<line_statistics>>) + 40 + 12);
    CHECK(sizeof(basic_client<of_four>) == sizeof(client));
}

TEST_CASE("client needs: a bus takes them, and has a place for each slot")
{
    using small_bus = bus<3, small>;
    using usual_bus = bus<3>;
    CHECK(sizeof(small_bus) < sizeof(usual_bus) + sizeof(line_statistics));
    small_bus it{test::line};
    single_request ask{unit_id{1}, read_holding_registers{0, 18}};
    instant now{1'000'000};
    it.advance(now);
    now = now + milliseconds(10);
    it.advance(now);
    it.converse(0, ask, now);
    CHECK(ask.outcome().error() == errc::buffer_too_small);
    CHECK(it.poll_transmit().empty());
    CHECK(it.statistics().line()[line_event::request] == 0);
}

namespace {

template <typename Conversation, typename... Functions>
constexpr bool fits = has_what_it_asks<function_list<Functions...>, Conversation>();

using device = altivar::atv320::device;
using reading_plan = poller<read_plan<device, altivar::atv320::eta, altivar::atv320::rfr>>;

STATIC_CHECK(fits<altivar::start, read_holding_registers, write_single_register>);
STATIC_CHECK(not fits<altivar::start, read_holding_registers>);
STATIC_CHECK(fits<reading_plan, read_holding_registers> and not fits<reading_plan, read_input_registers>);
STATIC_CHECK(not fits<altivar::cyclic<device>, read_holding_registers, write_single_register>);
STATIC_CHECK(
    fits<altivar::cyclic<device>, read_holding_registers, write_single_register, read_write_multiple_registers<>>);
STATIC_CHECK(fits<single_request<raw_pdu<>>, read_coils>); // told when it is made

/// A conversation whose type tells of these frames, on a client of 40 + 12 bytes.
template <std::size_t Request, std::size_t Response> struct of_frames {
    static constexpr frame_sizes longest_frames{.request = Request, .response = Response};
};
template <std::size_t Request, std::size_t Response>
constexpr bool has_room = has_room_for<small, of_frames<Request, Response>>();

STATIC_CHECK(has_room<8, 40> and not has_room<8, 41>);
STATIC_CHECK(has_room<12, 40> and not has_room<12, 41>);
STATIC_CHECK(has_room<13, 39> and not has_room<13, 40>);
STATIC_CHECK(has_room<44, 8> and not has_room<45, 8>);

} // namespace

constinit basic_client<panel> panel_on_a_board;

TEST_CASE("client needs: one whose timing is given is ready before any code runs")
{
    CHECK(panel_on_a_board.line().characters(1) == test::line.characters(1));
    CHECK_FALSE(panel_on_a_board.is_busy());
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units that use a public function in a way of their own, and units at reserved addresses: frames of users' reports.
#include "defect/client_line.hpp"

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/client.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr line_timing office{9'600, character_format::none_8_1};
constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

/// What all of them have: a function, a first register and a quantity, each as it stands on the wire.
template <function_code Code> struct two_words {
    static constexpr function_code code = Code;
    static constexpr std::size_t max_size = 5;
    std::uint16_t first;
    std::uint16_t second;

    static constexpr errc check() { return errc::none; }
    static constexpr std::size_t size() { return max_size; }
    constexpr void write(byte_writer& out) const
    {
        out.u8(static_cast<unsigned>(Code));
        out.u16(first);
        out.u16(second);
    }
};

struct all_of_it {
    static constexpr std::size_t max_size = 60;
    byte_view pdu;
    static constexpr result<all_of_it> decode(byte_view bytes) { return all_of_it{bytes}; }
};

constexpr unsigned at(byte_view bytes, std::size_t place) { return std::to_integer<unsigned>(bytes[place]); }

/// A byte count of 16 bits.
struct read_counted_by_words : two_words<function_code::read_holding_registers> {
    using response = all_of_it;
    static constexpr std::size_t length_of_response(byte_view so_far)
    {
        return so_far.size() < 4 ? 0 : 6 + 256 * at(so_far, 2) + at(so_far, 3);
    }
    static constexpr errc check_response(byte_view asked, byte_view came)
    {
        return came.size() == 3 + 2 * at(asked, 4) ? errc::none : errc::response_mismatch;
    }
};

/// Registers wider than two bytes.
struct read_wide : two_words<function_code::read_holding_registers> {
    using response = all_of_it;
    static constexpr std::size_t length_of_response(byte_view so_far)
    {
        return so_far.size() < 3 ? 0 : 5 + at(so_far, 2);
    }
    static constexpr errc check_response(byte_view, byte_view came)
    {
        return came.size() == 2 + 12 ? errc::none : errc::response_mismatch;
    }
};

/// Three bytes behind 05, and an answer that repeats them.
struct spindle_order {
    using response = all_of_it;
    static constexpr function_code code = function_code::write_single_coil;
    static constexpr std::size_t max_size = 4;
    static constexpr errc check() { return errc::none; }
    static constexpr std::size_t size() { return max_size; }
    static constexpr void write(byte_writer& out)
    {
        for (unsigned const each : {0x05U, 0x02U, 0x13U, 0x88U}) {
            out.u8(each);
        }
    }
    static constexpr std::size_t length_of_response(byte_view so_far)
    {
        return so_far.size() < 3 ? 0 : 5 + at(so_far, 2);
    }
    static constexpr errc check_response(byte_view asked, byte_view came)
    {
        return asked.size() == came.size() and std::equal(asked.begin(), asked.end(), came.begin())
                   ? errc::none
                   : errc::response_mismatch;
    }
};

/// Another use of function 43 than its identification: of type 7, and counted.
struct encapsulated {
    using response = all_of_it;
    static constexpr function_code code = function_code::encapsulated_interface;
    static constexpr std::size_t max_size = 2;
    static constexpr errc check() { return errc::none; }
    static constexpr std::size_t size() { return max_size; }
    static constexpr void write(byte_writer& out)
    {
        out.u8(0x2B);
        out.u8(7);
    }
    static constexpr std::size_t length_of_response(byte_view so_far)
    {
        return so_far.size() < 4 ? 0 : 6 + at(so_far, 3);
    }
    static constexpr errc check_response(byte_view, byte_view came)
    {
        return came.size() == 3 + 2 ? errc::none : errc::response_mismatch;
    }
};

// What the receiver of a response knows of its length, byte by byte, and the longest of them, with unit and CRC.
using row_by_words = rtuwire::detail::own_row<read_counted_by_words>;
STATIC_CHECK([] {
    constexpr std::byte begun[]{std::byte{1}, std::byte{3}, std::byte{1}, std::byte{2}};
    auto const early = row_by_words::length(direction::response, byte_view{begun}.first(3));
    auto const known = row_by_words::length(direction::response, begun);
    return early.size == 4 and not early.is_final and known.size == 6 + 258 and known.is_final;
}());
STATIC_CHECK(row_by_words::longest_response({}) == 63);

inline constexpr client_needs<public_functions_and<read_counted_by_words>> counted_by_words{};
inline constexpr client_needs<public_functions_and<encapsulated>> interfaces{};
static_assert(public_functions_and<encapsulated>::codes == all_functions);
inline constexpr client_needs<function_list<read_wide, read_input_registers>> wide{.longest_frame = 63};
inline constexpr client_needs<public_functions_and<spindle_order>> spindle{};

frame_bytes bytes_of(std::vector<unsigned> const& told)
{
    frame_bytes bytes;
    for (unsigned const each : told) {
        bytes.push_back(static_cast<std::byte>(each));
    }
    return bytes;
}

/// What becomes of a request to which this comes, in pieces of so many bytes 1 ms apart; and what was sent.
template <typename Link, typename Conversation>
errc outcome_of(Conversation& ask, frame_bytes const& came, frame_bytes const& sent, std::size_t piece = 256)
{
    scripted_line<Link> line{Link{office, once}, office};
    line.heard = [&](frame_bytes const& asked) {
        CHECK(asked == sent);
        std::uint64_t later = 4'000;
        for (std::size_t begin = 0; begin < came.size(); begin += piece, later += 1'100 * piece) {
            std::size_t const end = std::min(came.size(), begin + piece);
            line.say(later, {came.begin() + static_cast<std::ptrdiff_t>(begin),
                             came.begin() + static_cast<std::ptrdiff_t>(end)});
        }
    };
    line.run(500'000, [&](instant now) {
        if (not ask.settled()) {
            line.link.converse(ask, now);
        }
    });
    return ask.outcome().error();
}

frame_bytes const w02_asked = bytes_of({0x01, 0x03, 0x70, 0x02, 0x00, 0x01, 0x3F, 0x0A});
frame_bytes const w02_came = bytes_of({0x01, 0x03, 0x00, 0x02, 0x17, 0x81, 0x2B, 0x9A});
frame_bytes const w03_asked = bytes_of({0x01, 0x03, 0x07, 0xEE, 0x00, 0x02, 0xA5, 0x4A});
frame_bytes const w03_came =
    bytes_of({0x01, 0x03, 0x0C, 0x43, 0x3F, 0x00, 0x00, 0x20, 0x4C, 0x49, 0x54, 0x48, 0x49, 0x55, 0x4D, 0xD0, 0x05});
frame_bytes const w24 = bytes_of({0x01, 0x05, 0x02, 0x13, 0x88, 0xB5, 0x9A});

} // namespace

TEST_CASE("W02: a byte count of 16 bits is read by a request that says so, and refused else")
{
    for (std::size_t const piece : {1U, 3U, 256U}) {
        single_request own{unit_id{1}, read_counted_by_words{{0x7002, 1}}};
        REQUIRE(outcome_of<basic_client<counted_by_words>>(own, w02_came, w02_asked, piece) == errc::none);
        byte_view const pdu = own.outcome()->pdu();
        CHECK((at(pdu, 3) * 256 + at(pdu, 4)) == 0x1781);
        single_request usual{unit_id{1}, read_holding_registers{0x7002, 1}};
        CHECK(outcome_of<client>(usual, w02_came, w02_asked, piece) == errc::wrong_length);
    }
    // Another quantity than was asked for.
    single_request two{unit_id{1}, read_counted_by_words{{0x7002, 2}}};
    CHECK(outcome_of<basic_client<counted_by_words>>(two, w02_came, framed({1, 3, 0x70, 2, 0, 2})) ==
          errc::response_mismatch);
}

TEST_CASE("W03: registers of more than two bytes, by a client that asks little else")
{
    single_request own{unit_id{1}, read_wide{{0x07EE, 2}}};
    REQUIRE(outcome_of<basic_client<wide>>(own, w03_came, w03_asked) == errc::none);
    CHECK(own.outcome()->pdu().size() == 14);
    single_request usual{unit_id{1}, read_holding_registers{0x07EE, 2}};
    CHECK(outcome_of<client>(usual, w03_came, w03_asked) == errc::wrong_length);
}

TEST_CASE("W24: a unit that uses 05 for frames of its own is answered by a copy, which is no echo")
{
    single_request own{unit_id{1}, spindle_order{}};
    CHECK(outcome_of<basic_client<spindle>>(own, w24, w24) == errc::none);
    frame_bytes other = framed({0x01, 0x05, 0x02, 0x13, 0x89});
    single_request again{unit_id{1}, spindle_order{}};
    CHECK(outcome_of<basic_client<spindle>>(again, other, w24) == errc::response_mismatch);
}

TEST_CASE("defect: 43 in a format of one's own is no identification of a device")
{
    for (std::size_t const piece : {1U, 256U}) {
        for (auto const& [came, expected] : {std::pair{framed({1, 0x2B, 7, 2, 8, 9}), errc::none},
                                             std::pair{framed({1, 0x2B, 7, 1, 8}), errc::response_mismatch},
                                             std::pair{framed({1, 0x2B, 7, 9, 8, 9}), errc::wrong_length}}) {
            single_request own{unit_id{1}, encapsulated{}};
            CHECK(outcome_of<basic_client<interfaces>>(own, came, framed({1, 0x2B, 7}), piece) == expected);
        }
    }
}

TEST_CASE("W02: an exception and the other functions are as they were beside a format of one's own")
{
    single_request own{unit_id{1}, read_counted_by_words{{0x7002, 1}}};
    CHECK(outcome_of<basic_client<counted_by_words>>(own, framed({1, 0x83, 2}), w02_asked) ==
          errc::illegal_data_address);
    single_request inputs{unit_id{1}, read_input_registers{3, 1}};
    frame_bytes const asked = framed({1, 4, 0, 3, 0, 1});
    CHECK(outcome_of<basic_client<counted_by_words>>(inputs, framed({1, 4, 2, 0, 7}), asked) == errc::none);
    single_request short_one{unit_id{1}, read_input_registers{3, 1}};
    CHECK(outcome_of<basic_client<counted_by_words>>(short_one, framed({1, 4, 0, 2, 0, 7}), asked) ==
          errc::wrong_length);
}

TEST_CASE("defect: the check of a format of one's own judges a raw request of the function, however short")
{
    for (std::size_t size = 0; size < 5; ++size) {
        CAPTURE(size);
        std::array<std::byte, 4> const data{std::byte{0x07}, std::byte{0xEE}, std::byte{0}, std::byte{2}};
        frame_bytes asked = bytes_of({1, 3, 7, 0xEE, 0, 2});
        asked.resize(2 + size);
        std::vector<unsigned> plain;
        for (std::byte const each : asked) {
            plain.push_back(std::to_integer<unsigned>(each));
        }
        for (auto const& [came, expected] :
             {std::pair{w03_came, errc::none}, std::pair{framed({1, 3, 2, 0, 7}), errc::response_mismatch}}) {
            single_request raw{unit_id{1}, raw_pdu{function_code::read_holding_registers, byte_view{data}.first(size)}};
            CHECK(outcome_of<basic_client<wide>>(raw, came, framed(plain)) == expected);
        }
    }
}

TEST_CASE("W05, W06: a unit at a reserved address is asked by name")
{
    single_request words{unit_id::reserved(248), read_input_registers{0, 8}};
    frame_bytes const w06 = bytes_of({0xF8, 0x04, 0x10, 0x04, 0x95, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
                                      0x00, 0x02, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x8D, 0xC8});
    REQUIRE(outcome_of<client>(words, w06, bytes_of({0xF8, 0x04, 0x00, 0x00, 0x00, 0x08, 0xE5, 0xA5})) == errc::none);
    CHECK(words.outcome()->to<read_input_registers>()->registers[0] == 0x0495);

    frame_bytes const w05 = bytes_of({0xF8, 0x41, 0x37, 0x21, 0xB7, 0x78});
    single_request address{unit_id::reserved(248),
                           raw_pdu{function_code{0x41}, std::array{std::byte{0x37}, std::byte{0x21}}}};
    CHECK(outcome_of<client>(address, w05, w05) == errc::none);
    // The response of another unit is none.
    single_request other{unit_id::reserved(248), read_input_registers{0, 1}};
    CHECK(outcome_of<client>(other, framed({7, 4, 2, 0, 7}), framed({0xF8, 4, 0, 0, 0, 1})) == errc::timed_out);
    for (std::uint32_t const none : {0U, 1U, 247U, 256U, 504U}) {
        CHECK(unit_id::checked_reserved(none).error() == errc::invalid_unit);
    }
    CHECK(unit_id::checked_reserved(255)->byte() == 255);
}

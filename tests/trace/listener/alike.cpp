// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames that begin alike, or are alike, in both directions: what tells them apart is the exchange, not how bytes arrive.
#include <rtuwire/trace/line_listener.hpp>

#include <array>
#include <string>

#include "support/byte_list.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/adu.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing slow{19'200, character_format::even_8_1};

/// Reads one register; its first seven bytes are a response of one register, since its CRC ends with 00.
constexpr auto read_02b0 = "04 03 02 B0 00 01 84 00"_hex;
constexpr auto one_register = "04 03 02 00 07 35 86"_hex;
constexpr auto write_5 = "07 06 21 32 00 05 E2 5C"_hex;
constexpr auto damaged_write_5 = "07 06 21 32 01 05 E2 5C"_hex;

static_assert(crc16(read_02b0) == 0 and crc16(byte_view{read_02b0}.first(7)) == 0);
static_assert(crc16(one_register) == 0 and crc16(write_5) == 0 and crc16(damaged_write_5) != 0);

/// What a listener says, one letter a report: Request, response, Late, Stray response, Unanswered, Damaged or noise.
class story {
public:
    constexpr story() { tap_.advance(now_, *this); }

    constexpr void hear(byte_view frame, bool in_one_piece = false)
    {
        for (std::size_t i = 0; i < frame.size(); ++i) {
            now_ = now_ + slow.characters(1);
            if (not in_one_piece) {
                tap_.receive(frame.subspan(i, 1), now_, *this);
            }
        }
        if (in_one_piece) {
            tap_.receive(frame, now_, *this);
        }
    }
    constexpr void wait(duration length)
    {
        now_ = now_ + length;
        tap_.advance(now_, *this);
    }
    constexpr void operator()(heard_frame const& it)
    {
        bool const is_response = it.frame.role == frame_role::response;
        letters_[size_++] = it.is_unanswered                          ? 'U'
                            : it.frame.role == frame_role::unknown    ? 'D'
                            : not is_response                         ? 'R'
                            : it.frame.verdict == frame_verdict::good ? 'r'
                            : it.frame.verdict == frame_verdict::late ? 'L'
                                                                      : 'S';
    }
    constexpr bool is(char const* told) const
    {
        std::size_t at = 0;
        while (at < size_ and told[at] == letters_[at]) {
            ++at;
        }
        return at == size_ and told[at] == '\0';
    }

private:
    line_listener tap_{slow};
    instant now_{0xFFFF'0000U};
    std::array<char, 32> letters_{};
    std::size_t size_{0};
};

constexpr bool repetitions_are_requests()
{
    bool holds = true;
    for (bool const in_one_piece : {false, true}) {
        for (duration const pause : {milliseconds(600), milliseconds(1200)}) {
            story told;
            told.wait(milliseconds(10));
            told.hear(read_02b0, in_one_piece);
            told.wait(pause);
            told.hear(read_02b0, in_one_piece);
            told.wait(milliseconds(5));
            told.hear(one_register, in_one_piece);
            told.wait(milliseconds(5));
            holds = test::is(told.is("RURr"), "a repetition whose CRC ends with 00") and holds;
        }
    }
    return holds;
}

constexpr bool broadcasts_follow_responses()
{
    constexpr auto all_units = "00 06 21 35 00 00 92 29"_hex;
    story told;
    told.wait(milliseconds(10));
    told.hear(read_02b0);
    told.wait(milliseconds(5));
    // A response that might be the same request, were it not for the broadcast right behind it.
    constexpr auto alike = byte_view{read_02b0};
    told.hear(alike.first(7));
    told.hear(all_units);
    told.wait(milliseconds(5));
    return test::is(told.is("RrR"), "the 00 behind the response is a broadcast's");
}

constexpr bool responses_alone_are_responses()
{
    story told;
    told.wait(milliseconds(10));
    told.hear(one_register);
    told.wait(milliseconds(5));
    return test::is(told.is("S"), "a response whose request was not heard");
}

constexpr bool repeated_bytes_stay_in_pairs()
{
    story told;
    told.wait(milliseconds(10));
    told.hear(damaged_write_5);
    told.wait(milliseconds(5));
    told.hear(write_5);
    for (int i = 0; i < 3; ++i) {
        told.wait(milliseconds(80));
        told.hear(write_5);
        told.wait(milliseconds(5));
        told.hear(write_5);
    }
    told.wait(milliseconds(5));
    return test::is(told.is("DSRrRrRr"), "behind a damaged request");
}

constexpr bool ends_of_requests_have_responses()
{
    story told;
    told.hear(byte_view{write_5}.last(5));
    told.wait(milliseconds(5));
    told.hear(write_5);
    told.wait(milliseconds(80));
    told.hear(write_5);
    told.wait(milliseconds(5));
    told.hear(write_5);
    told.wait(milliseconds(5));
    return test::is(told.is("DSRr"), "joined in the middle of a request");
}

/// Function 16: byte count and first value are the CRC that a response with this head has.
constexpr bool heads_are_no_responses()
{
    constexpr auto write_two = "01 10 10 04 00 02 04 C9 01 02 03 10 A1"_hex;
    static_assert(crc16(write_two) == 0 and crc16(byte_view{write_two}.first(8)) == 0);
    story told;
    told.wait(milliseconds(10));
    told.hear(write_two);
    told.wait(milliseconds(5));
    return test::is(told.is("R"), "a request is whole");
}

} // namespace

PROOF("a repeated request whose CRC ends with 00 is no response", repetitions_are_requests)
PROOF("a 00 behind a response may begin a broadcast", broadcasts_follow_responses)
PROOF("a response alone is a response", responses_alone_are_responses)
PROOF("responses that repeat a damaged request do not take the place of the next request", repeated_bytes_stay_in_pairs)
PROOF("the response to a request of which the end was heard is one", ends_of_requests_have_responses)
PROOF("the head of a request is no response", heads_are_no_responses)

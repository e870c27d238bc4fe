// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Answers on which other stacks failed, each whole, byte by byte, and glued to a good one.
#include <rtuwire/client/client.hpp>

#include "support/byte_list.hpp"
#include "support/catch.hpp"
#include "support/manual_unit.hpp"

using namespace rtuwire;
using test::byte_list;
using test::bytes_of;
using test::glued;
using test::manual_unit;

namespace {

/// A request and its good response.
struct exchange {
    char const* request;
    char const* response;
};
constexpr exchange one_word{"01 03 0C 81 00 01 D7 72", "01 03 02 12 34 B5 33"};
constexpr exchange six_words{"01 03 0C 81 00 06 96 B0", "01 03 0C 00 01 00 02 00 03 00 04 00 05 00 06 DC 2F"};
constexpr exchange write_cmd{"01 06 21 35 00 0F D3 FC", "01 06 21 35 00 0F D3 FC"};
constexpr exchange write_block{"01 10 21 35 00 01 02 00 0F D2 F3", "01 10 21 35 00 01 1B FB"};
constexpr exchange everyone{"00 06 21 35 00 0F D2 2D", ""};

struct row {
    char const* id;
    exchange asked;
    char const* heard;
    errc expected; ///< none: the good response was in it
};

constexpr auto code_7f = static_cast<errc>(0x7F);
constexpr row rows[] = {
    {"C01", one_word, "01 03 02 12 34 B4 33", errc::crc_mismatch},
    {"C03", one_word, "01 03 00 20 F0", errc::wrong_length},
    {"C04", one_word, "01 03 03 12 34 56 73 75", errc::wrong_length},
    {"C05", one_word, "01 03 FB 00*251 16 45", errc::wrong_length},
    {"C06", one_word, "01 03 FF 00*255 14 AE", errc::frame_too_long},
    {"C07", one_word, "01 00 FF 00*40 E6 FC", errc::wrong_function},
    {"C09", one_word, "01 04 02 12 34 B4 47", errc::wrong_function},
    {"C11", one_word, "01 83 02 C0 E1", errc::crc_mismatch},
    {"C13", one_word, "01 83 06 C1 32", errc::server_device_busy},
    {"C14", one_word, "01 83 7F 00 D0", code_7f},
    {"C16", one_word, "01 86 02 00 01", errc::crc_mismatch},
    {"C17", one_word, "01 03 02 12 34 B5 33 00", errc::none},
    {"C19", one_word, "00 01 03 02 12 34 B5 33", errc::crc_mismatch},
    {"C20", one_word, "01 03 01 03 02 12 34 B5 33", errc::crc_mismatch},
    {"C22", six_words, "01 03 0C 81 00 06 96 B0", errc::line_echo},
    {"C24", write_cmd, "01 06 21 35 00 0E 12 3C", errc::response_mismatch},
    {"C26", write_block, "01 10 21 35 00 02 5B FA", errc::response_mismatch},
    {"C27", one_word, "01 03 02 12 34", errc::crc_mismatch},
    {"C28", one_word, "01 03 02 12 34 B5 33 01 03 02 12 34 B5 33", errc::none},
    {"C30", everyone, "00 06 21 35 00 0F D2 2D", errc::none},
};

constexpr client_options impatient{.response_timeout = milliseconds(300), .retries = 0};
constexpr retry_policy once{.response_timeout = milliseconds(300), .retries = 0, .busy_retries = 0};

struct questioner : manual_unit {
    byte_list request;

    explicit questioner(client_options const& options = impatient) : manual_unit{options} {}

    /// What came of a request after these bytes in lumps of a size; valid until the next request.
    result<byte_view> outcome_of(exchange const& what, byte_view heard, std::size_t lump)
    {
        request = bytes_of(what.request);
        REQUIRE(link.start(request_frame{request}, now, once).has_value());
        while (not transmit()) {
            REQUIRE(link.poll_deadline().has_value());
            now = reached(now, *link.poll_deadline()) ? now : *link.poll_deadline();
            link.advance(now);
        }
        while (not heard.empty()) {
            byte_view const some = heard.first(lump < heard.size() ? lump : heard.size());
            heard = heard.subspan(some.size());
            say(some);
        }
        run(milliseconds(900));
        auto const outcome = link.poll_outcome();
        REQUIRE(outcome);
        if (not *outcome) {
            return outcome->error();
        }
        return (*outcome)->pdu();
    }
};

/// Whether an outcome is the good response of an exchange, and nothing but that.
bool is_good(result<byte_view> const& outcome, exchange const& what)
{
    byte_list const response = bytes_of(what.response);
    byte_view const pdu =
        response.empty() ? byte_view{} : byte_view{response}.subspan(1, response.size() - adu_overhead);
    return outcome and same_bytes(*outcome, pdu);
}

bool is_expected(result<byte_view> const& outcome, row const& of)
{
    return of.expected == errc::none ? is_good(outcome, of.asked) : outcome == of.expected;
}

} // namespace

TEST_CASE("every malformed answer gets its error, whole and byte by byte")
{
    for (row const& each : rows) {
        for (std::size_t const lump : {std::size_t{300}, std::size_t{1}}) {
            INFO(each.id << " in lumps of " << lump);
            questioner unit;
            CHECK(is_expected(unit.outcome_of(each.asked, bytes_of(each.heard), lump), each));
            byte_list const good = bytes_of(one_word.response);
            CHECK(is_good(unit.outcome_of(one_word, good, lump), one_word));
        }
    }
}

TEST_CASE("glued to a good response it is an error still, or the good response")
{
    for (row const& each : rows) {
        INFO(each.id);
        byte_list const good = bytes_of(each.asked.response);
        questioner behind;
        auto const outcome = behind.outcome_of(each.asked, glued(bytes_of(each.heard), good), 300);
        CHECK((is_good(outcome, each.asked) or not outcome));
        questioner before;
        CHECK(is_good(before.outcome_of(each.asked, glued(good, bytes_of(each.heard)), 300), each.asked));
    }
}

TEST_CASE("C19 with one byte of noise allowed is the response")
{
    questioner unit{{.response_timeout = milliseconds(300), .retries = 0, .max_leading_noise = 1}};
    for (std::size_t const lump : {std::size_t{300}, std::size_t{1}}) {
        CHECK(is_good(unit.outcome_of(one_word, bytes_of("00 01 03 02 12 34 B5 33"), lump), one_word));
        CHECK(unit.outcome_of(one_word, bytes_of("00 00 01 03 02 12 34 B5 33"), lump) == errc::crc_mismatch);
        CHECK(unit.outcome_of(one_word, bytes_of("01 03 01 03 02 12 34 B5 33"), lump) == errc::crc_mismatch);
    }
}

TEST_CASE("C32: what comes while nothing is asked is nobody's answer")
{
    questioner unit;
    byte_list const good = bytes_of(one_word.response);
    unit.say(good);
    unit.run(milliseconds(10));
    auto const outcome = unit.outcome_of(one_word, bytes_of("01 03 02 56 78 87 C6"), 300);
    REQUIRE(outcome);
    CHECK(same_bytes(*outcome, bytes_of("03 02 56 78")));
}

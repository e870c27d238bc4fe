// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Answers on which other stacks failed, and ten and more to a request of each function beside those of holding registers:
// each whole, byte by byte, in growing chunks, and glued to a good one.
#include <rtuwire/client/client.hpp>

#include "scenario/responses_of_functions.hpp"
#include "support/byte_list.hpp"
#include "support/catch.hpp"
#include "support/feeding.hpp"
#include "support/manual_unit.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using test::byte_list;
using test::bytes_of;
using test::feeding;
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

    /// What came of a request after these bytes, which come so; valid until the next request.
    result<byte_view> outcome_of(exchange const& what, byte_view heard, feeding how = feeding::whole)
    {
        request = bytes_of(what.request);
        REQUIRE(link.start(request_frame{request}, now, once).has_value());
        while (not transmit()) {
            REQUIRE(link.poll_deadline().has_value());
            now = reached(now, *link.poll_deadline()) ? now : *link.poll_deadline();
            link.advance(now);
        }
        test::feed(heard, how, [this](byte_view some) { say(some); });
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

/// Asks by the conversation of a function, with the decoder of its response.
struct typed_questioner : test::basic_manual_unit<host_client> {
    typed_questioner() : basic_manual_unit{impatient} {}

    /// What came of a request after these bytes, which come so; of several frames what came of the first that ended it.
    template <typename Request> errc outcome_of(Request const& request, byte_view heard, feeding how = feeding::whole)
    {
        single_request ask{unit_id{1}, request};
        link.converse(ask, now);
        while (not transmit()) {
            REQUIRE(link.poll_deadline().has_value());
            now = reached(now, *link.poll_deadline()) ? now : *link.poll_deadline();
            link.advance(now);
            link.converse(ask, now);
        }
        test::feed(heard, how, [this](byte_view some) { say(some); });
        run(ask, milliseconds(900));
        auto const outcome = ask.outcome();
        if (not outcome) {
            return outcome.error();
        }
        taken.assign(outcome->pdu().begin(), outcome->pdu().end());
        return outcome->template to<Request>().error();
    }

    /// Whether exactly this frame is taken for the response, after these bytes.
    template <typename Request> bool takes(Request const& request, byte_view heard, byte_view response)
    {
        return outcome_of(request, heard) == errc::none and
               same_bytes(taken, response.subspan(1, response.size() - adu_overhead));
    }

    byte_list taken{};
};

/// Whether the bytes of a function's responses tell their end; of a loopback, silence does.
template <typename Request> constexpr bool tells_its_end = not requires(Request const& request) { request.what; };

} // namespace

TEST_CASE("every malformed answer gets its error, whole, byte by byte and in growing chunks")
{
    for (row const& each : rows) {
        for (feeding const how : test::feedings) {
            INFO(each.id << " in chunks: " << static_cast<int>(how));
            questioner unit;
            CHECK(is_expected(unit.outcome_of(each.asked, bytes_of(each.heard), how), each));
            byte_list const good = bytes_of(one_word.response);
            CHECK(is_good(unit.outcome_of(one_word, good, how), one_word));
        }
    }
}

TEST_CASE("glued to a good response it is an error still, or the good response")
{
    for (row const& each : rows) {
        INFO(each.id);
        byte_list const good = bytes_of(each.asked.response);
        questioner behind;
        auto const outcome = behind.outcome_of(each.asked, glued(bytes_of(each.heard), good));
        CHECK((is_good(outcome, each.asked) or not outcome));
        questioner before;
        CHECK(is_good(before.outcome_of(each.asked, glued(good, bytes_of(each.heard))), each.asked));
    }
}

TEST_CASE("of every function: a malformed answer gets its error, and the next good one is taken")
{
    test::for_each_request([](auto const& request, char const* response, test::response_rows const& all) {
        byte_list const good = bytes_of(response);
        for (test::response_row const& each : all) {
            byte_list const heard = bytes_of(each.frame);
            for (feeding const how : test::feedings) {
                INFO(each.frame << ", " << each.why << ", in chunks: " << static_cast<int>(how));
                typed_questioner unit;
                errc const outcome = unit.outcome_of(request, heard, how);
                INFO("is " << static_cast<int>(outcome) << ", not " << static_cast<int>(each.expected));
                CHECK((outcome == each.expected));
                CHECK(unit.takes(request, good, good));
            }
        }
    });
}

TEST_CASE("of every function: glued to a good response it is an error still, or the good response")
{
    test::for_each_request([](auto const& request, char const* response, test::response_rows const& all) {
        byte_list const good = bytes_of(response);
        for (test::response_row const& each : all) {
            byte_list const heard = bytes_of(each.frame);
            INFO(each.frame << ", " << each.why);
            typed_questioner behind;
            errc const outcome = behind.outcome_of(request, glued(heard, good));
            CHECK((outcome != errc::none or
                   same_bytes(behind.taken, byte_view{good}.subspan(1, good.size() - adu_overhead))));
            CHECK(behind.takes(request, good, good));
            typed_questioner before;
            bool const ends = tells_its_end<std::remove_cvref_t<decltype(request)>>;
            CHECK(before.takes(request, glued(good, heard), good) == ends);
            CHECK(before.takes(request, good, good));
        }
    });
}

TEST_CASE("C19 with one byte of noise allowed is the response")
{
    questioner unit{{.response_timeout = milliseconds(300), .retries = 0, .max_leading_noise = 1}};
    for (feeding const how : test::feedings) {
        CHECK(is_good(unit.outcome_of(one_word, bytes_of("00 01 03 02 12 34 B5 33"), how), one_word));
        CHECK(unit.outcome_of(one_word, bytes_of("00 00 01 03 02 12 34 B5 33"), how) == errc::crc_mismatch);
        CHECK(unit.outcome_of(one_word, bytes_of("01 03 01 03 02 12 34 B5 33"), how) == errc::crc_mismatch);
    }
}

TEST_CASE("C32: what comes while nothing is asked is nobody's answer")
{
    questioner unit;
    byte_list const good = bytes_of(one_word.response);
    unit.say(good);
    unit.run(milliseconds(10));
    auto const outcome = unit.outcome_of(one_word, bytes_of("01 03 02 56 78 87 C6"));
    REQUIRE(outcome);
    CHECK(same_bytes(*outcome, bytes_of("03 02 56 78")));
}

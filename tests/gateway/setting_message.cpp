// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which messages of a broker may change a device, and which never.
#include "messages/setting_message.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "messages/utc_time.hpp"
#include "support/catch.hpp"

namespace {

using namespace tool::gateway;

// 2026-11-30T01:02:03Z, by `date -u -d 2026-11-30T01:02:03Z +%s`.
constexpr std::uint64_t now = 1'796'000'523'000'000;

setting_message read(std::string_view text) { return read_setting_message(text, {now}); }

std::string expiring_at(std::string_view time) { return R"({"value":1,"expires":")" + std::string{time} + "\"}"; }

bool is_refused(std::string_view text, std::string_view word, setting_result how = setting_result::refused)
{
    setting_message const found = read(text);
    INFO(text << ": " << found.why);
    return found.refused == how and found.why.find(word) != std::string::npos;
}

} // namespace

TEST_CASE("a setting that names its value and its end may be written")
{
    setting_message const found = read(R"({"value": 21.5, "expires": "2026-11-30T01:02:08Z", "id": "a1"})");
    CHECK_FALSE(found.refused);
    CHECK(found.value == "21.5");
    CHECK(found.id == R"("a1")");
    CHECK(found.expires == now + 5'000'000);
}

TEST_CASE("values of a setting are as somebody would type them")
{
    auto const value_of = [](std::string const& json) {
        setting_message const found = read(R"({"value":)" + json + R"(,"expires":"2026-11-30T01:02:08Z"})");
        return found.refused ? "refused: " + found.why : found.value;
    };
    CHECK(value_of("7") == "7");
    CHECK(value_of("-50") == "-50");
    CHECK(value_of("0.00001") == "0.00001");
    CHECK(value_of("1e3") == "1000");
    CHECK(value_of("18446744073709551615") == "18446744073709551615");
    CHECK(value_of("true") == "on");
    CHECK(value_of("false") == "off");
    CHECK(value_of("\"heat\"") == "heat");
    CHECK(value_of("null").starts_with("refused"));
    CHECK(value_of("[1]").starts_with("refused"));
    CHECK(value_of("{}").starts_with("refused"));
    CHECK(value_of("1e999").starts_with("refused"));
    CHECK(value_of("NaN").starts_with("refused"));
}

TEST_CASE("what a broker kept is never written, however fresh it looks")
{
    setting_message const found = read_setting_message(R"({"value": 1, "expires": "2026-11-30T01:02:08Z", "id": 7})",
                                                       {.time = now, .is_retained = true});
    CHECK(found.refused == setting_result::refused);
    CHECK(found.id == "7");
}

TEST_CASE("what came before the connection was complete is never written")
{
    setting_message const found = read_setting_message(R"({"value": 1, "expires": "2026-11-30T01:02:08Z"})",
                                                       {.time = now, .is_connected = false});
    CHECK(found.refused == setting_result::refused);
    CHECK(found.id == "null");
}

TEST_CASE("a setting has an end, and it is neither past nor far ahead")
{
    CHECK(is_refused(R"({"value": 1})", "expires"));
    CHECK(is_refused(R"({"value": 1, "expires": 1796000525})", "expires"));
    CHECK(is_refused(expiring_at("2026-11-30T01:02:03Z"), "expired", setting_result::expired));
    CHECK(is_refused(expiring_at("2026-11-30T01:02:02.999Z"), "expired", setting_result::expired));
    CHECK(is_refused(expiring_at("1999-11-30T01:02:08Z"), "expired", setting_result::expired));
    CHECK_FALSE(read(expiring_at("2026-11-30T01:02:03.001Z")).refused);
    CHECK_FALSE(read(expiring_at("2026-11-30T01:03:03Z")).refused);
    CHECK(is_refused(expiring_at("2026-11-30T01:03:03.001Z"), "60 s"));
    CHECK(is_refused(expiring_at("9999-11-30T01:03:03Z"), "60 s"));
}

TEST_CASE("a message that is no setting is refused with what is wrong")
{
    CHECK(is_refused("", "JSON"));
    CHECK(is_refused("21.5", "JSON"));
    CHECK(is_refused("{\"value\": 1", "JSON"));
    CHECK(is_refused("[1]", "JSON"));
    CHECK(is_refused("\xFF\xFE", "JSON"));
    CHECK(is_refused(R"({"expires":"2026-11-30T01:02:08Z"})", "value"));
    CHECK(is_refused(R"({"value":1,"value":2,"expires":"2026-11-30T01:02:08Z"})", "twice"));
    CHECK(is_refused(R"({"value":1,"expire":"2026-11-30T01:02:08Z"})", "did you mean 'expires'"));
    CHECK(is_refused(R"({"value":1,"expires":"2026-11-30T01:02:08Z","id":[1]})", "id"));
    CHECK(is_refused(R"({"value":1,"expires":"2026-11-30T01:02:08Z","id":")" + std::string(65, 'x') + "\"}", "id"));
    CHECK(is_refused(std::string(1'025, ' '), "1024"));
    // A key of a value's own is none of the message.
    CHECK(is_refused(R"({"value":{"value":1},"expires":"2026-11-30T01:02:08Z"})", "number"));
}

TEST_CASE("times are those of ISO 8601 with their zone, and no others")
{
    CHECK(time_in("1970-01-01T00:00:00Z") == 0U);
    CHECK(time_in("2026-11-30T01:02:03Z") == now);
    CHECK(time_in("2026-11-30T02:02:03+01:00") == now);
    CHECK(time_in("2026-11-29T19:32:03-0530") == now);
    CHECK(time_in("2026-11-30T01:02:03.25Z") == now + 250'000);
    CHECK(time_in("2026-11-30T01:02:03.123456789+00:00") == now + 123'456);
    CHECK(time_in("2028-02-29T00:00:00Z"));
    for (std::string_view const wrong : {"",
                                         "2026-11-30",
                                         "2026-11-30T01:02:03",
                                         "2026-11-30 01:02:03Z",
                                         "2026-11-30T01:02Z",
                                         "2026-11-30T24:00:00Z",
                                         "2026-11-30T01:60:00Z",
                                         "2026-11-30T01:02:60Z",
                                         "2026-13-01T00:00:00Z",
                                         "2026-00-01T00:00:00Z",
                                         "2026-11-31T00:00:00Z",
                                         "2027-02-29T00:00:00Z",
                                         "2026-11-30T01:02:03.Z",
                                         "2026-11-30T01:02:03Zx",
                                         "2026-11-30T01:02:03+24:00",
                                         "-026-11-30T01:02:03Z",
                                         "2026-11-3T01:02:03Z",
                                         "1796000523",
                                         "1970-01-01T00:00:00+01:00",
                                         "2026-11-30T01:02:03+1:00",
                                         " 2026-11-30T01:02:03Z"}) {
        INFO(wrong);
        CHECK_FALSE(time_in(wrong));
    }
    CHECK(utc_text(now + 456'789) == "2026-11-30T01:02:03.456Z");
    CHECK(utc_text(0) == "1970-01-01T00:00:00.000Z");
}

TEST_CASE("an answer gives back the id as it came")
{
    CHECK(answer_text("\"a1\"", setting_result::done, "", now) ==
          R"({"id":"a1","result":"done","why":"","time":"2026-11-30T01:02:03.000Z"})");
    CHECK(answer_text("7", setting_result::expired, "late", now) ==
          R"({"id":7,"result":"expired","why":"late","time":"2026-11-30T01:02:03.000Z"})");
    CHECK(answer_text("null", setting_result::failed, "\x1B", now) ==
          R"({"id":null,"result":"failed","why":"\u001b","time":"2026-11-30T01:02:03.000Z"})");
}

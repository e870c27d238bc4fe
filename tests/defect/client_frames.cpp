// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is not the whole response is never its value: cut short by silence, longer than its own byte count, or begun
// in time on a host and ended by silence.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/statistics.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

auto const adapter = line_timing::host(19'200, character_format::even_8_1);

/// The ways in which bytes are handed over: whole, one by one, or so many at a time. Where a lump is longer than
/// the silence that ends a frame, the line is one of a host.
struct feeding {
    std::size_t lump;
    line_timing timing;
};
std::array<feeding, 6> const feedings{feeding{1, office_line}, feeding{3, office_line}, feeding{256, office_line},
                                      feeding{1, adapter},     feeding{16, adapter},    feeding{256, adapter}};

/// What came of a request where the unit says this, in lumps of so many bytes, and then falls silent.
series asked(frame_bytes const& request, frame_bytes const& said, feeding const& how)
{
    line_timing const& timing = how.timing;
    scripted_line<host_client> line{host_client{timing, once}, timing};
    series conversation{[&](unsigned) { return request; }, 1};
    line.heard = [&, lump = how.lump](frame_bytes const&) {
        std::uint64_t const begin = line.time() + 5'000;
        for (std::size_t i = 0; i < said.size(); i += lump) {
            std::size_t const end = std::min(i + lump, said.size());
            line.arrive(begin + line.length_of(end), {said.begin() + static_cast<std::ptrdiff_t>(i),
                                                      said.begin() + static_cast<std::ptrdiff_t>(end)});
        }
    };
    line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
    conversation.make = {};
    return conversation;
}

/// A response of function 04 with so many bytes of data, right to its end, whose first `cut` bytes have a right CRC.
frame_bytes with_right_start(unsigned data_bytes, std::size_t cut)
{
    std::vector<unsigned> content{1, 4, data_bytes};
    while (content.size() < 3 + data_bytes) {
        content.push_back(0x30 + static_cast<unsigned>(content.size()));
        if (content.size() == cut - 2) {
            frame_bytes const start = framed(content);
            content.push_back(at(start, cut - 2));
            content.push_back(at(start, cut - 1));
        }
    }
    return framed(content);
}

} // namespace

TEST_CASE("defect: D4 a response of a raw function that is cut short by silence has no value")
{
    frame_bytes const request = framed({1, 4, 0, 0, 0, 26});
    frame_bytes const whole = with_right_start(52, 17);
    REQUIRE(whole.size() == 57);
    frame_bytes const cut{whole.begin(), whole.begin() + 17};
    REQUIRE(crc16(cut) == 0);
    for (feeding const& how : feedings) {
        INFO("in lumps of " << how.lump);
        series const conversation = asked(request, cut, how);
        CHECK(conversation.number == 1);
        CHECK(conversation.answered == 0);
        CHECK(conversation.last == errc::wrong_length);
        CHECK(asked(request, whole, how).answered == 1);
    }
}

TEST_CASE("defect: D4 a response without its last byte has no value though its CRC is right")
{
    // The example of the published rule: a match of the CRC is never the end of a frame.
    frame_bytes const request = framed({1, 4, 0, 0, 0, 1});
    frame_bytes const whole = framed({1, 4, 2, 3, 1});
    frame_bytes const cut{whole.begin(), whole.end() - 1};
    REQUIRE(at(whole, 6) == 0);
    REQUIRE(crc16(cut) == 0);
    for (feeding const& how : feedings) {
        INFO("in lumps of " << how.lump);
        CHECK(asked(request, cut, how).answered == 0);
        CHECK(asked(request, whole, how).answered == 1);
    }
}

TEST_CASE("defect: D4 a response longer than its own byte count has no value though its CRC is right")
{
    frame_bytes const request = framed({1, 4, 0, 0, 0, 6});
    std::vector<unsigned> content{1, 4, 12};
    for (unsigned i = 0; i < 52; ++i) {
        content.push_back(0x40 + i);
    }
    frame_bytes const longer = framed(content);
    for (feeding const& how : feedings) {
        INFO("in lumps of " << how.lump);
        CHECK(asked(request, longer, how).answered == 0);
        CHECK(asked(request, with_right_start(12, 9), how).answered == 1);
    }
}

TEST_CASE("defect: D15 a response that only silence ends has its whole time on a host")
{
    frame_bytes const request = framed({1, 8, 0, 0, 0xA5, 0x37});
    for (std::uint64_t begin = 5'000; begin < 100'000; begin += 5'000) {
        INFO("it begins after " << begin << " us");
        scripted_line<host_client> line{host_client{adapter, once}, adapter};
        series conversation{[&](unsigned) { return request; }, 1};
        line.heard = [&](frame_bytes const& frame) { line.say(begin, frame); };
        line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
        CHECK(conversation.answered == 1);
    }
    // And one that never begins is given up within the same time and the silence.
    scripted_line<host_client> line{host_client{adapter, once}, adapter};
    std::uint64_t over = 0;
    series conversation{[&](unsigned) { return request; }, 1};
    conversation.took = [&](unsigned, result<response> const&) { over = line.time(); };
    line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
    CHECK(conversation.last == errc::timed_out);
    std::uint64_t const taken = over - line.departures.at(0).end;
    CHECK(taken >= 150'000);
    CHECK(taken <= 155'000);
}

namespace {

using counting = basic_client<observed_by<unit_statistics<2>>>;

unsigned count_of(counters const* row, line_event what) { return row == nullptr ? 0 : (*row)[what]; }

} // namespace

TEST_CASE("defect: D17 noise takes no unit's row")
{
    scripted_line<counting> line{counting{office_line, once}, office_line};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    for (unsigned noise : {0x37U, 0x51U, 0x63U, 0x75U}) {
        line.say(1'000, {static_cast<std::byte>(noise)});
        line.run(20'000, [](instant) {});
    }
    CHECK(line.link.statistics().unit(0x37) == nullptr);
    CHECK(line.link.statistics().line()[line_event::noise] == 4);
    series first{[](unsigned) { return read_of(1, 3201); }, 1};
    series second{[](unsigned) { return read_of(2, 3201); }, 1};
    line.run(100'000, [&](instant now) { line.link.converse(first, now); });
    line.run(100'000, [&](instant now) { line.link.converse(second, now); });
    CHECK(count_of(line.link.statistics().unit(1), line_event::reply) == 1);
    CHECK(count_of(line.link.statistics().unit(2), line_event::reply) == 1);
}

TEST_CASE("defect: D17 noise during a quarantine is late of nobody, and a late answer counts once")
{
    for (unsigned const noise : {0xFFU, 0xF8U, 0x00U, 0x37U}) {
        INFO("noise " << noise);
        scripted_line<counting> line{counting{office_line, once}, office_line};
        series conversation{[](unsigned) { return read_of(1, 3201); }, 1};
        line.run(110'000, [&](instant now) { line.link.converse(conversation, now); });
        REQUIRE(conversation.last == errc::timed_out);
        line.say(1'000, {static_cast<std::byte>(noise)});
        line.run(20'000, [](instant) {});
        CHECK(line.link.statistics().line()[line_event::late] == 0);
        CHECK(line.link.statistics().line()[line_event::noise] == 1);
        CHECK(line.link.statistics().unit(static_cast<std::uint8_t>(noise)) == nullptr);
    }
    for (bool const is_whole : {true, false}) {
        scripted_line<counting> line{counting{office_line, once}, office_line};
        series conversation{[](unsigned) { return read_of(1, 3201); }, 1};
        line.run(110'000, [&](instant now) { line.link.converse(conversation, now); });
        frame_bytes const late = response_to(read_of(1, 3201));
        REQUIRE(late.size() == 7);
        if (is_whole) {
            line.say(1'000, late);
        } else {
            for (std::size_t i = 0; i < late.size(); ++i) {
                line.say(1'000 + line.length_of(i), {late[i]});
            }
        }
        line.run(50'000, [](instant) {});
        CHECK(line.link.statistics().line()[line_event::late] == 1);
        CHECK(line.link.statistics().line()[line_event::noise] == 0);
        CHECK(count_of(line.link.statistics().unit(1), line_event::late) == 1);
    }
}

TEST_CASE("defect: (f) a clock that steps back by a microsecond ends no frame")
{
    for (std::size_t back_at = 0; back_at < 7; ++back_at) {
        for (bool const in_advance : {false, true}) {
            INFO("before byte " << back_at << (in_advance ? " by advance" : ""));
            scripted_line<client> line{client{office_line, once}, office_line};
            series conversation{[](unsigned) { return read_of(1, 3201); }, 1};
            line.run(2'000, [&](instant now) { line.link.converse(conversation, now); });
            REQUIRE(line.departures.size() == 1);
            instant now{static_cast<std::uint32_t>(line.departures[0].end)};
            line.link.sent(now);
            frame_bytes const said = response_to(read_of(1, 3201));
            now = now + milliseconds(5);
            for (std::size_t i = 0; i < said.size(); ++i) {
                now = i == back_at ? now - microseconds(1)
                                   : now + (i == back_at + 1 ? microseconds(1) : microseconds(573));
                if (in_advance and i == back_at) {
                    line.link.advance(now - microseconds(1));
                }
                line.link.receive(byte_view{said}.subspan(i, 1), now);
                line.link.advance(now);
            }
            line.link.converse(conversation, now);
            CHECK(conversation.answered == 1);
        }
    }
}

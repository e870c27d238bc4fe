// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units that depart from a function's format: a right CRC and another size. Frames and sizes are from reports of users and the
// tables of the specification.
#include "client_line.hpp"

#include <string_view>

#include "support/catch.hpp"

#include <rtuwire/wire/errc_name.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

struct departure_of_format {
    char const* what;
    frame_bytes asked;
    frame_bytes came;
    std::size_t due;
};

std::vector<departure_of_format> departures()
{
    return {
        {"W11, a second code of an exception", read_of(1, 0), framed({1, 0x83, 2, 0}), 5},
        {"W12, a byte more inside of the CRC", write_of(2, 0, 0), framed({2, 6, 0, 0, 0, 0, 6}), 8},
        {"W13, no byte count", read_of(1, 0, 4), framed({1, 3, 0, 0, 0, 0, 0, 0, 0, 0}), 13},
        {"W14, a byte count of the whole frame", framed({0x20, 17}),
         framed({0x20, 17, 0x10, 0xFF, 'h', 'm', '-', '1', '.', '0', '-', '5', '5', 0}), 21},
        {"a byte count of 16 bits", read_of(1, 0x7002), framed({1, 3, 0, 2, 0x17, 0x81}), 7},
        {"registers of four bytes", framed({9, 4, 0, 5, 0, 2}), framed({9, 4, 8, 1, 2, 3, 4, 5, 6, 7, 8}), 9},
        {"twelve coils in one byte", framed({7, 1, 0, 0, 0, 12}), framed({7, 1, 1, 5}), 7},
        {"a write of many that repeats its bytes", framed({3, 16, 0, 1, 0, 1, 2, 0, 9}),
         framed({3, 16, 0, 1, 0, 1, 2, 0, 9, 0}), 8},
        {"a page of identification without its objects", framed({5, 43, 14, 1, 0}), framed({5, 43, 14, 1, 1, 0}), 0},
    };
}

} // namespace

TEST_CASE("defect: D33 a right CRC and a wrong length tell the frame, what came and what was due")
{
    CHECK(name(errc::wrong_length).find("right CRC") != std::string_view::npos);
    for (departure_of_format const& each : departures()) {
        INFO(each.what);
        scripted_line<client> line{client{office_line, once}, office_line};
        line.heard = [&](frame_bytes const&) { line.say(4'000, each.came); };
        series conversation{[&](unsigned) { return each.asked; }, 1};
        line.run(400'000, [&](instant now) { line.link.converse(conversation, now); });
        REQUIRE(conversation.number == 1);
        CHECK(conversation.last == errc::wrong_length);
        auto const refused = line.link.refused();
        REQUIRE(refused);
        CHECK(frame_bytes(refused->bytes.begin(), refused->bytes.end()) == each.came);
        CHECK(refused->due == each.due);
    }
}

TEST_CASE("defect: D33 what was refused is told of the last request alone, and never as something else")
{
    frame_bytes const longer = framed({1, 3, 2, 0, 7, 0});
    frame_bytes const good = response_to(read_of(1, 5));
    frame_bytes damaged = good;
    damaged[3] ^= std::byte{0x10};
    struct {
        frame_bytes first, then;
        bool is_told;
    } const rows[]{{longer, {}, true},    {good, {}, false},     {{}, {}, false},
                   {damaged, {}, true},   {longer, good, false}, {longer, framed({1}), false},
                   {longer, longer, true}};
    for (auto const& row : rows) {
        scripted_line<client> line{client{office_line, once}, office_line};
        line.heard = [&](frame_bytes const&) {
            line.say(4'000, row.first.empty() ? framed({77, 3}) : row.first);
            if (not row.then.empty()) {
                line.say(60'000, row.then.size() < 4 ? frame_bytes{std::byte{1}} : row.then);
            }
        };
        CHECK_FALSE(line.link.refused());
        series conversation{[](unsigned) { return read_of(1, 5); }, 1};
        line.run(400'000, [&](instant now) { line.link.converse(conversation, now); });
        REQUIRE(conversation.number == 1);
        auto const refused = line.link.refused();
        CHECK(refused.has_value() == row.is_told);
        if (refused) {
            CHECK(frame_bytes(refused->bytes.begin(), refused->bytes.end()) == row.first);
        }
    }
}

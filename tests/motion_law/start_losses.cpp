// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A start that loses its drive on the way up: one response may be missing, behind the second in a row nothing is said but
// words that stop, and then nothing until the drive has stopped by itself.
#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/simulated_bus.hpp"

#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 0};
constexpr std::uint16_t cmd = device::layout.cmd;

/// A request as the drive heard it.
struct heard_request {
    instant at;
    std::vector<std::byte> frame;

    bool is_write() const { return frame[1] == std::byte{6}; }
    bool writes(std::uint16_t word) const
    {
        return is_write() and u16_at(frame, 2) == cmd and u16_at(frame, 4) == word;
    }
};

/// A drive that was checked before; the responses to some requests behind the start's first command get lost.
struct next_step : test::simulated_bus<drive_client<2>, device> {
    static constexpr station<device> drive{unit_id{3}};
    std::vector<heard_request> heard{};
    bool has_commanded{false};

    explicit next_step(std::size_t first_lost, std::size_t lost)
        : test::simulated_bus<drive_client<2>, device>{drive_client<2>{test::bus_timing, patient}}
    {
        add(unit_id{3});
        disturb([=, this](auto& frame, bool is_request) {
            if (is_request) {
                has_commanded = has_commanded or frame[1] == std::byte{6};
                if (has_commanded) {
                    heard.push_back({now(), frame});
                }
            } else if (heard.size() > first_lost and heard.size() <= first_lost + lost) {
                frame.clear();
            }
        });
        idle(milliseconds(20));
    }
};

start started()
{
    return start{next_step::drive, 50_Hz, run_direction::forward, milliseconds(20'000), test::commissioned()};
}

} // namespace

TEST_CASE("motion law: a start bears any one answer that is missing on its way up")
{
    for (std::size_t lost = 0; lost < 8; ++lost) {
        INFO("request " << lost);
        next_step it{lost, 1};
        start go = started();
        REQUIRE(it.run(go));
        CHECK(go.succeeded());
        CHECK(it.heard.back().frame[1] == std::byte{3});
    }
}

TEST_CASE("motion law: L4 behind two answers in a row that are missing a start says nothing but "
          "words that stop")
{
    for (std::size_t first = 0; first < 6; ++first) {
        INFO("the first one is that of request " << first);
        next_step it{first, 10'000};
        start go = started();
        instant const begin = it.now();
        REQUIRE(it.run(go));
        CHECK(go.reason().kind == outcome_kind::silent);
        CHECK(it.now() - begin < milliseconds(60'000));
        REQUIRE(it.heard.size() > first + 3);
        instant last_word = it.heard[first + 1].at;
        for (std::size_t i = first + 2; i < it.heard.size(); ++i) {
            heard_request const& each = it.heard[i];
            if (each.at - last_word > milliseconds(1'000)) {
                CHECK(each.at - last_word >= milliseconds(11'000)); // its own 10 s, and one more
                break;
            }
            CHECK((each.writes(0x0000) or each.writes(0x0007)));
            last_word = each.at;
        }
        CHECK(last_word - it.heard[first].at > milliseconds(1'900));
        CHECK(last_word - it.heard[first].at < milliseconds(2'500));
    }
}

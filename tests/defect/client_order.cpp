// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames leave one after the other, whole, and as they were asked for: whatever becomes of the conversation that
// asked. The transmitter stands for a DMA: it reads each byte when its start bit begins.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <optional>
#include <type_traits>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/bus.hpp>
#if __has_include(<rtuwire/ask/single_request.hpp>)
#include <rtuwire/ask/single_request.hpp>
#endif

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;
using namespace rtuwire::altivar;

namespace {

constexpr client_options one_try{.response_timeout = milliseconds(100), .retries = 0};
constexpr std::uint64_t silence = 2'005; ///< 3.5 characters

using wire = scripted_line<client>;

wire line_of(client_options const& with = one_try) { return wire{client{office_line, with}, office_line}; }

series reader(unsigned unit, unsigned address)
{
    return series{[=](unsigned) { return read_of(unit, address); }, 1};
}

frame_bytes long_write(unsigned unit)
{
    std::vector<unsigned> content{unit, 16, 0x21, 0x98, 0, 20, 40};
    for (unsigned i = 0; i < 40; ++i) {
        content.push_back(0xA0 + i);
    }
    return framed(content);
}

} // namespace

TEST_CASE("defect: D12 a frame that is leaving when it is cancelled leaves whole before the next")
{
    for (std::uint64_t cancelled = 0; cancelled <= 6'600; cancelled += 300) {
        INFO("cancelled after " << cancelled << " us");
        wire line = line_of();
        series first = reader(1, 3201);
        series second = reader(2, 3202);
        line.heard = [&](frame_bytes const& frame) {
            if (at(frame, 0) == 2) {
                line.say(20'000, response_to(frame));
            }
        };
        bool is_cancelled = false;
        line.run(500'000, [&](instant now) {
            line.alarm = line.departures.empty() ? 0 : line.departures[0].begin + cancelled;
            bool const is_time = not line.departures.empty() and line.time() >= line.alarm;
            if (is_time and not is_cancelled) {
                is_cancelled = true;
                line.link.cancel(now);
            }
            line.link.converse(first, now);
            if (is_cancelled and first.settled()) {
                line.link.converse(second, now);
            }
        });
        CHECK(first.last == errc::cancelled);
        REQUIRE(line.departures.size() == 2);
        CHECK(line.overtaken == 0);
        CHECK(line.changed == 0);
        CHECK(line.departures[1].begin >= line.departures[0].end + silence);
        CHECK(line.departures[1].frame == read_of(2, 3202));
        CHECK(second.answered == 1);
    }
}

TEST_CASE("defect: D12 a broadcast that is cancelled keeps its turnaround")
{
    for (std::uint64_t cancelled = 0; cancelled < 100'000; cancelled += 2'500) {
        INFO("cancelled after " << cancelled << " us");
        wire line = line_of();
        series everyone{[](unsigned) { return write_of(0, 8501, 0); }, 1};
        series next = reader(2, 3202);
        line.heard = [&](frame_bytes const& frame) {
            if (at(frame, 0) == 2) {
                line.say(20'000, response_to(frame));
            }
        };
        bool is_cancelled = false;
        line.run(500'000, [&](instant now) {
            line.alarm = line.departures.empty() ? 0 : line.departures[0].begin + cancelled;
            bool const is_time = not line.departures.empty() and line.time() >= line.alarm;
            if (is_time and not is_cancelled) {
                is_cancelled = true;
                line.link.cancel(now);
            }
            line.link.converse(everyone, now);
            if (everyone.settled()) {
                line.link.converse(next, now);
            }
        });
        CHECK(everyone.last == errc::cancelled);
        REQUIRE(line.departures.size() == 2);
        CHECK(line.departures[1].begin >= line.departures[0].end + 100'000);
        CHECK(next.answered == 1);
    }
}

TEST_CASE("defect: D12 where nobody says that a frame has left, the next waits for its limit")
{
    for (unsigned const unit : {0U, 1U}) {
        INFO("unit " << unit);
        wire line = line_of();
        line.reports = false;
        series first{[=](unsigned) { return write_of(unit, 8501, 0); }, 1};
        series next = reader(2, 3202);
        line.run(1'000'000, [&](instant now) {
            line.link.converse(first, now);
            if (first.settled()) {
                line.link.converse(next, now);
            }
        });
        CHECK(first.last == errc::transmit_stalled);
        REQUIRE(line.departures.size() == 2);
        CHECK(line.overtaken == 0);
        std::uint64_t const after = line.departures[1].begin - line.departures[0].end;
        CHECK(after >= (unit == 0 ? 100'000 : silence));
        CHECK(after <= 250'000);
    }
}

TEST_CASE("defect: D12 a broadcast that nobody reported keeps its turnaround after the latest time "
          "it may have left")
{
    constexpr client_options hasty{.response_timeout = milliseconds(20), .retries = 0};
    wire line = line_of(hasty);
    line.reports = false;
    series everyone{[](unsigned) { return write_of(0, 8501, 0); }, 1};
    series next = reader(2, 3202);
    line.run(1'000'000, [&](instant now) {
        line.link.converse(everyone, now);
        line.link.converse(next, now);
    });
    REQUIRE(line.departures.size() == 2);
    // Its transmitter may have begun as late as its limit of 20 ms allows.
    CHECK(line.departures[1].begin >= line.departures[0].end + 20'000 + 100'000);
}

TEST_CASE("defect: DMA the bytes of a request are its own until sent, whatever becomes of its "
          "conversation")
{
    enum class fate { destroyed, remade, cancelled, begun_anew, disturbed };
    for (fate const what : {fate::destroyed, fate::remade, fate::cancelled, fate::begun_anew, fate::disturbed}) {
        for (bool const is_long : {false, true}) {
            frame_bytes const asked = is_long ? long_write(1) : read_of(1, 3201);
            for (std::size_t at_byte = 0; at_byte < asked.size(); ++at_byte) {
                INFO("fate " << static_cast<int>(what) << " at byte " << at_byte);
                wire line = line_of();
                std::optional<series> conversation{series{[&](unsigned) { return asked; }, 1}};
                series other = reader(2, 3202);
                bool is_done = false;
                line.heard = [&](frame_bytes const& frame) {
                    if (at(frame, 0) == 2) {
                        line.say(5'000, response_to(frame));
                    }
                };
                line.run(1'500'000, [&](instant now) {
                    bool const is_time = not line.departures.empty() and
                                         line.time() >= line.departures[0].begin + line.length_of(at_byte);
                    if (is_time and not is_done) {
                        is_done = true;
                        switch (what) {
                        case fate::destroyed:
                            std::fill(conversation->frame.begin(), conversation->frame.end(), std::byte{0xEE});
                            conversation.reset();
                            break;
                        case fate::remade:
                            std::fill(conversation->frame.begin(), conversation->frame.end(), std::byte{0xEE});
                            conversation.emplace([](unsigned) { return write_of(3, 1, 2); }, 1U);
                            break;
                        case fate::cancelled: line.link.cancel(now); break;
                        case fate::begun_anew:
                            conversation->forget();
                            conversation->frame.assign(asked.size(), std::byte{0xDD});
                            conversation->make = [](unsigned) { return write_of(3, 1, 2); };
                            conversation->number = 0;
                            break;
                        case fate::disturbed: line.link.receive(response_to(read_of(1, 0x1234, 20)), now); break;
                        }
                    }
                    if (conversation) {
                        line.link.converse(*conversation, now);
                    }
                    if (is_done) {
                        line.link.converse(other, now);
                    }
                });
                REQUIRE(is_done);
                CHECK(line.changed == 0);
                CHECK(line.overtaken == 0);
                CHECK(line.departures[0].frame == asked);
                CHECK(other.answered == 1);
                if (what == fate::remade or what == fate::begun_anew) {
                    // The new one asks for itself, and has not taken the old one's outcome for its own.
                    CHECK(conversation->number == 1);
                    bool const has_asked =
                        std::any_of(line.departures.begin(), line.departures.end(),
                                    [](departure const& each) { return each.frame == write_of(3, 1, 2); });
                    CHECK(has_asked);
                }
            }
        }
    }
}

namespace {

using two_places = read_plan<atv320::device, atv320::rfr, atv320::lfrd>;
static_assert(two_places::request_count == 2);

} // namespace

TEST_CASE("defect: D3 a poller that is begun again while its request is out files each value under "
          "its register")
{
    // Begun again at each moment of a round, 33 ms long.
    for (std::uint64_t begun = 500; begun < 60'000; begun += 500) {
        INFO("begun again after " << begun << " us");
        wire line = line_of();
        poller<two_places> panel{station<atv320::device>{unit_id{1}}};
        line.heard = [&](frame_bytes const& frame) { line.say(10'000, response_to(frame)); };
        std::uint64_t const start = line.time();
        bool is_begun = false;
        line.alarm = start + begun;
        panel.again();
        line.run(500'000, [&](instant now) {
            if (line.time() >= start + begun and not is_begun) {
                is_begun = true;
                panel.again();
            }
            if (not panel.settled()) {
                line.link.converse(panel, now);
            }
        });
        REQUIRE(panel.settled());
        CHECK(panel.outcome());
        // Each register holds its address.
        CHECK(panel.latest().get<atv320::rfr>().count() == 3202);
        CHECK(panel.latest().get<atv320::lfrd>().count() == 8602);
    }
}

TEST_CASE("defect: (b) an outcome that is read one pass later on a bus is still the own one")
{
    scripted_line<bus<2>> line{bus<2>{office_line, one_try}, office_line};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    single_request first{unit_id{1}, read_holding_registers{3201, 2}};
    single_request second{unit_id{2}, read_holding_registers{8601, 2}};
    line.run(300'000, [&](instant now) {
        if (not first.settled()) {
            line.link.converse(0, first, now);
        }
        if (not second.settled()) {
            line.link.converse(1, second, now);
        }
    });
    REQUIRE(first.settled());
    REQUIRE(second.settled());
    auto const of_first = first.outcome();
    auto const of_second = second.outcome();
    REQUIRE(of_first);
    REQUIRE(of_second);
    CHECK(u16_at(of_first->pdu(), 2) == 3201);
    CHECK(u16_at(of_first->pdu(), 4) == 3202);
    CHECK(u16_at(of_second->pdu(), 2) == 8601);
    CHECK(u16_at(of_second->pdu(), 4) == 8602);
}

TEST_CASE("defect: (b) a loop over the bytes of a response holds them after the response itself is gone")
{
    frame_bytes const frame = response_to(read_of(1, 3201));
    auto const made = [&] { return response{byte_view{frame}.subspan(1, frame.size() - 3)}; };
    unsigned sum = 0;
    for (std::byte const each : made().pdu()) {
        sum += static_cast<unsigned>(each);
    }
    CHECK(sum == 3 + 2 + 0x0C + 0x81);
    CHECK_FALSE(std::is_reference_v<decltype(made().pdu())>);
}

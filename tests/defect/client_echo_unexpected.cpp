// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that gives back what is sent, and a client on a host that was not told so: the request and its response arrive
// together. And a unit that gave back a request once, on a line that does not.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr line_timing host = line_timing::host(9'600, character_format::none_8_1);
constexpr line_timing board{9'600, character_format::none_8_1};
constexpr client_options once{.response_timeout = milliseconds(300), .late_response = milliseconds(10), .retries = 0};

frame_bytes asked(unsigned function, unsigned address, unsigned unit = 1)
{
    std::vector<unsigned> said{unit, function, address >> 8U, address & 0xFFU};
    auto const add = [&](std::initializer_list<unsigned> more) { said.insert(said.end(), more); };
    switch (function) {
    case 5: add({0xFF, 0}); break;
    case 6: add({0, 7}); break;
    case 8: said = {unit, 8, 0, 0, address >> 8U, address & 0xFFU}; break;
    case 15: add({0, 9, 2, 0x55, 1}); break;
    case 16: add({0, 2, 4, 0x12, 0x34, 0x56, 0x78}); break;
    case 22: add({0, 0xF2, 0, 0x25}); break;
    case 23: add({0, 1, 0x10, 0, 0, 1, 2, 0, 7}); break;
    case 43: said = {unit, 43, 14, 1, 0}; break;
    default: add({0, 1});
    }
    return framed(said);
}

frame_bytes answer(frame_bytes const& to)
{
    unsigned const unit = at(to, 0);
    unsigned const function = at(to, 1);
    switch (function) {
    case 1:
    case 2: return framed({unit, function, 1, 1});
    case 3:
    case 4:
    case 23: return framed({unit, function, 2, 0, 7});
    case 15:
    case 16: return framed({unit, function, at(to, 2), at(to, 3), at(to, 4), at(to, 5)});
    case 43: return framed({unit, 43, 14, 1, 1, 0, 0, 1, 0, 1, 0x41});
    default: return to;
    }
}

constexpr unsigned functions[]{1, 2, 3, 4, 15, 16, 23, 43};
/// Whose response is the request: their echo looks like it.
constexpr unsigned mirrored[]{5, 6, 8, 22};
constexpr unsigned addresses[]{0, 100, 0x0200, 1000, 3201, 8501};

/// What arrives after a request; nothing is a silence that ends a frame.
using chunks = std::vector<frame_bytes>;
using story = std::function<chunks(frame_bytes const&)>;

frame_bytes joined(frame_bytes one, frame_bytes const& other)
{
    one.insert(one.end(), other.begin(), other.end());
    return one;
}
chunks cut(frame_bytes const& all, std::size_t at)
{
    auto const middle = all.begin() + static_cast<std::ptrdiff_t>(std::min(at, all.size()));
    return middle == all.begin() or middle == all.end() ? chunks{all}
                                                        : chunks{{all.begin(), middle}, {middle, all.end()}};
}
chunks one_by_one(frame_bytes const& all)
{
    chunks each;
    for (std::byte const byte : all) {
        each.push_back({byte});
    }
    return each;
}
story only_echo(std::size_t at)
{
    return [=](frame_bytes const& frame) { return cut(frame, at); };
}
story both(std::size_t at)
{
    return [=](frame_bytes const& frame) { return cut(joined(frame, answer(frame)), at); };
}
story only_answer()
{
    return [](frame_bytes const& frame) { return chunks{answer(frame)}; };
}
story damaged(std::size_t bit)
{
    return [=](frame_bytes const& frame) {
        frame_bytes echo = frame;
        echo.at(bit / 8 % echo.size()) ^= static_cast<std::byte>(1U << bit % 8);
        return chunks{joined(echo, answer(frame))};
    };
}

/// A client or a bus on a line that does these things after its requests, one after the other, the last one for ever.
template <typename Link> struct line_of {
    scripted_line<Link> line;
    std::vector<story> stories;
    std::vector<errc> outcomes{};

    line_of(Link const& made, line_timing const& timing, std::vector<story> what)
        : line{made, timing}, stories{std::move(what)}
    {
        line.heard = [this, timing](frame_bytes const& frame) {
            story const& now = stories[std::min(line.departures.size(), stories.size()) - 1];
            std::uint64_t after = 2'000;
            for (frame_bytes const& chunk : now(frame)) {
                after += chunk.empty() ? timing.frame_end().microseconds + 2'000 : 0;
                bool const is_whole = timing.frame_end() > timing.t3_5(); // a board gets each byte as it ends
                for (frame_bytes const& each : is_whole ? chunks{chunk} : one_by_one(chunk)) {
                    if (each.empty()) {
                        continue; // that would be a damaged byte
                    }
                    line.say(after, each);
                    after += line.length_of(each.size()) + 100;
                }
            }
        };
    }
    /// What becomes of these requests.
    void run(std::vector<frame_bytes> const& requests)
    {
        series all{[&](unsigned i) { return requests[i]; }, static_cast<unsigned>(requests.size())};
        all.took = [this](unsigned, result<response> const& outcome) { outcomes.push_back(outcome.error()); };
        line.run(20'000'000, [&](instant now) {
            if constexpr (requires { line.link.converse(all, now); }) {
                line.link.converse(all, now);
            } else {
                line.link.converse(0, all, now);
            }
        });
        REQUIRE(outcomes.size() == requests.size());
    }
};
using client_line = line_of<client>;

client_line on(line_timing const& timing, std::vector<story> what, client_options const& with = once)
{
    return client_line{client{timing, with}, timing, std::move(what)};
}

} // namespace

TEST_CASE(
    "defect: D32 an echo and a prompt answer are told as an echo, wherever they are cut, and the next one is taken out")
{
    for (unsigned const function : functions) {
        for (unsigned const address : addresses) {
            frame_bytes const request = asked(function, address);
            std::size_t const size = request.size() + answer(request).size();
            for (line_timing const& timing : {host, board}) {
                for (std::size_t cut_at = 0; cut_at <= size; ++cut_at) {
                    INFO("function " << function << " at " << address << " cut at " << cut_at);
                    auto it = on(timing, {both(cut_at)});
                    it.run({request, request, request});
                    CHECK(it.outcomes == std::vector{errc::line_echo, errc::none, errc::none});
                    CHECK(it.line.link.has_seen_echo());
                }
            }
        }
    }
}

TEST_CASE("defect: D32 an echo alone is told as an echo, in chunks and byte by byte, and then as no response")
{
    for (unsigned const function : functions) {
        for (unsigned const address : addresses) {
            frame_bytes const request = asked(function, address);
            for (line_timing const& timing : {host, board}) {
                INFO("function " << function << " at " << address);
                auto it = on(timing, {only_echo(3), one_by_one, only_echo(0)});
                it.run({request, request, request});
                CHECK(it.outcomes == std::vector{errc::line_echo, errc::timed_out, errc::timed_out});
            }
        }
    }
}

TEST_CASE("defect: D32 the beginning of an echo is no value, although it has a right CRC and size")
{
    unsigned like_a_response = 0;
    for (unsigned unit = 1; unit <= 247; ++unit) {
        for (unsigned address = 0x0200; address <= 0x02FF; ++address) {
            frame_bytes const request = asked(3, address, unit);
            frame_bytes const first{request.begin(), request.begin() + 7};
            if (crc16(first) != 0) {
                continue;
            }
            ++like_a_response;
            INFO("unit " << unit << " at " << address);
            for (story const& how : {only_echo(0), only_echo(7), story{one_by_one}, both(7), both(0)}) {
                for (line_timing const& timing : {host, board}) {
                    auto it = on(timing, {how});
                    it.run({request});
                    CHECK(it.outcomes[0] == errc::line_echo);
                }
            }
            // A unit may answer just so.
            auto it = on(host, {[&](frame_bytes const&) { return chunks{first}; }});
            it.run({request});
            CHECK(it.outcomes[0] == errc::none);
        }
    }
    CHECK(like_a_response > 200);
}

TEST_CASE("defect: D32 a write that was only echoed is not believed on a line that has echoed before")
{
    for (unsigned const function : mirrored) {
        frame_bytes const write = asked(function, 8501);
        frame_bytes const read = asked(3, 3201);
        for (line_timing const& timing : {host, board}) {
            for (std::size_t cut_at = 0; cut_at <= write.size(); ++cut_at) {
                INFO("function " << function << " cut at " << cut_at);
                // Seen once; twice; once, and damaged since; not noticed while damaged.
                auto it = on(timing, {both(0), only_echo(cut_at), both(cut_at)});
                it.run({read, write, write});
                CHECK(it.outcomes == std::vector{errc::line_echo, errc::timed_out, errc::none});
                auto twice = on(timing, {both(0), both(8), only_echo(cut_at), both(cut_at)});
                twice.run({read, read, write, write});
                CHECK(twice.outcomes == std::vector{errc::line_echo, errc::none, errc::timed_out, errc::none});
            }
            for (std::size_t bit = 0; bit < 64; ++bit) {
                INFO("function " << function << " bit " << bit);
                for (unsigned const before : {1U, 2U, 3U}) {
                    std::vector<story> stories(before, both(0));
                    std::vector<frame_bytes> requests(before, read);
                    stories.insert(stories.end(), {damaged(bit), only_echo(0)});
                    requests.insert(requests.end(), {read, write});
                    auto it = on(timing, stories);
                    it.run(requests);
                    CHECK(it.outcomes[before] != errc::none);
                    CHECK(it.outcomes[before + 1] == errc::timed_out);
                    CHECK((it.outcomes[before] == errc::collision) == (before > 1));
                }
                // The answer comes for itself, behind a damaged echo that may look like anything.
                for (std::size_t const size : {2U, 8U}) {
                    auto const apart = [=](frame_bytes const& frame) {
                        frame_bytes first = damaged(bit)(frame).front();
                        first.resize(size);
                        return chunks{first, {}, answer(frame)};
                    };
                    auto it = on(timing, {both(0), story{apart}, only_echo(0)});
                    it.run({read, read, write});
                    CHECK(it.outcomes[2] == errc::timed_out);
                }
            }
        }
    }
}

TEST_CASE("defect: D32 a unit that gave back a request once makes no echo of a line, nor a collision of its answers")
{
    frame_bytes const read = asked(3, 3201);
    for (line_timing const& timing : {host, board}) {
        auto it = on(timing, {only_echo(0), only_answer()});
        it.run({read, read, asked(6, 8501), read});
        CHECK(it.outcomes == std::vector{errc::line_echo, errc::none, errc::none, errc::none});
        CHECK_FALSE(it.line.link.has_seen_echo());
        // A write's response then looks like an echo, and is no proof of one.
        auto late = on(timing, {only_echo(0), only_answer()});
        late.run({read, asked(6, 8501), read, asked(6, 8501)});
        CHECK(late.outcomes == std::vector{errc::line_echo, errc::timed_out, errc::none, errc::none});
        // Twice: then the first answer is a collision, and those behind it are answers.
        auto twice = on(timing, {only_echo(0), only_echo(0), only_answer()});
        twice.run({read, read, read, read, asked(6, 8501)});
        CHECK(twice.outcomes == std::vector{errc::line_echo, errc::timed_out, errc::collision, errc::none, errc::none});
        CHECK_FALSE(twice.line.link.has_seen_echo());
    }
}

TEST_CASE("defect: D32 where the echo is known from the start, the first answer counts")
{
    client_options with = once;
    with.has_line_echo = true;
    for (unsigned const function : {1U, 3U, 4U, 5U, 6U, 8U, 16U, 22U, 23U, 43U}) {
        for (unsigned const address : addresses) {
            INFO("function " << function << " at " << address);
            frame_bytes const request = asked(function, address);
            for (std::size_t const cut_at : {0U, 1U, 7U, 8U, 9U}) {
                auto it = on(host, {both(cut_at), only_echo(cut_at)}, with);
                it.run({request, request});
                CHECK(it.outcomes == std::vector{errc::none, errc::timed_out});
            }
        }
    }
}

TEST_CASE("defect: D32 a bus learns it for all its slots")
{
    for (unsigned const address : addresses) {
        line_of<bus<2>> it{bus<2>{host, once}, host, {both(0), both(3), only_echo(0), both(8)}};
        it.run({asked(3, address), asked(3, address), asked(6, address), asked(6, address)});
        CHECK(it.outcomes == std::vector{errc::line_echo, errc::none, errc::timed_out, errc::none});
        CHECK(it.line.link.has_seen_echo());
    }
}

namespace {

/// A port that gives back what is written, and a unit behind it that answers at once, if it is there.
struct echoing_port {
    std::uint64_t time{0xFFFF'0000U};
    bool is_there{true};
    frame_bytes coming{};

    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    result<void> write(byte_view bytes, instant)
    {
        coming = frame_bytes(bytes.begin(), bytes.end());
        if (is_there) {
            coming = joined(coming, answer(coming));
        }
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        if (coming.empty()) {
            auto const left = static_cast<std::int32_t>(until.microseconds - now().microseconds);
            time += static_cast<std::uint64_t>(std::max(left, 0));
            return place.first(0);
        }
        time += 1'000;
        std::copy(coming.begin(), coming.end(), place.begin());
        return place.first(std::exchange(coming, {}).size());
    }
};

} // namespace

TEST_CASE("defect: D32 a waiting client tells it once, then reads through it, and believes no write without an answer")
{
    for (std::uint16_t const address :
         {std::uint16_t{0}, std::uint16_t{100}, std::uint16_t{1000}, std::uint16_t{3201}}) {
        INFO("address " << address);
        echoing_port port;
        blocking_client line{port, host, once};
        read_holding_registers const read{address, 1};
        CHECK(line.ask(unit_id{1}, read) == errc::line_echo);
        CHECK(line.has_seen_echo());
        auto const value = line.ask(unit_id{1}, read);
        REQUIRE(value);
        CHECK(value->registers[0] == 7);
        port.is_there = false;
        CHECK(line.ask(unit_id{1}, write_single_register{address, 7}) == errc::timed_out);
        port.is_there = true;
        CHECK(line.ask(unit_id{1}, write_single_register{address, 7}));
    }
}

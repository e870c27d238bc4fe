// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The line that misbehaves, in simulated time: a client and a server of this test's own, whose frames and checks share
// nothing with it but the bytes.
#include "../../tools/rtuwire/chaos/disturbed_line.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <rtuwire/trace.hpp>

#include "../../tools/rtuwire/capture/commented_block.hpp"
#include "../../tools/rtuwire/exit_status.hpp"
#include "support/catch.hpp"
#include "support/one_in.hpp"

using namespace tool;

namespace {

using numbers = std::vector<std::uint8_t>; // bytes

constexpr std::uint32_t time_out = 100'000; // us

/// Bit by bit, as the specification draws it.
std::uint16_t crc_of(numbers const& bytes, std::size_t from, std::size_t size)
{
    unsigned crc = 0xFFFF;
    for (std::size_t i = from; i < from + size; ++i) {
        crc ^= bytes[i];
        for (unsigned bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xA001U : crc >> 1U;
        }
    }
    return static_cast<std::uint16_t>(crc);
}

numbers with_crc(numbers bytes)
{
    std::uint16_t const crc = crc_of(bytes, 0, bytes.size());
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return bytes;
}

std::vector<std::byte> raw(numbers const& bytes)
{
    std::vector<std::byte> all;
    for (std::uint8_t const each : bytes) {
        all.push_back(std::byte{each});
    }
    return all;
}

/// A read, a write of one register and a write of two, one after the other.
numbers request_of(unsigned number)
{
    auto const low = static_cast<std::uint8_t>(number * 7U % 100U);
    switch (number % 3U) {
    case 0: return with_crc({1, 3, 0, low, 0, 2});
    case 1: return with_crc({1, 6, 0, low, 0x12, low});
    default: return with_crc({1, 16, 0, low, 0, 2, 4, 0, low, 1, 2});
    }
}

numbers answer_to(numbers const& request)
{
    switch (request[1]) {
    case 3: return with_crc({1, 3, 4, 0, request[3], 0, static_cast<std::uint8_t>(request[3] + 1)});
    case 6: return request;
    default: return with_crc({1, 16, request[2], request[3], request[4], request[5]});
    }
}

struct conversation {
    std::vector<std::byte> capture{};
    std::vector<std::string> told{};
    numbers to_server{};
    numbers to_client{};
    std::set<numbers> asked{};
    std::uint32_t kept_back{0};
};

/// So many requests, the next where something came or the time-out is over.
conversation held(std::string const& faults, std::uint32_t seed, unsigned count)
{
    conversation all;
    rtuwire::pcapng_blocks blocks;
    numbers server_hears;
    rtuwire::instant now{0xFFFF'0000U}; // the clock turns over on the way
    auto const keep = [&all](rtuwire::byte_view block) {
        all.capture.insert(all.capture.end(), block.begin(), block.end());
    };
    keep(blocks.begin({}, {.unix_microseconds = 0, .at = now}));
    bool has_answer = false;
    disturbed_line line{{.faults = faults_in(faults),
                         .seed = seed,
                         .time_out = rtuwire::microseconds(time_out),
                         .character = rtuwire::microseconds(573),
                         .silence = rtuwire::milliseconds(20)},
                        {[&](frame_way way, rtuwire::byte_view bytes) {
                             for (std::byte const each : bytes) {
                                 (way == frame_way::request ? all.to_server : all.to_client)
                                     .push_back(std::to_integer<std::uint8_t>(each));
                                 if (way == frame_way::request) {
                                     server_hears.push_back(std::to_integer<std::uint8_t>(each));
                                 }
                             }
                             has_answer = has_answer or way == frame_way::answer;
                         },
                         [&](rtuwire::traced_frame const& frame, std::string const& what) {
                             keep(commented(blocks.packet(frame), what));
                             all.told.push_back(what);
                         }}};
    for (unsigned number = 1; number <= count; ++number) {
        numbers const request = request_of(number);
        all.asked.insert(request);
        has_answer = false;
        line.receive(frame_way::request, raw(request), now);
        rtuwire::instant const end = now + rtuwire::microseconds(time_out);
        while (not has_answer and not reached(now, end)) {
            // It answers what is a frame that it knows, and drops anything else.
            if (all.asked.contains(server_hears)) {
                numbers const answer = answer_to(server_hears);
                server_hears.clear();
                line.receive(frame_way::answer, raw(answer), now + rtuwire::microseconds(2'000));
            }
            now = now + rtuwire::microseconds(3'000);
            line.advance(now);
        }
        server_hears.clear();
        now = now + rtuwire::microseconds(5'000);
        line.advance(now);
    }
    all.kept_back = line.counts(frame_way::request).kept_back + line.counts(frame_way::answer).kept_back;
    return all;
}

constexpr char const* everything =
    "delay=5%,late=2%,doubled=5%,foreign=5%,lost=3%,damaged=8%,noise=8%,echo=3%,lumps=10%,split=10%,"
    "cut=0.2%,babble=1%,request-delay=3%,request-lost=3%,request-damaged=8%,request-lumps=5%,"
    "request-split=5%,request-cut=0.2%";

std::size_t count_of(conversation const& all, std::string const& part)
{
    return static_cast<std::size_t>(std::count_if(
        all.told.begin(), all.told.end(), [&part](std::string const& each) { return each.find(part) != each.npos; }));
}

/// How many bytes a request of a function that writes has there; 0 where none begins.
std::size_t size_of_write(numbers const& bytes, std::size_t at)
{
    std::size_t const left = bytes.size() - at;
    if (left < 8) {
        return 0;
    }
    unsigned const function = bytes[at + 1];
    std::size_t size = function == 5 or function == 6 ? 8U : function == 22 ? 10U : 0U;
    size = function == 15 or function == 16 ? 9U + bytes[at + 6] : size;
    size = function == 23 and left > 10 ? 13U + bytes[at + 10] : size;
    return size != 0 and size <= left and crc_of(bytes, at, size) == 0 ? size : 0U;
}

} // namespace

TEST_CASE("the same seed makes the same capture, byte for byte, and another one another")
{
    unsigned const count = 3'000 / rtuwire::test::one_in(3);
    conversation const one = held(everything, 7, count);
    conversation const again = held(everything, 7, count);
    CHECK(one.capture == again.capture);
    CHECK(one.to_client == again.to_client);
    CHECK_FALSE(held(everything, 8, count).capture == one.capture);
    for (char const* const each :
         {"delayed by", "late by", "left: twice", "foreign, an answer of unit", "came: lost", "damaged in",
          "damaged by loss", "damaged by a byte", "left: noise", "given back to the client", "piece 1 of", "came: cut",
          "babble 6 of 6", "came: request-delay", "came: request-lost", "came: request-damaged", "came: request-lumps",
          "came: request-split", "came: request-cut"}) {
        INFO(each);
        CHECK(count_of(one, each) > 0);
    }
}

TEST_CASE("a fault meets the frames that it meets, whatever else is played")
{
    auto const lost_of = [](conversation const& all) {
        std::vector<std::string> names;
        for (std::string const& each : all.told) {
            if (each.starts_with("request ") and each.find("request-lost") != each.npos) {
                names.push_back(each.substr(0, each.find(" came")));
            }
        }
        return names;
    };
    unsigned const part = rtuwire::test::one_in(4);
    auto const alone = lost_of(held("request-lost=3%", 7, 2'000 / part));
    auto const beside = lost_of(held(everything, 7, 2'000 / part));
    REQUIRE(alone.size() > 30 / part);
    CHECK(alone == beside);
    auto const fault = faults_in("request-lost=3%").front();
    std::vector<std::string> foretold;
    for (std::uint32_t number = 1; number <= 2'000 / part; ++number) {
        if (meets(fault, 7, number)) {
            foretold.push_back("request " + std::to_string(number));
        }
    }
    CHECK(alone == foretold);
}

TEST_CASE("rates are kept, moments are met, a cut lasts")
{
    auto const met = [](std::string const& typed, std::uint32_t seed) {
        auto const fault = faults_in(typed).front();
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t number = 1; number <= 100'000; ++number) {
            if (meets(fault, seed, number)) {
                numbers.push_back(number);
            }
        }
        return numbers;
    };
    for (std::uint32_t seed = 1; seed < 6; ++seed) {
        for (char const* const each : {"late=1%", "lost=1%", "damaged=1%", "request-delay=1%"}) {
            std::size_t const count = met(each, seed).size();
            INFO(each << " " << seed << ": " << count);
            CHECK((count > 800 and count < 1'200)); // six standard deviations
        }
    }
    CHECK(met("lost@250", 1) == std::vector<std::uint32_t>{250});
    CHECK(met("lost@250x3", 1) == std::vector<std::uint32_t>{250, 251, 252});
    CHECK(met("cut@7", 1) == std::vector<std::uint32_t>{7, 8, 9, 10, 11, 12, 13, 14, 15, 16});
    CHECK(met("cut@7x2", 1) == std::vector<std::uint32_t>{7, 8});
    auto const cuts = met("cut=0.01%", 3);
    REQUIRE(cuts.size() >= 10);
    for (std::uint32_t i = 0; i < 10; ++i) {
        CHECK(cuts[i] == cuts[0] + i);
    }
    CHECK(met("lost=100%", 1).size() == 100'000);
}

TEST_CASE(
    "nothing goes to the server but what the client sent, and no write to the client that the server did not send")
{
    unsigned const part = rtuwire::test::one_in(10);
    conversation const all =
        held("request-damaged=90%,request-delay=10%,request-split=20%,request-lumps=20%,foreign=40%,"
             "damaged=50%,noise=60%,babble=5%,doubled=20%,echo=10%,split=20%,late=5%",
             3, 60'000 / part);
    std::size_t requests = 0;
    for (std::size_t at = 0; at + 8 <= all.to_server.size(); ++at) {
        bool const is_read = all.to_server[at + 1] == 3 and crc_of(all.to_server, at, 8) == 0;
        std::size_t const size = is_read ? 8 : size_of_write(all.to_server, at);
        if (size == 0) {
            continue;
        }
        ++requests;
        auto const begin = all.to_server.begin() + static_cast<std::ptrdiff_t>(at);
        numbers const found{begin, begin + static_cast<std::ptrdiff_t>(size)};
        CHECK(all.asked.contains(found));
    }
    std::size_t writes = 0;
    for (std::size_t at = 0; at + 8 <= all.to_client.size(); ++at) {
        if (std::size_t const size = size_of_write(all.to_client, at); size != 0) {
            ++writes;
            auto const begin = all.to_client.begin() + static_cast<std::ptrdiff_t>(at);
            numbers const found{begin, begin + static_cast<std::ptrdiff_t>(size)};
            CHECK(all.asked.contains(found)); // the answer to 06 is its request, and an echo is
        }
    }
    CHECK(requests > 5'000 / part);
    CHECK(writes > 1'000 / part);
}

TEST_CASE("what is damaged into a request, or completes one, is kept back")
{
    constexpr rtuwire::instant now{7};
    // Noise 07 in front of an answer of unit 6 to function 03 that is, behind it, a write with a right CRC.
    numbers const write = with_crc({7, 6, 3, 2, 0x12, 0x34});
    request_guard client{frame_way::answer};
    CHECK(client.lets_pass(raw({7}), true, now));
    CHECK_FALSE(client.lets_pass(raw({write.begin() + 1, write.end()}), false, now));
    request_guard other{frame_way::answer};
    CHECK(other.lets_pass(raw(write), false, now)); // as it came
    CHECK_FALSE(other.lets_pass(raw(write), true, now));
    numbers const read = with_crc({7, 3, 0, 1, 0, 1});
    CHECK(other.lets_pass(raw(read), true, now)); // reads only
    request_guard server{frame_way::request};
    CHECK_FALSE(server.lets_pass(raw(read), true, now));
    CHECK(server.lets_pass(raw(read), false, now));
    CHECK(server.lets_pass(raw({read.begin(), read.end() - 1}), true, now));
    CHECK_FALSE(server.lets_pass(raw({read.back()}), false, now)); // the byte that was lost comes by another way
}

TEST_CASE("a piece behind which each frame would complete another holds them back for 3 s, and not for ever")
{
    // Behind these the CRC stands as before a first byte, so that each whole frame is also the end of one with these in front.
    numbers damaged{1, 3, 0, 100, 0, 1, 0, 0};
    while (crc_of(damaged, 0, damaged.size()) != 0xFFFF) {
        damaged[7] = static_cast<std::uint8_t>(damaged[7] + 1U);
        damaged[6] = static_cast<std::uint8_t>(damaged[6] + (damaged[7] == 0 ? 1U : 0U));
    }
    auto const at = [](std::uint32_t ms) { return rtuwire::instant{7} + rtuwire::milliseconds(ms); };
    request_guard server{frame_way::request};
    REQUIRE(server.lets_pass(raw(damaged), true, at(0)));
    for (std::uint8_t turn = 1; turn < 15; ++turn) {
        CHECK_FALSE(server.lets_pass(raw(with_crc({1, 3, 0, turn, 0, 1})), false, at(turn * 200U)));
    }
    CHECK(server.lets_pass(raw(with_crc({1, 3, 0, 15, 0, 1})), false, at(3'000)));
    CHECK(server.lets_pass(raw(with_crc({1, 3, 0, 16, 0, 1})), false, at(3'100)));
}

namespace {

/// What goes to the server of these requests, each in the pieces in which it goes; a request every 5 s.
struct piecewise {
    std::vector<std::vector<numbers>> pieces{};
    std::vector<std::string> told{};
};

piecewise passed(std::string const& faults, std::uint32_t seed, numbers const& request, unsigned count)
{
    piecewise all;
    disturbed_line line{{.faults = faults_in(faults),
                         .seed = seed,
                         .time_out = rtuwire::microseconds(time_out),
                         .character = rtuwire::microseconds(573),
                         .silence = rtuwire::milliseconds(20)},
                        {[&](frame_way, rtuwire::byte_view bytes) {
                             auto& last = all.pieces.back().emplace_back();
                             for (std::byte const each : bytes) {
                                 last.push_back(std::to_integer<std::uint8_t>(each));
                             }
                         },
                         [&](rtuwire::traced_frame const&, std::string const& what) { all.told.push_back(what); }}};
    rtuwire::instant now{1};
    for (unsigned i = 0; i < count; ++i) {
        all.pieces.emplace_back();
        line.receive(frame_way::request, raw(request), now);
        for (unsigned step = 0; step < 5'000; ++step) {
            now = now + rtuwire::milliseconds(1);
            line.advance(now);
        }
    }
    return all;
}

numbers joined(std::vector<numbers> const& pieces, std::size_t from, std::size_t end)
{
    numbers all;
    for (std::size_t i = from; i < end; ++i) {
        all.insert(all.end(), pieces[i].begin(), pieces[i].end());
    }
    return all;
}

/// A write of registers to unit 9 that hold these bytes.
numbers request_around(numbers const& data)
{
    auto const size = static_cast<std::uint8_t>(data.size());
    numbers bytes{9, 16, 0, 100, 0, static_cast<std::uint8_t>(size / 2U), size};
    bytes.insert(bytes.end(), data.begin(), data.end());
    return with_crc(bytes);
}

} // namespace

TEST_CASE("no pieces of a request are the request that its data hold")
{
    numbers const inner = with_crc({7, 6, 0x21, 0x35, 0, 0x0F});
    numbers const request = request_around(inner);
    unsigned const count = 2'000 / rtuwire::test::one_in(8);
    for (char const* const faults : {"request-split=100%:20ms", "request-lumps=100%:4ms"}) {
        unsigned cut = 0;
        piecewise const all = passed(faults, 5, request, count);
        for (std::vector<numbers> const& pieces : all.pieces) {
            REQUIRE(joined(pieces, 0, pieces.size()) == request);
            cut += pieces.size() > 1 ? 1U : 0U;
            for (std::size_t from = 0; from < pieces.size(); ++from) {
                for (std::size_t end = from + 1; end <= pieces.size(); ++end) {
                    REQUIRE(joined(pieces, from, end) != inner);
                }
            }
        }
        INFO(faults << ": " << cut);
        CHECK(cut == count); // it is cut still
        CHECK(all.told == passed(faults, 5, request, count).told);
    }
}

TEST_CASE("a request whose data are frames from everywhere to everywhere is not cut")
{
    // Bytes behind which a CRC is as it began: what follows them is a frame as it is without them.
    numbers idle{0, 0};
    while (crc_of(idle, 0, 2) != 0xFFFF) {
        idle[0] = static_cast<std::uint8_t>(idle[0] + 1);
        idle[1] = static_cast<std::uint8_t>(idle[1] + (idle[0] == 0 ? 1 : 0));
        REQUIRE((idle[0] != 0 or idle[1] != 0));
    }
    numbers data;
    for (unsigned i = 0; i < 10; ++i) {
        data.insert(data.end(), idle.begin(), idle.end());
    }
    numbers const inner = with_crc({7, 6, 0x21, 0x35, 0, 0x0F});
    data.insert(data.end(), inner.begin(), inner.end());
    data.resize(data.size() + 20, 0); // a right CRC stays right behind each of them
    numbers const request = request_around(data);
    piecewise const all = passed("request-lumps=100%:1ms", 5, request, 20);
    for (std::vector<numbers> const& pieces : all.pieces) {
        CHECK(pieces == std::vector<numbers>{request});
    }
    CHECK(all.told[1] == "request 1 left: whole, as pieces would be a frame of their own, piece 1 of 1");
}

TEST_CASE("what waits has a bound, and what comes beyond it is lost and told")
{
    numbers const answer = with_crc({1, 3, 4, 0, 1, 0, 2});
    std::size_t sent = 0;
    std::uint32_t lost = 0;
    std::string why;
    disturbed_line line{{.faults = faults_in("late=100%:60s,babble@1:60s"),
                         .seed = 2,
                         .time_out = rtuwire::microseconds(time_out),
                         .character = rtuwire::microseconds(573),
                         .silence = rtuwire::milliseconds(20)},
                        {[&](frame_way, rtuwire::byte_view bytes) { sent += bytes.size(); },
                         [&](rtuwire::traced_frame const& frame, std::string const& what) {
                             if (what.find("came: lost") != what.npos) {
                                 CHECK(frame.bytes.size() == answer.size());
                                 why = why.empty() ? what : why;
                                 ++lost;
                             }
                         }}};
    rtuwire::instant now{1};
    for (unsigned i = 0; i < 20'000; ++i) { // within 20 ms
        now = now + rtuwire::microseconds(1);
        line.receive(frame_way::answer, raw(answer), now);
    }
    INFO(why << "; " << sent);
    CHECK(lost > 10'000);
    CHECK(lost == line.counts(frame_way::answer).met.at("lost"));
    CHECK(line.counts(frame_way::answer).frames == 20'000);
    CHECK(why.find(" bytes wait before it") != why.npos);
    // The rest is on its way still, and the babble goes on as long as it is said, though it is made as it goes.
    for (unsigned i = 0; i < 13'000; ++i) {
        now = now + rtuwire::milliseconds(10);
        line.advance(now);
    }
    CHECK(not line.poll_deadline());
    CHECK(sent > 3'000 * 16 + 65'000);
    CHECK(sent < 3'001 * 16 + 66'000);
    std::uint32_t const before = lost;
    line.receive(frame_way::answer, raw(answer), now); // there is room again
    CHECK(lost == before);
}

TEST_CASE("what has no length is cut by silence, and no byte is lost")
{
    numbers sent, came;
    rtuwire::instant now{5};
    frame_cutter cutter{frame_way::answer, rtuwire::milliseconds(20)};
    std::size_t frames = 0;
    auto const take = [&](rtuwire::byte_view frame) {
        ++frames;
        for (std::byte const each : frame) {
            came.push_back(std::to_integer<std::uint8_t>(each));
        }
    };
    for (numbers const& each :
         {numbers{1, 0x65, 3, 4, 5}, numbers{0xFF}, with_crc({1, 3, 2, 0, 5}), numbers(600, 0x33)}) {
        sent.insert(sent.end(), each.begin(), each.end());
        cutter.receive(raw(each), now, take);
        now = now + rtuwire::milliseconds(25);
        cutter.advance(now, take);
    }
    CHECK(came == sent);
    CHECK(frames == 6); // 600 bytes: 256, 256 and the rest
}

TEST_CASE("a fault that is none is refused with the word and what would be right")
{
    auto const why = [](char const* typed) -> std::string {
        try {
            static_cast<void>(faults_in(typed));
        } catch (ended const& refused) {
            CHECK(refused.status == exit_status::usage);
            return refused.what();
        }
        return {};
    };
    auto const says = [&](char const* typed, char const* part) {
        std::string const text = why(typed);
        INFO(typed << ": " << text);
        CHECK(text.find(part) != text.npos);
    };
    says("lsot=1%", "did you mean 'lost'?");
    says("lost", "lost=1%");
    says("lost=", "no rate");
    says("lost=0%", "no rate");
    says("lost=101%", "no rate");
    says("lost=1", "no rate");
    says("lost=1.2.3%", "no rate");
    says("lost=nan%", "no rate");
    says("lost@0", "no frame");
    says("lost@x3", "no frame");
    says("lost@5x0", "no frame");
    says("lost@99999999999", "no frame");
    says("lost=1%:30ms", "takes no time");
    says("delay=1%:0ms", "no length of time");
    says("delay=1%:2min", "no length of time");
    says("delay:30ms", "how often");
    says("delay=1%=2%", "too much");
    says("lost=1%,", "''");
    says("request-doubled=1%", "motor");
    says("request-noise=1%", "motor");
    says("request-echo=1%", "say echo");
    says("late=1%,lost@5,late=2%", "'late=1%' says that already");
    says("lost@5x3,lost@7", "'lost@5x3' says that already");
    says("lost@7,lost@5x3", "'lost@7' says that already");
    CHECK(why("lost=1%,lost@5,lost@7x2,lost@9,request-lost=1%,request-lost@5").empty());
    CHECK(why("late=0.0001%,lost@250x5,request-delay=5%@3:30ms,babble=100%:2s").empty());
}

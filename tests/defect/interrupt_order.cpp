// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The lines of examples/firmware on a UART made here: what came in while sending stands before "sent", and the
// driver is enabled from before the first bit to after the last.
#include "../../examples/firmware/frames.hpp"
#include "../../examples/firmware/line.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

/// A UART and a pin, worked by hand. What they saw is in `log`.
struct hardware {
    struct got {
        std::byte value;
        bool is_damaged;
        bool is_after_loss;
    };
    static inline std::vector<got> incoming{};
    static inline std::vector<std::byte> outgoing{};
    static inline bool is_idle_now{true}, is_enabled{false}, is_requested{false};
    static inline bool sent_while_disabled{false};
    static inline std::size_t room{1};

    static void reset()
    {
        incoming.clear();
        outgoing.clear();
        is_idle_now = true;
        is_enabled = is_requested = sent_while_disabled = false;
        room = 1;
    }
    static void come(byte_view bytes)
    {
        for (std::byte const each : bytes) {
            incoming.push_back({each, false, false});
        }
    }

    static void clear_interrupts() { is_requested = false; }
    static bool has_byte() { return not incoming.empty(); }
    static got take()
    {
        got const first = incoming.front();
        incoming.erase(incoming.begin());
        return first;
    }
    static bool has_room() { return room > 0; }
    static void put(std::byte value)
    {
        sent_while_disabled = sent_while_disabled or not is_enabled;
        outgoing.push_back(value);
        --room;
    }
    static bool is_idle() { return is_idle_now; }
    static void request_interrupt() { is_requested = true; }
};

struct pin {
    static void set(bool is_on) { hardware::is_enabled = is_on; }
};

/// Sends one frame and notes what it is told.
struct listener {
    std::string told{};
    byte_view frame{};

    void receive(byte_view bytes, instant) { told += std::string(bytes.size(), 'r'); }
    void receive_error(instant) { told += 'e'; }
    void sent(instant) { told += 's'; }
    void advance(instant) {}
    byte_view poll_transmit()
    {
        byte_view const now = frame;
        frame = {};
        return now;
    }
};

constexpr auto request = "07 03 0C 81 00 01 D7 14"_hex;
constexpr auto response = "07 03 02 06 27 73 FE"_hex;

TEST_CASE("defect: (p) a byte that came in while sending is handed over before sent")
{
    hardware::reset();
    board::half_duplex_line<hardware, pin> line;
    listener engine{.frame = request};
    line.serve(engine, instant{0});
    hardware::come("00"_hex);
    for (std::uint32_t now = 1; now < 20; ++now) {
        hardware::room = 1;
        line.on_interrupt(instant{now});
    }
    hardware::come("07"_hex);
    line.on_interrupt(instant{30});
    line.serve(engine, instant{31});
    CHECK(engine.told == "rsr");
}

TEST_CASE("defect: (p) noise while the request leaves does not spoil the answer")
{
    hardware::reset();
    board::half_duplex_line<hardware, pin> line;
    client link{line_timing{19'200, character_format::even_8_1}, {.retries = 0}};
    single_request conversation{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};
    std::uint32_t now = 0;
    auto const pass = [&] {
        line.serve(link, instant{now});
        link.converse(conversation, instant{now});
    };
    for (; not hardware::is_requested and now < 20'000; now += 100) {
        pass();
    }
    REQUIRE(hardware::is_requested);
    hardware::come("00"_hex);
    for (std::size_t i = 0; i < 9; ++i, now += 573) {
        hardware::room = 1;
        line.on_interrupt(instant{now});
    }
    REQUIRE(hardware::outgoing == std::vector<std::byte>(request.begin(), request.end()));
    for (std::byte const each : response) {
        now += 573;
        hardware::come({&each, 1});
        line.on_interrupt(instant{now});
    }
    // The loop comes round only now.
    pass();
    REQUIRE(conversation.settled());
    REQUIRE(conversation.outcome());
    byte_view const got = conversation.outcome()->pdu();
    CHECK(std::vector<std::byte>(got.begin(), got.end()) ==
          std::vector<std::byte>(response.begin() + 1, response.end() - 2));
}

TEST_CASE("firmware: the driver is enabled from before the first bit to after the last")
{
    hardware::reset();
    board::half_duplex_line<hardware, pin> line;
    listener engine{.frame = request};
    line.serve(engine, instant{0});
    CHECK(hardware::is_enabled);
    CHECK(hardware::is_requested);
    hardware::is_idle_now = false;
    for (std::uint32_t now = 1; now < 20; ++now) {
        hardware::room = 1;
        line.on_interrupt(instant{now});
    }
    CHECK(hardware::outgoing.size() == request.size());
    CHECK(not hardware::sent_while_disabled);
    CHECK(hardware::is_enabled);
    line.serve(engine, instant{20});
    CHECK(engine.told.empty());
    hardware::is_idle_now = true;
    line.on_tick(instant{21});
    CHECK(not hardware::is_enabled);
    CHECK(not line.is_served());
    line.serve(engine, instant{22});
    CHECK(engine.told == "s");
    line.on_tick(instant{23});
    CHECK(line.is_served());
}

TEST_CASE("firmware: damage reaches the engine in its place")
{
    hardware::reset();
    board::half_duplex_line<hardware, pin> line;
    listener engine;
    hardware::incoming = {{std::byte{1}, false, false}, {std::byte{2}, true, false}, {std::byte{3}, false, true}};
    line.on_interrupt(instant{5});
    line.serve(engine, instant{5});
    CHECK(engine.told == "reer");
}

/// Whole frames: the stand-in for the DMA on the same hardware.
struct frame_bench {
    using dma = board::dma_stand_in<hardware>;

    frame_bench()
    {
        hardware::reset();
        line.begin();
    }
    void come(byte_view bytes)
    {
        hardware::come(bytes);
        dma::on_interrupt(line);
    }
    void on_silence()
    {
        for (int i = 0; i < 6; ++i) {
            dma::on_tick(line);
        }
    }
    void let_leave()
    {
        for (int i = 0; i < 20; ++i) {
            hardware::room = 1;
            dma::on_interrupt(line);
        }
    }

    board::frame_line<dma, pin> line{};
};

constexpr auto short_request = "01 03 00 00 00 01 84 0A"_hex;

TEST_CASE("firmware: a frame comes whole by DMA and is answered in its place")
{
    frame_bench it;
    word_bank<4> bank;
    loopback_only diagnostics;
    it.come(byte_view{short_request}.first(3));
    it.come(byte_view{short_request}.subspan(3));
    CHECK(it.line.poll_frame().size == 0);
    CHECK(it.line.is_served());
    it.on_silence();
    CHECK(not it.line.is_served());
    auto const [place, size] = it.line.poll_frame();
    REQUIRE(size == short_request.size());
    byte_span const out = response_frame(place, size, unit_id{1}, bank, server_profile{}, diagnostics);
    REQUIRE(out.size() == 7);
    it.line.send(out);
    CHECK(hardware::is_enabled);
    hardware::is_idle_now = false;
    it.let_leave();
    CHECK(hardware::outgoing.size() == 7);
    CHECK(not hardware::sent_while_disabled);
    CHECK(hardware::is_enabled);
    CHECK(it.line.poll_frame().size == 0);
    hardware::is_idle_now = true;
    it.on_silence();
    CHECK(not hardware::is_enabled);
    CHECK(it.line.poll_frame().size == 0);
    // The next one, in the other place, and the one after it.
    for (int i = 0; i < 4; ++i) {
        it.come(short_request);
        it.on_silence();
        REQUIRE(it.line.poll_frame().size == short_request.size());
        it.line.release();
    }
    CHECK(it.line.dropped() == 0);
}

TEST_CASE("firmware: damaged, early and late frames are dropped and counted")
{
    frame_bench it;
    hardware::incoming = {{std::byte{1}, true, false}};
    it.come(short_request);
    it.on_silence();
    CHECK(it.line.poll_frame().size == 0);
    CHECK(it.line.dropped() == 1);
    // While the loop has one, the next is dropped.
    it.come(short_request);
    it.on_silence();
    auto const first = it.line.poll_frame();
    REQUIRE(first.size == short_request.size());
    it.come(request);
    it.on_silence();
    CHECK(it.line.dropped() == 2);
    CHECK(first.place[0] == short_request[0]);
    // Something is heard before the response leaves: it does not leave.
    it.come(byte_view{request}.first(2));
    it.line.send(first.place.first(7));
    CHECK(not hardware::is_enabled);
    CHECK(not hardware::is_requested);
    it.come(byte_view{request}.subspan(2));
    it.on_silence();
    CHECK(it.line.poll_frame().size == request.size());
}

} // namespace

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The simulated line: what it carries, and what each of its faults does.
#include <rtuwire/sim/line/line.hpp>

#include <vector>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/sim/line/usb_adapter.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using detail::character;
using sim::line_faults;

namespace {

constexpr auto frame = "01 03 0C 81 00 01 D7 72"_hex;
constexpr auto ones = "FF FF FF FF FF FF FF FF"_hex;
constexpr line_timing timing{19'200, character_format::even_8_1};

std::vector<character> heard_of(sim::line& wire, instant now)
{
    std::vector<character> all;
    while (auto const heard = wire.receive(now)) {
        all.push_back(*heard);
    }
    return all;
}

bool is_whole(std::vector<character> const& all)
{
    bool same = all.size() == frame.size();
    for (std::size_t i = 0; same and i < all.size(); ++i) {
        same = all[i].byte == frame[i] and not all[i].is_damaged;
    }
    return same;
}

/// How many of some frames arrive as they were sent.
unsigned whole_frames(line_faults const& faults, unsigned count)
{
    sim::line wire{19'200, character_format::even_8_1, 1};
    wire.set_faults(faults);
    instant now{0xFFFF'FF00U};
    unsigned whole = 0;
    for (unsigned i = 0; i < count; ++i) {
        wire.transmit(0, frame, now);
        now = now + milliseconds(200);
        whole += is_whole(heard_of(wire, now)) ? 1U : 0U;
    }
    return whole;
}

constexpr std::uint32_t always = 1'000'000;

unsigned whole_with(std::uint32_t line_faults::*fault, std::uint32_t chance, unsigned count)
{
    line_faults faults;
    faults.*fault = chance;
    return whole_frames(faults, count);
}

constexpr bool keeps_every_byte(character_format format)
{
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t const bits = detail::character_bits(format, to_byte(byte));
        auto const got = detail::receive_character(format, bits);
        if (got.byte != to_byte(byte) or got.is_damaged) {
            return false;
        }
    }
    return true;
}
constexpr bool keeps_every_byte_in_every_format()
{
    return keeps_every_byte(character_format::even_8_1) and keeps_every_byte(character_format::odd_8_1) and
           keeps_every_byte(character_format::none_8_1) and keeps_every_byte(character_format::none_8_2) and
           keeps_every_byte(character_format::even_8_2) and keeps_every_byte(character_format::odd_8_2);
}
PROOF("every byte survives its bits", keeps_every_byte_in_every_format)

constexpr bool sees_one_wrong_bit()
{
    std::uint32_t const bits = detail::character_bits(character_format::even_8_1, std::byte{0x5A});
    for (unsigned bit = 1; bit < 11; ++bit) {
        if (not detail::receive_character(character_format::even_8_1, bits ^ (1U << bit)).is_damaged) {
            return false;
        }
    }
    return true;
}
PROOF("parity and stop bit show any one wrong bit", sees_one_wrong_bit)

} // namespace

TEST_CASE("a frame arrives, each byte at the end of its stop bit")
{
    sim::line wire{19'200, character_format::even_8_1, 1};
    instant const start{0xFFFF'FFF0U};
    instant const end = wire.transmit(3, frame, start);
    CHECK((end - start).microseconds <= timing.characters(frame.size()).microseconds);
    CHECK_FALSE(wire.receive(start + microseconds(500)));
    CHECK(wire.poll_deadline() == start + microseconds(573));
    auto const all = heard_of(wire, end);
    CHECK(is_whole(all));
    CHECK(all.back().at == end);
    CHECK(all[0].is_from(3));
    CHECK_FALSE(all[0].is_from(2));
    CHECK_FALSE(wire.poll_deadline());
}

TEST_CASE("two talkers at once make one signal, and it is both of theirs")
{
    sim::line wire{19'200, character_format::even_8_1, 1};
    instant const start{0};
    wire.transmit(0, frame, start);
    instant const end = wire.transmit(1, ones, start + microseconds(300));
    auto const all = heard_of(wire, end + milliseconds(5));
    CHECK_FALSE(is_whole(all));
    CHECK(all[3].is_from(0));
    CHECK(all[3].is_from(1));
}

TEST_CASE("each fault does what it says")
{
    CHECK(whole_with(&line_faults::bit_errors, 0, 100) == 100);
    CHECK(whole_with(&line_faults::lost, always, 100) == 0);
    CHECK(whole_with(&line_faults::bursts, always, 100) == 0);
    CHECK(whole_with(&line_faults::dropped, always, 100) == 0);
    CHECK(whole_with(&line_faults::added, always, 100) == 0);
    CHECK(whole_with(&line_faults::repeated, always, 100) == 0);
    CHECK(whole_with(&line_faults::glitches, always, 100) == 0);
    CHECK(whole_with(&line_faults::foreign, always, 100) == 0);
    CHECK(whole_with(&line_faults::babble, always, 100) == 0);
    line_faults cut;
    cut.is_cut = true;
    CHECK(whole_frames(cut, 100) == 0);
    line_faults late;
    late.delayed = always;
    late.delay = milliseconds(50);
    CHECK(whole_frames(late, 100) == 100);
    unsigned const half = whole_with(&line_faults::lost, always / 2, 1'000);
    CHECK((half > 400 and half < 600));
    // 88 bits at one error in a hundred: 41 % of the frames stay whole.
    unsigned const noisy = whole_with(&line_faults::bit_errors, always / 100, 1'000);
    CHECK((noisy > 360 and noisy < 460));
}

TEST_CASE("another unit answers the same before the frame, and writes nothing")
{
    constexpr auto answer = "01 03 04 00 64 00 65 7B C7"_hex;
    constexpr auto written = "01 06 00 64 00 65 08 3E"_hex;
    line_faults faults;
    faults.foreign = always;
    sim::line wire{19'200, character_format::even_8_1, 1};
    wire.set_faults(faults);
    auto const heard_behind = [&wire](byte_view bytes, instant at) {
        wire.transmit(0, bytes, at);
        std::vector<std::byte> all;
        for (character const& each : heard_of(wire, at + milliseconds(100))) {
            CHECK_FALSE(each.is_damaged);
            all.push_back(each.byte);
        }
        return all;
    };
    for (std::uint32_t i = 0; i < 300; ++i) {
        auto const both = heard_behind(answer, instant{i * 200'000});
        REQUIRE(both.size() == 2 * answer.size());
        byte_view const foreign = byte_view{both}.first(answer.size());
        CHECK(check_frame(foreign) == errc::none);
        CHECK((foreign[0] != answer[0] and to_u8(foreign[0]) >= 1 and to_u8(foreign[0]) <= 247));
        CHECK((foreign[1] == answer[1] and foreign[2] == answer[2]));
        auto const refusal = heard_behind(written, instant{i * 200'000 + 100'000});
        REQUIRE(refusal.size() == 5 + written.size());
        CHECK((check_frame(byte_view{refusal}.first(5)) == errc::none and refusal[1] == std::byte{0x86}));
    }
}

TEST_CASE("in the place of a frame a babble is longer than any, and holds no function")
{
    line_faults faults;
    faults.babble = always;
    sim::line wire{19'200, character_format::even_8_1, 1};
    wire.set_faults(faults);
    wire.transmit(0, frame, instant{0});
    auto const all = heard_of(wire, instant{1'000'000});
    CHECK(all.size() == 300);
    for (character const& each : all) {
        CHECK(to_u8(each.byte) >= 0x80);
    }
}

TEST_CASE("the same seed makes the same faults")
{
    line_faults faults;
    faults.bit_errors = faults.added = 10'000;
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        sim::line one{19'200, character_format::even_8_1, seed};
        sim::line other{19'200, character_format::even_8_1, seed};
        one.set_faults(faults);
        other.set_faults(faults);
        one.transmit(0, frame, instant{0});
        other.transmit(0, frame, instant{0});
        auto const first = heard_of(one, instant{100'000});
        auto const second = heard_of(other, instant{100'000});
        REQUIRE(first.size() == second.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CHECK(first[i].byte == second[i].byte);
        }
    }
}

TEST_CASE("an adapter keeps bytes until its timer ends or its buffer is full")
{
    sim::usb_adapter adapter;
    instant now{0};
    adapter.take(std::byte{1}, now);
    CHECK(adapter.give(now + milliseconds(15)).empty());
    CHECK(adapter.give(now + milliseconds(16)).size() == 1);
    CHECK_FALSE(adapter.poll_deadline());
    for (unsigned i = 0; i < 62; ++i) {
        adapter.take(std::byte{2}, now);
    }
    CHECK(adapter.give(now).size() == 62);
}

TEST_CASE("an adapter's timer may run all the time: from the packet before on, and round and round")
{
    sim::usb_adapter adapter{milliseconds(16), sim::usb_timer::from_last_packet};
    auto const waits = [&](instant now) {
        adapter.take(std::byte{1}, now);
        duration const length = *adapter.poll_deadline() - now;
        CHECK(adapter.give(now + length - microseconds(1)).empty());
        CHECK(adapter.give(now + length).size() == 1);
        return length;
    };
    instant const first{0};
    CHECK(waits(first + milliseconds(10)) == milliseconds(6));
    CHECK(waits(first + milliseconds(16)) == milliseconds(16)); // it ended just now
    CHECK(waits(first + milliseconds(16 * 5 + 15)) == milliseconds(1));
    // A full packet does not wait for it, and sets it back.
    instant const full = first + milliseconds(16 * 10 + 5);
    for (unsigned i = 0; i < 62; ++i) {
        adapter.take(std::byte{2}, full);
    }
    CHECK(adapter.give(full).size() == 62);
    CHECK(waits(full + milliseconds(3)) == milliseconds(13));
}

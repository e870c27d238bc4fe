// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An interrupt and a loop, as two threads, share a ring of frames. The thread sanitizer finds a race here; every frame's
// bytes follow from its number, which is its time, so that one that is torn or comes twice is found, too.
#include <rtuwire/trace/trace_ring.hpp>

#include <thread>

#include "support/catch.hpp"
#include "support/told_number.hpp"

using namespace rtuwire;

namespace {

std::size_t size_at(std::uint32_t number) { return number * 2'654'435'761U % 257U; }
std::byte byte_at(std::uint32_t number, std::size_t place)
{
    return static_cast<std::byte>((number * 31U + static_cast<std::uint32_t>(place) * 7U) & 0xFFU);
}

bool is_whole(traced_frame const& frame)
{
    std::uint32_t const number = frame.at.microseconds;
    bool is_right = frame.bytes.size() == size_at(number) and frame.is_own == (number % 2 != 0);
    for (std::size_t i = 0; i < frame.bytes.size() and is_right; ++i) {
        is_right = frame.bytes[i] == byte_at(number, i);
    }
    return is_right;
}

TEST_CASE("an interrupt and a loop share a ring of frames")
{
    constexpr std::uint32_t all = 20'000;
    constexpr std::uint32_t ahead = 64; // frames that the ring does not hold: some are lost
    trace_ring<1024> ring;
    test::told_number written{0};
    test::told_number read{0};
    std::thread writer{[&] {
        std::array<std::byte, 256> bytes;
        for (std::uint32_t number = 1; number <= all; ++number) {
            for (std::uint32_t seen = read.get(); number - seen > ahead; seen = read.get()) {
                read.wait_behind(seen);
            }
            for (std::size_t i = 0; i < size_at(number); ++i) {
                bytes[i] = byte_at(number, i);
            }
            ring.take({byte_view{bytes.data(), size_at(number)}, instant{number}, frame_role::request,
                       frame_verdict::good, number % 2 != 0});
            written.tell(number);
        }
    }};
    std::array<std::byte, 256> place;
    std::uint32_t last = 0;
    std::uint32_t count = 0;
    std::uint32_t wrong = 0;
    auto const read_all = [&] {
        while (auto const frame = ring.poll_frame(place)) {
            wrong += is_whole(*frame) and frame->at.microseconds > last ? 0U : 1U;
            last = frame->at.microseconds;
            ++count;
        }
    };
    for (std::uint32_t known = 0; known != all;) {
        written.wait_behind(known);
        known = written.get();
        read_all();
        read.tell(known);
    }
    writer.join();
    read_all();
    CHECK(wrong == 0);
    CHECK(count > 0);
    CHECK(count + ring.lost() == all);
}

} // namespace

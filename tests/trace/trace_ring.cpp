// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What goes into a ring comes out of it, in order and unchanged, or is counted as lost.
#include <rtuwire/trace/trace_ring.hpp>

#include <deque>
#include <vector>

#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

STATIC_CHECK(frame_sink<trace_ring<64>>);

struct whole {
    std::vector<std::byte> bytes;
    traced_frame frame;
};

whole made(test::random& random, std::size_t size)
{
    whole one{std::vector<std::byte>(size), {.bytes = {}, .at = instant{0}}};
    random.fill(one.bytes);
    one.frame.at = instant{random.next()};
    one.frame.role = static_cast<frame_role>(random.below(3));
    one.frame.verdict = static_cast<frame_verdict>(random.below(6));
    one.frame.is_own = random.below(2) != 0;
    return one;
}

template <typename Ring> void give(Ring& ring, whole const& one)
{
    traced_frame frame = one.frame;
    frame.bytes = one.bytes;
    ring.take(frame);
}

bool is_same(traced_frame const& got, whole const& one)
{
    return same_bytes(got.bytes, one.bytes) and got.at == one.frame.at and got.role == one.frame.role and
           got.verdict == one.frame.verdict and got.is_own == one.frame.is_own;
}

constexpr bool keeps_one_in_a_constant()
{
    trace_ring<16> ring;
    std::array<std::byte, 10> const bytes{std::byte{1}, std::byte{2}};
    ring.take({bytes, instant{0xFEDC'BA98}, frame_role::response, frame_verdict::stray, true});
    std::array<std::byte, 256> place{};
    auto const frame = ring.poll_frame(place);
    return frame and same_bytes(frame->bytes, bytes) and frame->at == instant{0xFEDC'BA98} and
           frame->role == frame_role::response and frame->verdict == frame_verdict::stray and frame->is_own and
           ring.is_empty() and not ring.poll_frame(place) and ring.lost() == 0;
}
PROOF("a ring keeps a frame as large as itself", keeps_one_in_a_constant)

TEST_CASE("frames of every size pass a ring, wherever it wraps")
{
    trace_ring<512> ring;
    test::random random{1};
    std::array<std::byte, 256> place;
    for (std::size_t round = 0; round < 20; ++round) {
        for (std::size_t size = 0; size <= 256; ++size) {
            whole const one = made(random, size);
            give(ring, one);
            auto const got = ring.poll_frame(place);
            REQUIRE(got);
            REQUIRE(is_same(*got, one));
            REQUIRE(ring.is_empty());
        }
    }
    CHECK(ring.lost() == 0);
}

template <std::size_t Bytes> void agrees_with_a_list()
{
    trace_ring<Bytes> ring;
    test::random random{static_cast<std::uint32_t>(Bytes)};
    std::deque<whole> model;
    std::size_t used = 0;
    std::uint32_t lost = 0;
    std::array<std::byte, 256> place;
    for (unsigned i = 0; i < 20'000; ++i) {
        if (random.below(5) < 3) {
            whole const one = made(random, random.below(257));
            give(ring, one);
            if (used + one.bytes.size() + 6 <= Bytes) {
                used += one.bytes.size() + 6;
                model.push_back(one);
            } else {
                ++lost;
            }
        } else {
            auto const got = ring.poll_frame(place);
            REQUIRE(got.has_value() == not model.empty());
            if (got) {
                REQUIRE(is_same(*got, model.front()));
                used -= model.front().bytes.size() + 6;
                model.pop_front();
            }
        }
        REQUIRE(ring.lost() == lost);
        REQUIRE(ring.is_empty() == model.empty());
    }
    CHECK(lost > 0);
}

TEST_CASE("a full ring keeps what it has and counts what it drops")
{
    agrees_with_a_list<16>();
    agrees_with_a_list<256>();
    agrees_with_a_list<1024>();
    agrees_with_a_list<0x8000>();
    agrees_with_a_list<0x10000>();
}

TEST_CASE("more bytes than a frame has are kept as several records")
{
    trace_ring<2048> ring;
    test::random random{7};
    whole const one = made(random, 600);
    give(ring, one);
    std::vector<std::byte> all;
    std::array<std::byte, 256> place;
    for (std::size_t const size : {256U, 256U, 88U}) {
        auto const got = ring.poll_frame(place);
        REQUIRE(got);
        CHECK(got->bytes.size() == size);
        CHECK(got->at == one.frame.at);
        all.insert(all.end(), got->bytes.begin(), got->bytes.end());
    }
    CHECK(all == one.bytes);
    CHECK(ring.is_empty());
}

} // namespace

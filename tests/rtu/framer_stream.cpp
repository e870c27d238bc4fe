// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Chunking makes no difference: any split of a stream of glued frames yields the same frames.
#include <rtuwire/rtu/framer.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};

using byte_list = std::vector<std::byte>;

template <typename P> void append(byte_list& stream, P const& value)
{
    auto const frame = encode(unit_id{17}, value);
    REQUIRE(frame);
    stream.insert(stream.end(), frame->view().begin(), frame->view().end());
}

byte_list glued_frames(direction way, unsigned count)
{
    test::random random{42};
    byte_list stream;
    for (unsigned i = 0; i < count; ++i) {
        std::array<std::byte, 242> data{};
        random.fill(data);
        auto const address = static_cast<std::uint16_t>(random.next());
        register_view const values{byte_view{data}.first(2 + 2 * random.below(i % 16 == 0 ? 120 : 8))};
        auto const start = static_cast<std::uint16_t>(address / 2);
        bool const asks = way == direction::request;
        switch (random.below(5)) {
        case 0: append(stream, write_single_register{address, address}); break;
        case 1:
            if (asks) {
                append(stream, read_holding_registers{start, 4});
            } else {
                append(stream, read_holding_registers_response{values});
            }
            break;
        case 2:
            if (asks) {
                append(stream, write_multiple_registers{start, values});
            } else {
                append(stream, write_multiple_registers_response{start, 3});
            }
            break;
        case 3:
            if (asks) {
                append(stream, read_write_multiple_registers{start, 2, start, values});
            } else {
                append(stream, read_write_multiple_registers_response{values});
            }
            break;
        default:
            if (asks) {
                append(stream, read_holding_registers{start, 1});
            } else {
                append(stream, exception_response{function_code{3}, 2});
            }
        }
    }
    return stream;
}

/// A listener that remembers how many frames ended and a checksum over all of them.
template <direction Way> struct tally {
    framer<Way> receiver{line};
    unsigned frames{0};
    unsigned faults{0};
    running_crc16<> content{};

    tally()
    {
        receiver.advance(instant{0});
        receiver.advance(instant{1'000'000});
    }

    void hear(byte_view bytes)
    {
        while (not bytes.empty()) {
            bytes = bytes.subspan(receiver.receive(bytes, instant{1'000'000}));
            auto const frame = receiver.poll_frame();
            if (not frame) {
                continue;
            }
            if (not *frame) {
                ++faults;
                continue;
            }
            ++frames;
            for (std::byte const byte : (*frame)->pdu()) {
                content.add(byte);
            }
        }
    }

    friend bool operator==(tally const& left, tally const& right)
    {
        return left.frames == right.frames and left.faults == right.faults and
               left.content.value() == right.content.value();
    }
};

template <direction Way> void check_every_split()
{
    auto const stream = glued_frames(Way, 1'000);
    tally<Way> whole;
    whole.hear(stream);
    CHECK(whole.frames == 1'000);
    CHECK(whole.faults == 0);

    tally<Way> single;
    for (std::size_t i = 0; i < stream.size(); ++i) {
        single.hear(byte_view{stream}.subspan(i, 1));
    }
    CHECK(single == whole);

    unsigned different = 0;
    for (std::size_t i = 0; i <= stream.size(); ++i) {
        tally<Way> split;
        split.hear(byte_view{stream}.first(i));
        split.hear(byte_view{stream}.subspan(i));
        different += split == whole ? 0U : 1U;
    }
    CHECK(different == 0);

    test::random random{5};
    for (unsigned round = 0; round < 200; ++round) {
        tally<Way> chunked;
        for (std::size_t at = 0; at < stream.size();) {
            std::size_t const size = std::min<std::size_t>(1 + random.below(64), stream.size() - at);
            chunked.hear(byte_view{stream}.subspan(at, size));
            at += size;
        }
        CHECK(chunked == whole);
    }
}

} // namespace

TEST_CASE("any split of 1000 glued requests yields the same frames") { check_every_split<direction::request>(); }

TEST_CASE("any split of 1000 glued responses yields the same frames") { check_every_split<direction::response>(); }

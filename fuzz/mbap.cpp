// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes as those of a connection of Modbus TCP, in pieces of any size: the same messages are found as by a reading of all of
// them at once, which knows no pieces; what is written as a message is found as that.
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <rtuwire/port/mbap.hpp>
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using fuzz::require;

namespace {

using bytes = std::vector<std::byte>;
using messages = std::vector<std::pair<unsigned, bytes>>;

unsigned word(bytes const& from, std::size_t at)
{
    return std::to_integer<unsigned>(from[at]) * 256U + std::to_integer<unsigned>(from[at + 1]);
}

/// By the specification's fields, with all bytes at hand; what is none ends it.
messages all_at_once(bytes const& stream)
{
    messages found;
    for (std::size_t at = 0; stream.size() - at >= 6;) {
        std::size_t const length = word(stream, at + 4);
        if (word(stream, at + 2) != 0 or length < 2 or length > 254 or stream.size() - at - 6 < length) {
            break;
        }
        auto const first = stream.begin() + static_cast<std::ptrdiff_t>(at);
        found.emplace_back(word(stream, at), bytes(first + 6, first + 6 + static_cast<std::ptrdiff_t>(length)));
        at += 6 + length;
    }
    return found;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz::input all{data, size};
    std::size_t const pieces = all.u8();
    bytes stream;
    messages written;
    // Messages that are right, then whatever is left.
    for (unsigned count = all.u8() % 4U; count > 0; --count) {
        std::array<std::byte, max_mbap_size> place{};
        std::uint16_t const number = all.u16();
        byte_view const body = all.some(all.u8());
        auto const message = write_mbap(place, {number, body});
        require(message.has_value() == (body.size() >= 2 and body.size() <= 254));
        if (message) {
            stream.insert(stream.end(), message->begin(), message->end());
            written.emplace_back(number, bytes(body.begin(), body.end()));
            std::array<std::byte, max_adu_size> frame{};
            require(check_frame(rtu_frame_of({number, body}, frame)) == errc::none);
        }
    }
    byte_view const rest = all.some(size);
    stream.insert(stream.end(), rest.begin(), rest.end());

    mbap_cutter cutter;
    messages found;
    std::size_t at = 0;
    while (at < stream.size() and cutter.fault() == mbap_fault::none) {
        require(not cutter.room().empty());
        std::size_t const count = std::min({pieces + 1, cutter.room().size(), stream.size() - at});
        std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), count, cutter.room().begin());
        cutter.add(count);
        at += count;
        for (; auto const message = cutter.first(); cutter.drop_first()) {
            found.emplace_back(message->number, bytes(message->body.begin(), message->body.end()));
        }
    }
    require(found == all_at_once(stream));
    require(found.size() >= written.size() and std::equal(written.begin(), written.end(), found.begin()));
    return 0;
}

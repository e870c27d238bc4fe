// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Device identification both ways: any objects that a server holds come back whole page by page, and any
// pages leave the conversation that asks for them settled or asking.
#include <iterator>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

namespace {

constexpr literal texts[] = {"", "A", "Schneider Electric",
                             "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb"
                             "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb",
                             "cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"
                             "cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"
                             "cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"
                             "cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"
                             "cccc",
                             // One byte more than a page has room for.
                             "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd"
                             "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd"
                             "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd"
                             "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd"
                             "ddddd"};

/// Up to four objects, their numbers rising from the vendor's name on.
void pages_are_whole(fuzz::input in)
{
    std::array<std::byte, 1024> bytes{};
    byte_writer out{bytes};
    std::size_t count = 0;
    for (unsigned id = 0; count < 4 and not in.is_empty() and id < 256; ++count) {
        device_object{static_cast<std::uint8_t>(id), texts[in.u8() % std::size(texts)]}.write(out);
        id += 1U + in.u8() % 90U;
    }
    auto const made = device_objects::from(out.written());
    if (not made) {
        return;
    }
    device_objects const all = *made;
    std::uint8_t next = 0;
    std::size_t seen = 0;
    for (unsigned page = 0; count > 0 and page < 8; ++page) {
        std::array<std::byte, max_pdu_size> place{};
        read_device_identification const asked{identification_access::extended, next};
        byte_writer request{place};
        asked.write(request);
        pdu_buffer pdu{place, request.size()};
        require(write_identification(pdu, all) == errc::none);
        auto const read = device_identification::decode(pdu.view());
        require(read.has_value());
        for (auto at = read->first(); at; at = read->after(*at)) {
            ++seen;
        }
        if (not read->more_follows) {
            break;
        }
        require(read->next_object > next or page == 0);
        next = read->next_object;
    }
    require(seen <= 2 * count);
}

/// Bytes that pass for objects are served.
void any_bytes_are_checked(fuzz::input in)
{
    auto const objects = device_objects::from(in.some(400));
    if (not objects) {
        return;
    }
    std::array<std::byte, max_pdu_size> place{};
    byte_writer request{place};
    read_device_identification{identification_access::extended, 0}.write(request);
    pdu_buffer pdu{place, request.size()};
    require(write_identification(pdu, *objects) == errc::none);
    require(device_identification::decode(pdu.view()).has_value());
}

void any_pages_end(fuzz::input in)
{
    altivar::identify<altivar::atv320::device> conversation{station<altivar::atv320::device>{unit_id{1}}};
    for (unsigned page = 0; page < 300 and not conversation.settled() and not in.is_empty(); ++page) {
        require(conversation.next().has_value());
        byte_view const pdu = in.some(in.u8());
        if (pdu.size() < 2 or not device_identification::decode(pdu)) {
            conversation.accept(errc::malformed);
        } else {
            conversation.accept(result<response>{response{pdu}});
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    pages_are_whole({data, size});
    any_pages_end({data, size});
    any_bytes_are_checked({data, size});
    return 0;
}

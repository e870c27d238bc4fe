// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client whose responses the firmware cuts by silence.
#pragma once

#include "requests.hpp"

/// Bytes until the line is silent, or the response is late.
[[gnu::noinline]] inline rtuwire::byte_view listen(rtuwire::byte_span place)
{
    std::size_t size = 0;
    rtuwire::instant end = board::now() + rtuwire::milliseconds(1'000);
    while (not rtuwire::reached(board::now(), end)) {
        if (board::has_byte()) {
            std::byte const byte = board::byte();
            end = board::now() + rtuwire::microseconds(2'000);
            if (size < place.size()) {
                place[size++] = byte;
            }
        }
    }
    return place.first(size);
}

/// The PDU that answers a request; empty when none does.
[[gnu::noinline]] inline rtuwire::byte_view response_to(rtuwire::byte_view request, rtuwire::byte_span place)
{
    using namespace rtuwire;
    board::put(request);
    auto const response = decode_adu(listen(place));
    return response and check_response(request, *response) == errc::none ? response->pdu() : byte_view{};
}

/// Asks request after request; `request_of` gives the frame of a number.
template <typename QuestionOf> [[noreturn]] void ask_on(QuestionOf request_of)
{
    std::array<std::byte, rtuwire::max_adu_size> heard;
    for (unsigned number = 0;; number = next(number)) {
        auto const pdu = response_to(request_of(number), heard);
        if (not pdu.empty()) {
            board::put(static_cast<std::byte>(value_in(pdu, number)));
        }
    }
}

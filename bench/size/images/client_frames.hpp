// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client whose answers the firmware cuts by silence.
#pragma once

#include "questions.hpp"

/// Octets until the line is silent, or the answer is late.
[[gnu::noinline]] inline rtuwire::byte_view listen(rtuwire::byte_span place)
{
    std::size_t size = 0;
    rtuwire::instant end = board::now() + rtuwire::milliseconds(1'000);
    while (not rtuwire::reached(board::now(), end)) {
        if (board::has_octet()) {
            std::byte const octet = board::octet();
            end = board::now() + rtuwire::microseconds(2'000);
            if (size < place.size()) {
                place[size++] = octet;
            }
        }
    }
    return place.first(size);
}

/// Asks question after question; `question_of` gives the frame of a number.
template <typename QuestionOf> [[noreturn]] void ask_on(QuestionOf question_of)
{
    using namespace rtuwire;
    std::array<std::byte, max_adu_size> heard;
    for (unsigned number = 0;; number = next(number)) {
        byte_view const frame = question_of(number);
        board::put(frame);
        auto const answer = decode_adu(listen(heard));
        if (answer and check_answer(frame, *answer) == errc::none) {
            board::put(static_cast<std::byte>(value_in(answer->pdu, number)));
        }
    }
}

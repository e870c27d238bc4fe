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

/// The PDU that answers a question; empty when none does.
[[gnu::noinline]] inline rtuwire::byte_view answer_to(rtuwire::byte_view question,
                                                      rtuwire::byte_span place)
{
    using namespace rtuwire;
    board::put(question);
    auto const answer = decode_adu(listen(place));
    return answer and check_answer(question, *answer) == errc::none ? answer->pdu() : byte_view{};
}

/// Asks question after question; `question_of` gives the frame of a number.
template <typename QuestionOf> [[noreturn]] void ask_on(QuestionOf question_of)
{
    std::array<std::byte, rtuwire::max_adu_size> heard;
    for (unsigned number = 0;; number = next(number)) {
        auto const pdu = answer_to(question_of(number), heard);
        if (not pdu.empty()) {
            board::put(static_cast<std::byte>(value_in(pdu, number)));
        }
    }
}

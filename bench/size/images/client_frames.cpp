// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions 03, 06, 16, 23 and 43/14, asked with constant frames by firmware that cuts the answers by silence.
#include "questions.hpp"

using namespace rtuwire;

namespace {

/// Octets until the line is silent, or the answer is late.
[[gnu::noinline]] byte_view listen(byte_span place)
{
    std::size_t size = 0;
    instant end = board::now() + milliseconds(1'000);
    while (not reached(board::now(), end)) {
        if (board::has_octet()) {
            std::byte const octet = board::octet();
            end = board::now() + microseconds(2'000);
            if (size < place.size()) {
                place[size++] = octet;
            }
        }
    }
    return place.first(size);
}

} // namespace

int main()
{
    std::array<std::byte, max_adu_size> heard;
    for (unsigned number = 0;; number = next(number)) {
        byte_view const frame = known::questions[number];
        board::put(frame);
        auto const answer = decode_adu(listen(heard));
        if (answer and check_answer(frame, *answer) == errc::none) {
            board::put(static_cast<std::byte>(value_in(answer->pdu, number)));
        }
    }
}

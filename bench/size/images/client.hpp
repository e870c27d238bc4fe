// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with its framer, its times and every fault that it handles.
#pragma once

#include "questions.hpp"

#include <rtuwire/client/client.hpp>

template <typename Client>
[[gnu::noinline]] rtuwire::result<rtuwire::response> outcome_of(Client& link,
                                                                rtuwire::byte_view frame)
{
    static_cast<void>(link.start(rtuwire::request{frame}, board::now()));
    while (true) {
        board::pass(link);
        if (auto const outcome = link.poll_outcome()) {
            return *outcome;
        }
    }
}

template <typename Client> void ask_on(Client& link)
{
    for (unsigned number = 0;; number = next(number)) {
        auto const outcome = outcome_of(link, known::questions[number]);
        if (outcome) {
            board::put(static_cast<std::byte>(value_in(outcome->pdu(), number)));
        }
    }
}

inline constexpr rtuwire::line_timing timing{19'200, rtuwire::character_format::even_8_1};

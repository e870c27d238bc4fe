// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with its framer, its times and every fault that it handles.
#pragma once

#include "questions.hpp"

#include <rtuwire/client/client.hpp>

/// Asks question after question; apart from `main`, as if in a file of its own.
template <typename Client> [[noreturn, gnu::noipa]] void ask_on(Client& link)
{
    for (unsigned number = 0;;) {
        board::pass(link);
        if (auto const outcome = link.poll_outcome()) {
            if (*outcome) {
                board::put(static_cast<std::byte>(value_in((*outcome)->pdu(), number)));
            }
            number = next(number);
        }
        if (not link.is_busy()) {
            static_cast<void>(link.start(rtuwire::request{known::questions[number]}, board::now()));
        }
    }
}

inline constexpr rtuwire::line_timing timing{19'200, rtuwire::character_format::even_8_1};

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with its framer, its times and every fault that it handles.
#pragma once

#include "questions.hpp"

#include <rtuwire/client/client.hpp>

/// The five questions, one after the other without end.
class five_questions : public rtuwire::asker {
public:
    std::optional<rtuwire::request> next() const
    {
        return rtuwire::request{known::questions[number_]};
    }
    void accept(rtuwire::result<rtuwire::response> const& outcome)
    {
        if (outcome) {
            board::put(static_cast<std::byte>(value_in(outcome->pdu(), number_)));
        }
        number_ = ::next(number_);
    }
    static bool settled() { return false; }

private:
    unsigned number_{0};
};

/// Asks question after question; apart from `main`, as if in a file of its own.
template <typename Client> [[noreturn, gnu::noipa]] void ask_on(Client& link)
{
    for (five_questions talk;;) {
        board::pass(link);
        link.converse(talk, board::now());
    }
}

inline constexpr rtuwire::line_timing timing{19'200, rtuwire::character_format::even_8_1};

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with its framer, its times and every fault that it handles.
#pragma once

#include "requests.hpp"

#include <rtuwire/client/client.hpp>

/// The five requests, one after the other without end.
class five_requests : public rtuwire::asker {
public:
    std::optional<rtuwire::request_frame> next() const { return rtuwire::request_frame{known::requests[number_]}; }
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

/// Asks request after request; apart from `main`, as if in a file of its own.
template <typename Client> [[noreturn, gnu::noipa]] void ask_on(Client& link)
{
    for (five_requests conversation;;) {
        board::pass(link);
        link.converse(conversation, board::now());
    }
}

inline constexpr rtuwire::line_timing timing{19'200, rtuwire::character_format::even_8_1};

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with one typed read.
#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::device> drive{unit_id{1}};

} // namespace

int main()
{
    client link{line_timing{19'200, character_format::even_8_1}};
    for (;;) {
        auto conversation = read<atv320::lcr>(drive);
        while (not conversation.settled()) {
            board::pass(link);
            link.converse(conversation, board::now());
        }
        if (auto const current = conversation.outcome()) {
            board::put(static_cast<std::byte>(current->count()));
        }
    }
}

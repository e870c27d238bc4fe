// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with one typed read.
#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client/access.hpp>
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
        auto talk = read<atv320::lcr>(drive);
        while (not talk.settled()) {
            board::pass(link);
            link.converse(talk, board::now());
        }
        if (auto const current = talk.outcome()) {
            board::put(static_cast<std::byte>(current->count()));
        }
    }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a choice of channels writes, and in which order: where command and reference come from before what says how they
// go together, and the input that takes them away last.
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using settings = channel_settings<atv320::device>;

constexpr bool writes_in_order()
{
    settings const all = settings{}
                             .with<atv320::flo>(count16{131})
                             .with<atv320::chcf>(atv320::channel_mode::sep)
                             .with<atv320::cd1>(atv320::command_channel::ter)
                             .with<atv320::fr1>(atv320::reference_channel::mdb);
    constexpr std::array<std::array<unsigned, 2>, 4> expected{{{8'413, 164}, {8'423, 1}, {8'401, 2}, {8'431, 131}}};
    bool ok = true;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ok = ok and all.words()[i].address == expected[i][0] and all.words()[i].word == expected[i][1];
    }
    return ok;
}
PROOF("channels are written in one order, in whichever they are named", writes_in_order)

constexpr bool leaves_the_others()
{
    settings const one = settings{}.with<atv320::fr1>(atv320::reference_channel::mdb);
    unsigned named = 0;
    bool is_there = false;
    for (channel_word const& each : one.words()) {
        named += each.address != 0 ? 1U : 0U;
        is_there = is_there or (each.address == 8'413 and each.word == 164);
    }
    return is_there and named == 1;
}
PROOF("a channel that is not named stays as it is", leaves_the_others)

} // namespace

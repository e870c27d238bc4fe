// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A whole drive's table, fifty typed reads with their values, and a plan of fifty registers.
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

void ask(byte_view frame);
void show(std::uint16_t word);

template <auto const&... Registers> void read_each(station<atv320::device> const& drive)
{
    auto const one = [](auto conversation) {
        ask(conversation.next()->frame());
        if (auto const value = conversation.outcome()) {
            show(to_word(*value));
        }
    };
    (one(read<Registers>(drive)), ...);
}

template <auto const&... Registers> struct list {
    using plan = read_plan<atv320::device, Registers...>;
    static void read(station<atv320::device> const& drive) { read_each<Registers...>(drive); }
};

using fifty =
    list<atv320::ncv, atv320::vcal, atv320::inv, atv320::sfr, atv320::tfr, atv320::hsp, atv320::lsp, atv320::eta,
         atv320::rfr, atv320::frh, atv320::lcr, atv320::otr, atv320::eti, atv320::uln, atv320::uop, atv320::thd,
         atv320::opr, atv320::rth, atv320::pth, atv320::hmis, atv320::vdp, atv320::add, atv320::tbr, atv320::tfo,
         atv320::tto, atv320::sll, atv320::lft, atv320::cic, atv320::dp0, atv320::dp1, atv320::dp2, atv320::dp3,
         atv320::dp4, atv320::dp5, atv320::dp6, atv320::dp7, atv320::dp8, atv320::chcf, atv320::fr1, atv320::fr2,
         atv320::cd1, atv320::cd2, atv320::flo, atv320::cmd, atv320::lfr, atv320::pisp, atv320::cmi, atv320::lfrd,
         atv320::etad, atv320::rfrd>;

void read_all(station<atv320::device> const& drive) { fifty::read(drive); }

void poll(poller<fifty::plan>& panel) { ask(panel.next()->frame()); }

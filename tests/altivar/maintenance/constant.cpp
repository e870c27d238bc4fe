// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Both conversations run in a constant expression: without a heap, and with nothing undefined.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include "altivar/maintenance/small_map.hpp"
#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/maintenance/backup.hpp>
#include <rtuwire/client/needs.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

constexpr station<atv320::device> unit{unit_id{7}};

/// A drive that refuses one block, and is silent then: each parameter is told once.
constexpr bool backup_tells_all()
{
    std::size_t told = 0;
    backup conversation{unit, small_map,
                        [&](parameter_group const&, parameter const&, result<std::uint16_t> const&) { ++told; }};
    conversation.accept(errc::illegal_data_address);
    while (conversation.next()) {
        conversation.accept(errc::timed_out);
    }
    return told == small_map.size() and conversation.settled();
}

template <typename Report> constexpr auto restore_of_ones(Report report)
{
    auto const one = [](parameter const&) -> std::optional<std::uint16_t> { return std::uint16_t{1}; };
    return restore{unit, small_map, wanted_settings{drive_family::of("ATV320"), one}, report, restore_options{}};
}

/// A drive that is silent from the beginning: each parameter is left out, or not reached.
constexpr bool restore_tells_all()
{
    std::size_t told = 0;
    auto conversation =
        restore_of_ones([&](parameter_group const&, parameter const&, restore_report const&) { ++told; });
    conversation.advance(instant{0});
    while (conversation.next()) {
        conversation.accept(errc::timed_out);
    }
    return told == small_map.size() and conversation.reason().kind == outcome_kind::silent;
}

constexpr auto ignored = [](parameter_group const&, parameter const&, restore_report const&) {};

} // namespace

/// A client without one of its functions is refused, and does not take it for a silent drive.
static_assert(not rtuwire::detail::has_what_it_asks<function_list<read_holding_registers, write_single_register>,
                                                    decltype(restore_of_ones(ignored))>());

PROOF("a backup tells each parameter once, evaluated by the compiler", backup_tells_all)
PROOF("a restore tells each parameter once, evaluated by the compiler", restore_tells_all)

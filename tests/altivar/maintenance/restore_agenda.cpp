// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The order of the writes: no order of limits is ever broken, and every parameter that is restored has a step.
#include <rtuwire/altivar/maintenance/restore_agenda.hpp>

#include <array>

#include "altivar/maintenance/small_map.hpp"
#include "support/catch.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

/// LSP, HSP and TFR of a drive.
using limits = std::array<int, 3>;

constexpr bool is_ordered(limits const& all) { return all[0] <= all[1] and all[1] <= all[2]; }

/// Goes through the agenda's steps over the limits: whether they stand in order after each write, and end as wanted.
constexpr bool keeps_order(limits held, limits const& wanted)
{
    for (agenda_step const& step : restore_agenda) {
        if (step.role != parameter_role::frequency_limit) {
            continue;
        }
        std::size_t const which = step.code == literal{"LSP"} ? 0 : step.code == literal{"HSP"} ? 1 : 2;
        if (step.moves(held[which], wanted[which])) {
            held[which] = wanted[which];
        }
        if (not is_ordered(held)) {
            return false;
        }
    }
    return held == wanted;
}

constexpr bool all_orders_are_kept()
{
    constexpr int most = 4;
    for (int from = 0; from < most * most * most; ++from) {
        for (int to = 0; to < most * most * most; ++to) {
            limits const held{from % most, from / most % most, from / (most * most)};
            limits const wanted{to % most, to / most % most, to / (most * most)};
            if (is_ordered(held) and is_ordered(wanted) and not keeps_order(held, wanted)) {
                return false;
            }
        }
    }
    return true;
}

/// Every parameter that may be restored is written by one step, or by two of different directions.
constexpr bool each_has_its_step(parameter_map const& map)
{
    bool has = true;
    map.for_each([&](parameter const& row, parameter_group const&) {
        unsigned writes = 0;
        unsigned raises = 0;
        unsigned lowers = 0;
        for (agenda_step const& step : restore_agenda) {
            bool const is_its = step.writes() and covers_row(step, row, restore_outcome::planned);
            writes += is_its and step.act == agenda_act::write ? 1U : 0U;
            raises += is_its and step.act == agenda_act::raise ? 1U : 0U;
            lowers += is_its and step.act == agenda_act::lower ? 1U : 0U;
        }
        bool const is_single = writes == 1 and raises == 0 and lowers == 0;
        bool const is_limit = writes == 0 and raises == 1 and lowers == 1;
        has = has and (is_restorable(role_of(row)) ? is_single or is_limit : writes + raises + lowers == 0);
    });
    return has;
}

/// A section ends at a step that says where it begins, which is not behind it; none overlaps another.
constexpr bool sections_are_apart()
{
    std::uint8_t end_of_last = 0;
    for (std::uint8_t i = 0; i < agenda_size; ++i) {
        std::uint8_t const from = restore_agenda[i].repeats_from;
        if (from != agenda_step::once) {
            if (from > i or from <= end_of_last) {
                return false;
            }
            end_of_last = i;
        }
    }
    return true;
}

} // namespace

PROOF("limits are never out of order between two writes", all_orders_are_kept)
PROOF("sections of the agenda do not overlap", sections_are_apart)

TEST_CASE("each parameter that may be restored has its step") { CHECK(each_has_its_step(small_map)); }

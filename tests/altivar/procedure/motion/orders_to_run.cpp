// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which conversations order a drive to run, in the place of any order before (docs/engine-rules.md, rule 36): a start
// does, and nothing that only changes, resets or sets something.
#include <rtuwire/altivar/procedure/motion/order_procedure.hpp>

#include <optional>

#include "support/commissioned.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/client/orders.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv28::device> drive{unit_id{7}};

/// What an order to run is told once another conversation with its drive began, which may command it.
template <typename Conversation> constexpr std::optional<errc> told_behind(Conversation later)
{
    constexpr instant now{0xFFFF'FF00U};
    orders<2> motors;
    auto const comes_by = [&](auto& conversation) {
        conversation.advance(now);
        motors.take_note_of(conversation, now);
        return motors.check(conversation, effect::enabling);
    };
    start first{drive, 50_Hz};
    bool const are_good = comes_by(first) == errc::none and comes_by(later) == errc::none;
    return are_good ? std::optional{comes_by(first)} : std::nullopt;
}

constexpr bool the_later_start_counts()
{
    return told_behind(start{drive, 30_Hz}) == errc::overruled and
           told_behind(atv28::direct_start{drive, 30_Hz}) == errc::overruled;
}
PROOF("of two starts of a drive the later one counts", the_later_start_counts)

template <typename... Conversations> constexpr bool none_replaces_a_start(Conversations const&... later)
{
    return ((told_behind(later) == errc::none) and ...);
}
constexpr bool nothing_else_counts_as_a_start()
{
    return none_replaces_a_start(change_reference{drive, 30_Hz}, reset_fault{drive}, save_to_eeprom{drive},
                                 recall_from_eeprom{drive},
                                 restore_factory_settings{drive, losing_control_and_address{}},
                                 atv28::release_link{drive}, atv28::activate_link{drive});
}
PROOF("who changes the reference, resets a fault or sets something takes no start's place",
      nothing_else_counts_as_a_start)

} // namespace

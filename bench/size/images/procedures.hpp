// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One client with constant times, and the first of six procedures for one drive: as many as `PROCEDURES` says.
#pragma once

#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::device> drive{unit_id{1}};
constexpr line_timing timing{19'200, character_format::even_8_1};
constinit static_drive_client<timing> link;

template <typename... Procedure> [[noreturn]] void run(Procedure&&... procedure)
{
    for (;;) {
        board::pass(link);
        auto const now = board::now();
        (link.converse(procedure, now), ...);
        (board::put(static_cast<std::byte>(procedure.succeeded())), ...);
    }
}

} // namespace

int main()
{
    run(altivar::start{drive, 50_Hz}
#if PROCEDURES > 1
        ,
        altivar::stop{drive}
#endif
#if PROCEDURES > 2
        ,
        change_reference{drive, 40_Hz}, reset_fault{drive}
#endif
#if PROCEDURES > 4
        ,
        save_to_eeprom{drive}, restore_factory_settings{drive, losing_control_and_address{}}
#endif
    );
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One command to every drive of a kind on the line at once. Nobody answers a broadcast: whether it was obeyed, only
// reading each drive tells. altivar/stop_everyone.hpp does that, too.
#pragma once

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/client/single_question.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Takes the power from every motor whose drive has its control word where `Device` has it: one broadcast of "disable
/// voltage". The motors coast. A line with ATV28 and later drives needs one of each.
template <device_type Device> [[nodiscard]] constexpr auto broadcast_freewheel() noexcept
{
    return single_question{
        broadcast, write_single_register{Device::profile.cmd,
                                         cia402::word_of(cia402::command::disable_voltage)}};
}

} // namespace rtuwire::altivar

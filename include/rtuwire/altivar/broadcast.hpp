// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One command to every drive of a kind on the line at once. Nobody answers a broadcast: whether it was
// obeyed, only reading each drive tells.
#pragma once

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/client/single_question.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Stops every drive whose control word stands where that of `Device` does: by "disable voltage" unless
/// a quick stop is asked for. A line with ATV28 and later drives needs one of each.
template <device_type Device>
[[nodiscard]] constexpr auto
stop_everyone(cia402::command how = cia402::command::disable_voltage) noexcept
{
    bool const is_quick = how == cia402::command::quick_stop;
    return single_question{
        broadcast,
        write_single_register{Device::profile.cmd,
                              cia402::word_of(is_quick ? how : cia402::command::disable_voltage)}};
}

} // namespace rtuwire::altivar

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One setting for every drive on the line at once. Nobody answers: whether a drive took it, only reading it tells. A
// drive of another type takes it, too, if it has a register at the address.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/restore_factory_settings.hpp>
#include <rtuwire/client/access.hpp>
#include <rtuwire/client/single_question.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Registers that are no settings for all: commands and references, and what their scanner words stand for; who
/// commands; the address, rate and format by which a drive is reached.
inline constexpr text not_for_everyone[]{"CMD",  "CMDD", "LFR", "LFRD", "PISP", "RPI", "CMI",
                                         "CHCF", "CD1",  "CD2", "FR1",  "FR2",  "FLO", "TCC",
                                         "LI3",  "LI4",  "ADD", "TBR",  "TFO",  "BDR"};

/// Whether a register may be written to all drives at once.
template <auto const& R> [[nodiscard]] consteval bool is_for_everyone() noexcept
{
    constexpr std::uint16_t scanner = 127; // NMA, NCA, NM and NC
    bool is_named = R.address / 100 == scanner;
    for (text const each : not_for_everyone) {
        is_named = is_named or each == R.code;
    }
    return not is_named;
}

/// Writes one setting to every drive that listens: `broadcast_setting<atv12::device, atv12::acc>(1.3_s)`. Motors that
/// run follow a ramp, a speed limit or a low speed at once; configuration is refused by those that run.
template <device_type Device, auto const& R>
[[nodiscard]] constexpr auto broadcast_setting(setting<R> value) noexcept
{
    static_assert(is_writable<R, Device>());
    static_assert(is_for_everyone<R>(),
                  "a command, a channel or an address is not written to all drives at once");
    static_assert(has_own_steps<R>,
                  "another register sets this register's steps: name them with restepped");
    static_assert(implements<Device>(function_code::write_single_register),
                  "this device does not implement function 06");
    return single_question{broadcast, write_single_register{R.address, value.word()}};
}

/// Writes the whole of CMI to every drive: bits that are not named are cleared, an ATV28's NTO with them. A word with
/// an order, to save for example, does not compile without `losing_control_and_address`.
template <device_type Device, std::uint16_t Word>
[[nodiscard]] constexpr auto broadcast_extended_command() noexcept
{
    static_assert((Word & Device::profile.cmi_orders) == 0,
                  "this word orders factory settings, a save or a recall: say "
                  "losing_control_and_address");
    return single_question{broadcast, write_single_register{Device::profile.cmi, Word}};
}

/// The same with orders. **Whoever orders this knows that every drive on the line stands**, and that no run input is
/// closed: nobody is asked, and nobody says what it did. Drives that run do not execute it. The order stays in CMI of
/// all but an ATV28: write it once more without, after 100 ms (2 s on an ATV28), or the memory wears out.
template <device_type Device, std::uint16_t Word>
[[nodiscard]] constexpr auto broadcast_extended_command(losing_control_and_address) noexcept
{
    return single_question{broadcast, write_single_register{Device::profile.cmi, Word}};
}

} // namespace rtuwire::altivar

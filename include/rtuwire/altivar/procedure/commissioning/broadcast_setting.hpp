// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One setting for every drive on the line at once. A broadcast gets no response: only a read shows whether a drive
// accepted it. A drive of another type accepts it, too, if it has a register at the address.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Registers that must not be set in all drives: commands and references, and what their scanner words stand for; the
/// command source; the address, rate and format of the link.
/// Internal.
inline constexpr literal not_for_everyone[]{"CMD", "CMDD", "LFR", "LFRD", "PISP", "RPI", "CMI", "CHCF", "CD1", "CD2",
                                            "FR1", "FR2",  "FLO", "TCC",  "LI3",  "LI4", "ADD", "TBR",  "TFO", "BDR"};

/// Whether a register may be written to all drives at once.
/// Internal.
template <device_type Device, auto const& R> [[nodiscard]] consteval bool is_for_everyone() noexcept
{
    constexpr drive_layout const& layout = drive_check<Device>::layout;
    bool is_named = Device::scanner.has(R.address) or R.address == layout.cmd or R.address == layout.cmi;
    for (literal const each : not_for_everyone) {
        is_named = is_named or each == R.code;
    }
    return not is_named;
}

/// Writes one setting to every drive that receives it: `broadcast_setting<atv12::device, atv12::acc>(1.3_s)`. Running
/// motors follow a ramp, a speed limit or a low speed at once; drives that run refuse configuration.
template <device_type Device, auto const& R> [[nodiscard]] constexpr auto broadcast_setting(setting<R> value) noexcept
{
    static_assert(detail::is_writable<R, Device>());
    static_assert(is_for_everyone<Device, R>(),
                  "a command, a channel or an address is not written to all drives at once");
    static_assert(detail::has_own_steps<R>, "another register sets this register's steps: name them with restepped");
    static_assert(detail::implements<Device>(function_code::write_single_register),
                  "this device does not implement function 06");
    return single_request{broadcast, write_single_register{R.address, value.word()}};
}

/// Writes the whole of CMI to every drive: bits that are not named are cleared, an ATV28's NTO with them. A word with
/// an order, to save for example, does not compile without `losing_control_and_address`.
template <device_type Device, std::uint16_t Word> [[nodiscard]] constexpr auto broadcast_extended_command() noexcept
{
    static_assert((Word & drive_check<Device>::layout.cmi_orders) == 0,
                  "this word orders factory settings, a save or a recall: say "
                  "losing_control_and_address");
    return single_request{broadcast, write_single_register{drive_check<Device>::layout.cmi, Word}};
}

/// The same with orders. **The caller must know that every drive on the line stands**, and that no run input is closed:
/// nothing is checked before, and no drive reports the result. Drives that run do not execute it. The order stays in
/// CMI of all but an ATV28: write CMI again without it, after 100 ms (2 s on an ATV28), or the memory wears out.
template <device_type Device, std::uint16_t Word>
[[nodiscard]] constexpr auto broadcast_extended_command(losing_control_and_address) noexcept
{
    return single_request{broadcast, write_single_register{drive_check<Device>::layout.cmi, Word}};
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

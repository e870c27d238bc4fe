// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One command to every drive of a kind on the line at once. A broadcast gets no response: only reading each drive
// shows whether it was obeyed. altivar/procedure/motion/broadcast_stop.hpp does that, too.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The conversation of that broadcast.
/// Internal.
class freewheel_request : public single_request<write_single_register> {
public:
    static constexpr bool frees_all = true; ///< for the client: no order that was given before counts

    explicit constexpr freewheel_request(std::uint16_t address) noexcept
        : single_request{broadcast, write_single_register{address, cia402::word_of(cia402::command::disable_voltage)}}
    {}
};

/// Removes the power from every motor whose drive has its control word where `Device` has it: one broadcast of "disable
/// voltage". The motors coast. A line with ATV28 and later drives needs one of each. From the request on no order that
/// this client gave before counts, of any unit: `running()` of a start is false. Whether a drive heard it nobody knows: one
/// that was ordered to run gets no request, behind three responses to others than its commanders, until its own time-out has
/// stopped it, unless a `stop` has shown that it stands.
template <device_type Device> [[nodiscard]] constexpr auto broadcast_freewheel() noexcept
{
    return freewheel_request{drive_check<Device>::layout.cmd};
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers and facts without which a drive cannot be simulated. What a drive lacks is said in a sentence each;
// all other registers may be there or not.
// Internal: may change with any version.
#pragma once

#include <concepts>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Whether the table of a device has a register of this mnemonic.
template <device_type Device> [[nodiscard]] constexpr bool has_called(literal code) noexcept
{
    return image<Device>::at(code) != image<Device>::nowhere;
}

/// What each of them is about. A device that is no drive is refused for that alone, see `drive_check`.
template <typename Device>
concept turns = not altivar::drive_type<Device> or has_called<Device>("HSP");
template <typename Device>
concept accelerates = not altivar::drive_type<Device> or has_called<Device>("ACC");
template <typename Device>
concept slows_down = not altivar::drive_type<Device> or has_called<Device>("DEC");
template <typename Device>
concept has_an_address = not altivar::drive_type<Device> or has_called<Device>("ADD");
template <typename Device>
concept knows_its_speed = not altivar::drive_type<Device> or has_called<Device>("NSP") or has_called<Device>("SDS");
template <typename Device>
concept names_itself =
    not altivar::drive_type<Device> or not implements<Device>(function_code::encapsulated_interface) or
    std::convertible_to<decltype(Device::reference), literal>;

/// Stops the compiler at a drive that cannot be simulated.
template <typename Device> struct drive_needs {
    static_assert(turns<Device>, "a simulated drive needs the register HSP, its highest frequency");
    static_assert(accelerates<Device>, "a simulated drive needs the register ACC, its acceleration ramp");
    static_assert(slows_down<Device>, "a simulated drive needs the register DEC, its deceleration ramp");
    static_assert(has_an_address<Device>, "a simulated drive needs the register ADD, its unit address");
    static_assert(knows_its_speed<Device>, "a simulated drive needs the register NSP, the motor's rated speed, or SDS, "
                                           "its revolutions a minute for one hertz");
    static_assert(names_itself<Device>, "a simulated drive with function 43 has an order code: `static constexpr "
                                        "literal reference`");

    static constexpr bool met = true;
};

} // namespace rtuwire::sim

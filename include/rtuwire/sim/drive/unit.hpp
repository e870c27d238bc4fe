// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated drive at an address of a line: the drive, its server and its identification.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/sim/drive/drive.hpp>
#include <rtuwire/sim/drive/image.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

// The registers and facts without which a drive cannot be simulated. What a drive lacks is said in a sentence each; all
// other registers may be there or not.

/// Whether a drive has no register of this mnemonic. What is no drive is refused for that alone, see `drive_check`.
template <typename Device> [[nodiscard]] constexpr bool lacks([[maybe_unused]] literal code) noexcept
{
    if constexpr (altivar::drive_type<Device>) {
        return image<Device>::at(code) == image<Device>::nowhere;
    } else {
        return false;
    }
}

template <typename Device>
concept names_itself =
    not altivar::drive_type<Device> or not implements<Device>(function_code::encapsulated_interface) or
    std::convertible_to<decltype(Device::reference), literal>;

/// Stops the compiler at a drive that cannot be simulated.
template <typename Device> struct drive_needs {
    static_assert(not lacks<Device>("HSP"), "a simulated drive needs the register HSP, its highest frequency");
    static_assert(not lacks<Device>("ACC"), "a simulated drive needs the register ACC, its acceleration ramp");
    static_assert(not lacks<Device>("DEC"), "a simulated drive needs the register DEC, its deceleration ramp");
    static_assert(not lacks<Device>("ADD"), "a simulated drive needs the register ADD, its unit address");
    static_assert(not lacks<Device>("NSP") or not lacks<Device>("SDS"),
                  "a simulated drive needs the register NSP, the motor's rated speed, or SDS, its revolutions a minute "
                  "for one hertz");
    static_assert(names_itself<Device>, "a simulated drive with function 43 has an order code: `static constexpr "
                                        "literal reference`");

    static constexpr bool met = true;
};

/// The conformity level of the drives: regular identification, as a stream.
inline constexpr std::uint8_t printed_conformity = 0x02;

} // namespace detail

namespace sim {

/// The vendor name of the drives.
inline constexpr literal maker{"Schneider Electric"};

/// The profile of a server with the functions and limits of a device and these objects; without function 43 the
/// objects are left out.
template <device_type Device>
[[nodiscard]] constexpr server_profile line_profile_with(device_objects const& objects) noexcept
{
    bool const tells = Device::functions.contains(function_code::encapsulated_interface);
    return {Device::functions, Device::limits,
            tells ? objects.with_conformity(detail::printed_conformity) : device_objects{}};
}

/// The profile of a device that identifies itself as its manual prints.
template <device_type Device> struct line_profile {
    static constexpr std::array<device_object, 3> objects{
        {{vendor_name, maker}, {product_code, Device::reference}, {major_minor_revision, "0201"}}};
    static constexpr server_profile value = line_profile_with<Device>(identity_of<objects>);
};

/// A drive on a line. Call `receive`, `sent` and `advance` as for a server; then send what `poll_transmit` returns.
template <device_type Device> class unit {
    static_assert(altivar::drive_check<Device>::passed);
    static_assert(detail::drive_needs<Device>::met);

public:
    /// A drive at this address, switched on at `power_on`, which identifies itself as its manual prints.
    constexpr unit(unit_id its_address, line_timing const& its_line, instant power_on) noexcept
        : unit{its_address, its_line, power_on, line_profile<Device>::value}
    {}

    /// Identifies itself otherwise than its manual prints; the profile must outlive the unit.
    constexpr unit(unit_id its_address, line_timing const& its_line, instant power_on,
                   server_profile const& its_profile) noexcept
        : node_{its_address, its_line, its_profile}, drive_{power_on, its_address.byte()}, line_{drive_.line()}
    {}

    constexpr void receive(byte_view bytes, instant now) noexcept
    {
        if (is_hearing()) {
            node_.receive(bytes, now);
        }
    }
    constexpr void receive_error(instant now) noexcept { node_.receive_error(now); }
    constexpr void sent(instant now) noexcept { node_.sent(now); }

    /// Lets time pass for the drive and its server, and serves a waiting request.
    constexpr void advance(instant now) noexcept
    {
        drive_.advance(now);
        node_.advance(now);
        if (node_.is_asked()) {
            drive_.note_contact();
            ++requests_;
            node_.serve(drive_, now);
        }
        // The response to the write that changed the address still has the old one.
        node_.listen_as(checked_unit(drive_.address()));
    }

    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return node_.poll_transmit(); }
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept { return node_.poll_deadline(); }

    /// The number of requests to it, including broadcasts.
    [[nodiscard]] constexpr std::uint32_t requests() const noexcept { return requests_; }

    [[nodiscard]] constexpr detail::simulated_drive<Device>& drive() noexcept { return drive_; }
    [[nodiscard]] constexpr detail::simulated_drive<Device> const& drive() const noexcept { return drive_; }

private:
    static constexpr std::optional<unit_id> checked_unit(std::uint16_t number) noexcept
    {
        auto const unit = unit_id::checked(number);
        return unit ? std::optional{*unit} : std::nullopt;
    }

    /// False while the drive is silent, and where its settings differ from those of the line.
    constexpr bool is_hearing() const noexcept { return not drive_.is_silent() and drive_.line() == line_; }

    server node_;
    detail::simulated_drive<Device> drive_;
    detail::line_setting line_; ///< when it was connected
    std::uint32_t requests_{0};
};

} // namespace sim
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
